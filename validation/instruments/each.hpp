/// One number of each of several things.
#pragma once

#include <functional>
#include <vector>

namespace seiche::validation {

/// @param get  a function of one of the things, or a pointer to a member
template <class Things, class Get>
std::vector<double> each(const Things& things, Get get) {
  std::vector<double> numbers;
  for (const auto& thing : things) numbers.push_back(std::invoke(get, thing));
  return numbers;
}

}  // namespace seiche::validation
