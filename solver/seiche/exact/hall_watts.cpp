#include "seiche/exact/hall_watts.hpp"

#include <cmath>
#include <numbers>

#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

}  // namespace

HallWatts::HallWatts(double depth, double slope) : depth_(depth) {
  require_positive("depth", depth);
  require_within("slope", slope, tangent(5) * (1 - 1e-12), 1 + 1e-12);
  const bool steep = slope >= tangent(12);
  coefficient_ = steep ? 3.05 * std::pow(slope, -0.13) : 11 * std::pow(slope, 0.67);
  exponent_ = steep ? 1.15 * std::pow(slope, 0.02) : 1.9 * std::pow(slope, 0.35);
}

double HallWatts::runup(double amplitude) const {
  require_positive("amplitude", amplitude);
  return depth_ * coefficient_ * std::pow(amplitude / depth_, exponent_);
}

Provenance HallWatts::provenance() {
  return {
      "Hall and Watts, Laboratory investigation of the vertical rise of solitary waves on impermeable slopes, Beach "
      "Erosion Board Tech. Memo. 33 (1953), as quoted by Synolakis, J. Fluid Mech. 185 (1987) 523",
      "R = 3.05 S^-0.13 a^(1.15 S^0.02), 12 to 45 deg; R = 11 S^0.67 a^(1.9 S^0.35), 5 to 12 deg"};
}

double HallWatts::uncertainty() const {
  return 1e-15;
}

SelfTest HallWatts::self_test() const {
  const double low = runup(0.1 * depth_);
  const double high = runup(0.4 * depth_);
  return {{"R is a power of a: R(a) R(4 a) = R(2 a)^2", std::abs(low * high / std::pow(runup(0.2 * depth_), 2) - 1),
           4e-15, "five powers of one rounding each and four products"}};
}

static_assert(ReferenceSolution<HallWatts>);

}  // namespace seiche::exact
