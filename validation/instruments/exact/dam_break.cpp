#include "validation/instruments/exact/dam_break.hpp"

#include <cmath>
#include <numbers>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

double below(double downstream, double upstream) {
  require_positive("upstream", upstream);
  require_positive("downstream", downstream);
  require_that(downstream < upstream, "downstream = {:.17g} is out of range: must be below upstream = {:g}", downstream,
               upstream);
  return downstream;
}

}  // namespace

Ritter::Ritter(double gravity, double depth, double dam)
    : Riemann(gravity, {(require_positive("depth", depth), depth), 0}, {0, 0}, dam) {}

Stoker::Stoker(double gravity, double upstream, double downstream, double dam)
    : Riemann(gravity, {upstream, 0}, {below(downstream, upstream), 0}, dam) {}

double Stoker::discharge_at_dam() const {
  const double h1 = left().depth;
  if (right().depth <= critical_ratio() * h1) return 8.0 / 27.0 * h1 * sw::celerity(gravity(), h1);
  return plateau().depth * plateau().velocity;
}

double Stoker::critical_ratio() {
  const double root = std::sqrt(10.0);
  const double angle = (std::acos(1 / (10 * root)) + 4 * std::numbers::pi) / 3;
  return 4.0 / 9.0 * (1.0 / 3.0 + 2 * root / 3 * std::cos(angle));
}

StationaryJump::StationaryJump(double gravity, double shallow, double deep, double position)
    : bore_(gravity, shallow, deep), position_(position) {
  require_finite("position", position);
}

sw::State StationaryJump::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  return x < position_ ? upstream() : downstream();
}

}  // namespace seiche::exact
