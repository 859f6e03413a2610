#include "seiche/spelling.hpp"

#include <algorithm>
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

}  // namespace

std::string did_you_mean(std::string_view mistyped, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edits(a, mistyped) < edits(b, mistyped);
  });
  const std::size_t most = std::max<std::size_t>(1, (mistyped.size() + 1) / 3);
  return nearest == known.end() || edits(*nearest, mistyped) > most ? ":" : ": did you mean " + *nearest + "?";
}

}  // namespace seiche
