/// What manufactured solutions are tested by: derivatives by differences, which know nothing of their formulas.
#pragma once

#include <boost/math/differentiation/finite_difference.hpp>

namespace seiche::validation {

/// f' by central differences of eighth order.
template <class Function>
double difference(const Function& f, double at = 0) {
  return boost::math::differentiation::finite_difference_derivative<Function, double, 8>(f, at);
}

}  // namespace seiche::validation
