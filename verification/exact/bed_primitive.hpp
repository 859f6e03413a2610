/// The primitive of a bed against the bed's own elevation.
#pragma once

#include <string>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// Claims that over each hundredth of the bed the primitive grows by the integral of the elevation. The elevation must
/// be smooth inside every hundredth.
///
/// @param height  of the bed at its highest or lowest
inline void claim_bed_primitive(Check& check, const std::string& id, const Bed& bed, double start, double end,
                                double height) {
  constexpr int panels = 100;
  const double width = (end - start) / panels;
  Worst defect;
  for (int k = 0; k < panels; ++k) {
    const double a = start + k * width;
    const double area = boost::math::quadrature::gauss<double, 15>::integrate(bed.elevation, a, a + width);
    defect.add(bed.primitive(a + width) - bed.primitive(a) - area);
  }
  check.holds(id + ": The primitive of the bed grows by the integral of its elevation.", {defect.value()},
              evidence::Roundoff{1000, height * (end - start),
                                 "primitives up to the height of the bed times its length, summed from up to "
                                 "64 panels of 15 points"});
}

}  // namespace seiche::verification
