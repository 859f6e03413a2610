#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace seiche::exact {

/// Integral of a horizontal velocity u(y) over the section bottom <= y <= top under a crest, on panels that shrink
/// geometrically towards the crest: under a steep one the velocity varies over its distance from the limiting corner.
template <class HorizontalVelocity>
double section_flux(const HorizontalVelocity& u, double bottom, double top) {
  constexpr int panels = 14;
  constexpr double ratio = 0.4;
  const double height = top - bottom;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double far = height * std::pow(ratio, panel);
    const double near = panel + 1 < panels ? ratio * far : 0;
    sum +=
        boost::math::quadrature::gauss<double, 20>::integrate([&](double depth) { return u(top - depth); }, near, far);
  }
  return sum;
}

}  // namespace seiche::exact
