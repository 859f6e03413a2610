#include "validation/instruments/manufactured/lagrangian_manufactured.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>

#include <boost/math/tools/roots.hpp>

#include "seiche/require.hpp"

namespace seiche::validation {

namespace sw = shallow_water;

LagrangianManufactured::LagrangianManufactured(double gravity, double depth, double length, double amplitude,
                                               double frequency)
    : gravity_(gravity), depth_(depth), length_(length), amplitude_(amplitude), frequency_(frequency) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("length", length);
  require_positive("frequency", frequency);
  wavenumber_ = 2 * std::numbers::pi / length;
  require_within("amplitude", amplitude, 0, 0.999 / wavenumber_);
}

double LagrangianManufactured::position(double label, double t) const {
  return label + amplitude_ * std::sin(wavenumber_ * label) * std::sin(frequency_ * t);
}

double LagrangianManufactured::label(double x, double t) const {
  require_within("x", x, 0, length_);
  require_finite("t", t);
  const double swing = amplitude_ * std::sin(frequency_ * t);
  const auto residual = [&](double s) {
    return std::pair(s + swing * std::sin(wavenumber_ * s) - x, 1 + swing * wavenumber_ * std::cos(wavenumber_ * s));
  };
  std::uintmax_t iterations = 200;
  const double reach = std::abs(swing);
  const double low = std::max(0.0, x - reach);
  const double high = std::min(length_, x + reach);
  if (!(high > low)) return x;
  // Newton's last step doubles the digits, so 50 of the 53 bits asked for arrive as all.
  return boost::math::tools::newton_raphson_iterate(residual, x, low, high, 50, iterations);
}

sw::State LagrangianManufactured::state_of(double label, double t) const {
  const double jacobian = 1 + amplitude_ * wavenumber_ * std::cos(wavenumber_ * label) * std::sin(frequency_ * t);
  return {depth_ / jacobian, amplitude_ * frequency_ * std::sin(wavenumber_ * label) * std::cos(frequency_ * t)};
}

double LagrangianManufactured::source_of(double label, double t) const {
  const double wave = amplitude_ * std::sin(wavenumber_ * label) * std::sin(frequency_ * t);
  const double jacobian = 1 + amplitude_ * wavenumber_ * std::cos(wavenumber_ * label) * std::sin(frequency_ * t);
  const double jacobian_slope = -wavenumber_ * wavenumber_ * wave;
  return -frequency_ * frequency_ * wave - gravity_ * depth_ * jacobian_slope / (jacobian * jacobian * jacobian);
}

sw::State LagrangianManufactured::at(double x, double t) const {
  return state_of(label(x, t), t);
}
double LagrangianManufactured::source(double x, double t) const {
  return source_of(label(x, t), t);
}

double LagrangianManufactured::mean_velocity(double left_label, double right_label, double t) const {
  // Mean of sin(k s): sin(k centre) sinc(k half-width), free of cancellation for narrow particles.
  const double half = 0.5 * wavenumber_ * (right_label - left_label);
  const double centre = 0.5 * wavenumber_ * (right_label + left_label);
  const double sinc = half == 0 ? 1.0 : std::sin(half) / half;
  return amplitude_ * frequency_ * std::cos(frequency_ * t) * std::sin(centre) * sinc;
}

}  // namespace seiche::validation
