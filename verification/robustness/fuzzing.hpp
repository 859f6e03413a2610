/// Inputs that are damaged at random, the same in every run, and what a reader makes of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ranges>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "seiche/wording.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// Marsaglia's xorshift64: the same inputs in every run.
class Xorshift {
 public:
  explicit Xorshift(std::uint64_t seed) : state_(seed) {}
  /// Uniform in [0, bound).
  std::size_t below(std::size_t bound) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>(state_ % bound);
  }

 private:
  std::uint64_t state_;
};

/// Tokens that readers stumble over more often than over random bytes.
inline const std::vector<std::string> awkward = [] {
  using namespace std::string_view_literals;
  constexpr std::string_view tokens =
      "nan inf - 1e999 [ ] \" ''' ,, \r \n # = { } 0x 1e + . \\u \t \xff \xEF\xBB\xBF \0 99999999999999999999 [[a]] "
      "a.b.c"sv;
  std::vector<std::string> all;
  for (const auto token : std::views::split(tokens, ' ')) all.emplace_back(token.begin(), token.end());
  return all;
}();

/// One to six changes: bytes flipped, replaced, removed, put in, cut off, or a piece of another input spliced in.
inline std::string mutated(std::string bytes, const std::vector<std::string>& others, Xorshift& random) {
  for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
    if (bytes.empty()) bytes = others[random.below(others.size())];
    const std::size_t place = random.below(bytes.size());
    const std::size_t length = std::min(bytes.size() - place, 1 + random.below(16));
    switch (random.below(8)) {
      case 0:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.below(8)));
        break;
      case 1:
        bytes[place] = static_cast<char>(random.below(256));
        break;
      case 2:
        bytes.erase(place, length);
        break;
      case 3:
        bytes.insert(place, 1 + random.below(8), static_cast<char>(random.below(256)));
        break;
      case 4:
        bytes.insert(place, awkward[random.below(awkward.size())]);
        break;
      case 5:
        bytes.insert(place, bytes.substr(random.below(bytes.size()), length * 4));
        break;
      case 6: {
        const std::string& other = others[random.below(others.size())];
        bytes = bytes.substr(0, place) + other.substr(random.below(other.size()));
        break;
      }
      default:
        if (random.below(4) == 0) bytes.resize(place);
    }
  }
  return bytes;
}

/// What became of the inputs of one reader.
struct Tally {
  long accepted = 0, refused = 0;
  long misbehaved = 0;  ///< another exception, a message of several lines, or an empty one
  long crashes = 0;     ///< of a child process
  Largest slowest;      ///< [s]
  std::string example;
};

/// How many times the inputs of a usual run: SEICHE_FUZZ, as `ci/checks/fuzz` sets it.
inline long fuzz_factor() {
  const char* chosen = std::getenv("SEICHE_FUZZ");  // NOLINT(concurrency-mt-unsafe): tests are single-threaded
  const long factor = chosen == nullptr ? 1 : std::atol(chosen);
  return std::max(factor, 1L);
}

/// Other inputs than those of a usual run where SEICHE_FUZZ_SEED is not 0, as `ci/checks/fuzz` sets it.
inline std::uint64_t fuzz_seed(std::uint64_t usual) {
  const char* chosen = std::getenv("SEICHE_FUZZ_SEED");  // NOLINT(concurrency-mt-unsafe): tests are single-threaded
  const std::uint64_t other = chosen == nullptr ? 0 : std::strtoull(chosen, nullptr, 10);
  const std::uint64_t seed = usual ^ (other * 0x9E3779B97F4A7C15U);
  return seed == 0 ? usual : seed;  // the generator would stay at 0
}

/// Damages the valid inputs and reads them. A reader may throw std::invalid_argument or std::runtime_error.
/// @param count  of inputs, in a usual run
template <class Reader>
Tally fuzz(const std::vector<std::string>& valid, long count, std::uint64_t seed, Reader read) {
  Xorshift random(fuzz_seed(seed));
  Tally tally;
  for (long k = 0; k < count * fuzz_factor(); ++k) {
    const std::string input = mutated(valid[random.below(valid.size())], valid, random);
    const auto begin = std::chrono::steady_clock::now();
    std::string message = "ok";
    bool expected = true;
    try {
      read(input);
      ++tally.accepted;
    } catch (const std::exception& failure) {
      message = failure.what();
      expected = dynamic_cast<const std::invalid_argument*>(&failure) != nullptr ||
                 dynamic_cast<const std::runtime_error*>(&failure) != nullptr;
      if (expected) ++tally.refused;
    }
    const bool one_line = !message.empty() && std::none_of(message.begin(), message.end(),
                                                           [](char c) { return (c >= 0 && c < ' ') || c == 0x7f; });
    if (!expected || !one_line) {
      ++tally.misbehaved;
      tally.example = fmt::format("input {}: {}: {}", k, printable(input).substr(0, 2000), message);
    }
    if (message.find("child process") != std::string::npos) ++tally.crashes;
    tally.slowest.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return tally;
}

}  // namespace seiche::verification
