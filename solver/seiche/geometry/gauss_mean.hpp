/// Means by Gauss's rule. For sources, not for headers: it needs Boost.
#pragma once

#include <boost/math/quadrature/gauss.hpp>

namespace seiche {

/// Mean of f over [from, to], in either order: exact to round-off for what a polynomial of degree 19 is in effect
/// there.
template <class Function>
double gauss_mean(const Function& f, double from, double to) {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  return 0.5 *
         boost::math::quadrature::gauss<double, 10>::integrate([&](double s) { return f(middle + half * s); }, -1, 1);
}

}  // namespace seiche
