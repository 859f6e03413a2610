/// Numbers of several things: one of each, or extremes and means over all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <ranges>
#include <vector>

namespace seiche::validation {

/// @param get  a function of one of the things, or a pointer to a member
template <class Things, class Get>
std::vector<double> each(Things&& things,
                         Get get) {  // NOLINT(cppcoreguidelines-missing-std-forward): views are not const
  std::vector<double> numbers;
  for (const auto& thing : things) numbers.push_back(std::invoke(get, thing));
  return numbers;
}

/// 0, 1, ... of what several things that lie side by side are counted by.
inline auto indices(std::size_t count) {
  return std::views::iota(std::size_t{0}, count);
}

/// Entry by entry.
inline std::vector<double> quotients(std::vector<double> numbers, const std::vector<double>& by) {
  std::ranges::transform(numbers, by, numbers.begin(), std::divides{});
  return numbers;
}

/// Samples of all: over<Worst>(waves, &Wave::error, &Wave::height) also keeps at which height the error is worst.
template <class Samples, class Things, class... Get>
Samples over(const Things& things, Get... get) {
  Samples samples;
  for (const auto& thing : things) samples.add(std::invoke(get, thing)...);
  return samples;
}

}  // namespace seiche::validation
