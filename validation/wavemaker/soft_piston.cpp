#include "validation/wavemaker/soft_piston.hpp"

#include <cmath>
#include <numbers>

#include "seiche/exact/wavemaker.hpp"

namespace seiche::validation {

using exact::WavemakerTransient;

SoftPiston::SoftPiston(double frequency, double stroke, bool sudden)
    : frequency_(frequency), half_stroke_(stroke / 2), sudden_(sudden) {}

SoftPiston::Ramp SoftPiston::ramp(double t) const {
  const double rate = frequency_ / (2 * std::numbers::pi);
  const double z = rate * t;
  if (sudden_ || z >= 1) return {1, 0, 0};
  if (z <= 0) return {0, 0, 0};
  // The polynomial with r' = 140 z^3 (1 - z)^3.
  return {z * z * z * z * (35 + z * (-84 + z * (70 - 20 * z))), 140 * std::pow(z * (1 - z), 3) * rate,
          420 * std::pow(z * (1 - z), 2) * (1 - 2 * z) * rate * rate};
}

double SoftPiston::place(double t) const {
  return half_stroke_ * ramp(t).value * std::sin(frequency_ * t);
}

double SoftPiston::velocity(double t) const {
  const Ramp r = ramp(t);
  return half_stroke_ * (r.rate * std::sin(frequency_ * t) + r.value * frequency_ * std::cos(frequency_ * t));
}

double SoftPiston::acceleration(double t) const {
  const Ramp r = ramp(t);
  const double w = frequency_;
  return half_stroke_ * ((r.acceleration - r.value * w * w) * std::sin(w * t) + 2 * r.rate * w * std::cos(w * t));
}

std::vector<double> SoftPiston::elevation(double x, double interval, long samples, long parts) const {
  std::vector<double> all;
  if (sudden_) {
    const WavemakerTransient start(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{frequency_},
                                   2 * half_stroke_);
    for (long n = 1; n <= samples; ++n) all.push_back(start.elevation(x, static_cast<double>(n) * interval));
    return all;
  }
  // A frequency of zero: cos(slow t) is 1 to 1e-5 as long as the run lasts.
  constexpr double slow = 1e-4;
  const WavemakerTransient step(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{slow}, 2 / slow);
  const double dt = interval / static_cast<double>(parts);
  const auto count = static_cast<std::size_t>(samples * parts);
  std::vector<double> response{0};
  std::vector<double> push{0};
  for (std::size_t n = 1; n <= count; ++n) {
    response.push_back(step.elevation(x, static_cast<double>(n) * dt));
    push.push_back(acceleration(static_cast<double>(n) * dt));
  }
  // Trapezoidal rule: both factors vanish at one of the ends.
  for (auto n = static_cast<std::size_t>(parts); n <= count; n += static_cast<std::size_t>(parts)) {
    double sum = 0;
    for (std::size_t m = 1; m < n; ++m) sum += push[m] * response[n - m];
    all.push_back(sum * dt);
  }
  return all;
}

}  // namespace seiche::validation
