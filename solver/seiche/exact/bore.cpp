#include "seiche/exact/bore.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

double checked_behind(double ahead, double behind) {
  require_positive("depth ahead of the jump", ahead);
  require_positive("depth behind the jump", behind);
  if (!(behind > ahead)) {
    throw std::invalid_argument(fmt::format(
        "depth behind the jump = {:.17g} is out of range: must exceed the depth ahead = {:g} (a jump loses energy)",
        behind, ahead));
  }
  return behind;
}

double energy_loss(double gravity, double flux, double h0, double h1) {
  return flux * gravity * std::pow(h1 - h0, 3) / (4 * h0 * h1);
}

}  // namespace

Bore::Bore(double gravity, double ahead, double behind, double ahead_velocity, double start)
    : gravity_(gravity), ahead_{ahead, ahead_velocity}, start_(start) {
  require_positive("gravity", gravity);
  require_finite("velocity ahead of the bore", ahead_velocity);
  require_finite("start", start);
  behind_.depth = checked_behind(ahead, behind);
  flux_ = sw::jump_mass_flux(gravity, ahead, behind);
  behind_.velocity = ahead_velocity + sw::velocity_change(gravity, behind, ahead);
}

Bore Bore::from_velocity(double gravity, double behind, double behind_velocity, double start) {
  require_positive("gravity", gravity);
  require_positive("depth behind the jump", behind);
  require_positive("velocity behind the jump", behind_velocity);
  // u1 falls from infinity to 0 as the depth ahead grows from 0 to h1; (h1/h0)(g h1/2) > u1^2 bounds the root below
  // within a factor that the bracket covers by halving.
  const auto excess = [&](double ahead) { return sw::velocity_change(gravity, behind, ahead) - behind_velocity; };
  double low = behind;
  do {
    low *= 0.5;
  } while (excess(low) < 0 && low > 1e-300);
  std::uintmax_t iterations = 200;
  const auto [a, b] =
      boost::math::tools::toms748_solve(excess, low, behind, boost::math::tools::eps_tolerance<double>(53), iterations);
  return {gravity, std::abs(excess(a)) < std::abs(excess(b)) ? a : b, behind, 0, start};
}

sw::State Bore::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  return x < position(t) ? behind_ : ahead_;
}

double Bore::energy_loss_rate() const {
  return energy_loss(gravity_, flux_, ahead_.depth, behind_.depth);
}

Provenance Bore::provenance() {
  return {
      "Stoker, Water Waves (1957), sections 10.6-10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water "
      "waves by the particle method, formula (11)",
      "a = sqrt(g h1 (h1 + h0)/(2 h0)), u1 = a (1 - h0/h1), energy loss g a (h1 - h0)^3/(4 h1)"};
}

StationaryJump::StationaryJump(double gravity, double shallow, double deep, double position, Flow flow)
    : gravity_(gravity), position_(position), flow_(flow) {
  require_positive("gravity", gravity);
  require_finite("position", position);
  checked_behind(shallow, deep);
  flux_ = sw::jump_mass_flux(gravity, shallow, deep);
  const double sign = flow == Flow::rightwards ? 1 : -1;
  upstream_ = {shallow, sign * flux_ / shallow};
  downstream_ = {deep, sign * flux_ / deep};
}

sw::State StationaryJump::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  return (x < position_) == (flow_ == Flow::rightwards) ? upstream_ : downstream_;
}

std::vector<double> StationaryJump::breakpoints(double /*t*/) const {
  return {position_};
}

double StationaryJump::energy_loss_rate() const {
  return energy_loss(gravity_, flux_, upstream_.depth, downstream_.depth);
}

Provenance StationaryJump::provenance() {
  return {
      "Stoker, Water Waves (1957), section 10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by "
      "the particle method",
      "u0 = sqrt(g h1 (h1 + h0)/(2 h0)), u1 = u0 h0/h1"};
}

}  // namespace seiche::exact
