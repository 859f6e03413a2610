/// Roots to round-off within a bracket (Alefeld, Potra and Shi, algorithm 748). For sources: it needs Boost.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace seiche::exact {

/// The last bracket of a root of f, which changes its sign between `from` and `to`.
template <class Function>
std::pair<double, double> last_bracket(const Function& f, double from, double to) {
  std::uintmax_t iterations = 200;
  return boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(), iterations);
}

/// Its middle.
template <class Function>
double root(const Function& f, double from, double to) {
  const auto [low, high] = last_bracket(f, from, to);
  return 0.5 * (low + high);
}

/// Its end with the smaller residual.
template <class Function>
double root_at_end(const Function& f, double from, double to) {
  const auto [low, high] = last_bracket(f, from, to);
  return std::abs(f(low)) < std::abs(f(high)) ? low : high;
}

}  // namespace seiche::exact
