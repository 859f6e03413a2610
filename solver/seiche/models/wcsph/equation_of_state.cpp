#include "seiche/models/wcsph/equation_of_state.hpp"

#include <cmath>

#include "seiche/require.hpp"

namespace seiche::wcsph {

TaitFluid::TaitFluid(double density, double sound_speed, double exponent)
    : density_(density), sound_speed_(sound_speed), exponent_(exponent) {
  require_positive("density", density);
  require_positive("sound_speed", sound_speed);
  require_within("exponent", exponent, 1, 100);
  stiffness_ = density * sound_speed * sound_speed / exponent;
}

double TaitFluid::pressure(double density) const {
  return stiffness_ * (std::pow(density / density_, exponent_) - 1);
}

double TaitFluid::density_at(double pressure) const {
  return density_ * std::pow(1 + pressure / stiffness_, 1 / exponent_);
}

double TaitFluid::sound_speed(double density) const {
  return sound_speed_ * std::pow(density / density_, 0.5 * (exponent_ - 1));
}

double TaitFluid::elastic_energy(double density) const {
  const double s = density / density_;
  if (exponent_ == 1) return stiffness_ / density_ * (std::log(s) + 1 / s - 1);
  // The three terms cancel to (s-1)^2 near s = 1: the same with s = 1 + d, each bracket small by itself.
  const double d = s - 1;
  const double n = exponent_ - 1;
  return stiffness_ / density_ * (std::expm1(n * std::log1p(d)) / n - d / s);
}

double TaitFluid::hydrostatic_density(double gravity, double depth) const {
  require_finite("gravity", gravity);
  require_finite("depth", depth);
  const double base = 1 + density_ * gravity * depth / stiffness_;
  require_within("hydrostatic base 1 + rho_0 g depth/B", base, 0, 2);
  return density_ * std::pow(base, 1 / exponent_);
}

}  // namespace seiche::wcsph
