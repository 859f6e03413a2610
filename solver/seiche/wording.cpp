#include "seiche/wording.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace seiche {
namespace {

/// Number of single-letter edits between two words (Levenshtein distance).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// A character and the bytes that spell it; of no bytes where they spell none.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

/// The character that a text begins with, as RFC 3629 (section 4) spells it: the shortest way, no surrogates.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t bytes = byte(0) < 0xc0 ? 0 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : byte(0) < 0xf8 ? 4 : 0;
  if (bytes == 0 || text.size() < bytes) return {};
  std::uint32_t code = byte(0) & (0x7fU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xc0U) != 0x80) return {};
    code = code << 6 | (byte(k) & 0x3fU);
  }
  constexpr std::uint32_t smallest[]{0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < smallest[bytes - 2] || code > 0x10ffff || surrogate) return {};
  return {code, bytes};
}

bool shows(std::uint32_t code) {
  const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool turns = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !control && !turns;
}

}  // namespace

std::string did_you_mean(std::string_view mistyped, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edits(a, mistyped) < edits(b, mistyped);
  });
  const std::size_t most = std::max<std::size_t>(1, (mistyped.size() + 1) / 3);
  return nearest == known.end() || edits(*nearest, mistyped) > most ? ":" : ": did you mean " + *nearest + "?";
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character one = first_of(text);
    if (one.bytes > 0 && shows(one.code)) {
      shown.append(text.substr(0, one.bytes));
    } else {
      shown.push_back('?');
    }
    text.remove_prefix(one.bytes == 0 ? 1 : one.bytes);
  }
  return shown;
}

}  // namespace seiche
