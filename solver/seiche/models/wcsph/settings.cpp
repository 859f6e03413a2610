#include "seiche/models/wcsph/settings.hpp"

#include <cmath>
#include <string_view>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {
namespace {

void validate_period(std::string_view name, double length) {
  if (!(std::isinf(length) && length > 0)) require_positive(name, length);
}

}  // namespace

KernelName kernel_named(std::string_view name) {
  using enum KernelName;
  return value_named<KernelName>("kernel", name, {{"cubic_spline", cubic_spline}, {"wendland_c2", wendland_c2}});
}

std::string_view name_of(KernelName kernel) {
  return kernel == KernelName::cubic_spline ? "cubic_spline" : "wendland_c2";
}

double sound_speed_for(double gravity, double height, double coefficient) {
  require_positive("gravity", gravity);
  require_positive("height", height);
  require_positive("coefficient", coefficient);
  return coefficient * std::sqrt(gravity * height);
}

void validate(const Settings& settings) {
  require_ranges(settings);
  std::visit([](const auto& viscosity) { require_ranges(viscosity); }, settings.viscosity);
  require_at_least("filter_every", settings.filter_every, 0);
  require_within("lanes", settings.lanes, 2, 8);
  validate_period("period.x", settings.period.x);
  validate_period("period.z", settings.period.z);
}

TaitFluid::TaitFluid(double density, double sound_speed) : density_(density), sound_speed_(sound_speed) {
  require_positive("density", density);
  require_positive("sound_speed", sound_speed);
  stiffness_ = density * sound_speed * sound_speed / exponent;
}

double TaitFluid::pressure(double density) const {
  return stiffness_ * (std::pow(density / density_, exponent) - 1);
}

double TaitFluid::density_at(double pressure) const {
  return density_ * std::pow(1 + pressure / stiffness_, 1 / exponent);
}

double TaitFluid::sound_speed(double density) const {
  return sound_speed_ * std::pow(density / density_, 0.5 * (exponent - 1));
}

double TaitFluid::elastic_energy(double density) const {
  const double s = density / density_;
  // The three terms cancel to (s-1)^2 near s = 1: the same with s = 1 + d, each bracket small by itself.
  const double d = s - 1;
  const double n = exponent - 1;
  return stiffness_ / density_ * (std::expm1(n * std::log1p(d)) / n - d / s);
}

double TaitFluid::hydrostatic_density(double gravity, double depth) const {
  require_finite("gravity", gravity);
  require_finite("depth", depth);
  const double base = 1 + density_ * gravity * depth / stiffness_;
  require_within("hydrostatic base 1 + rho_0 g depth/B", base, 0, 2);
  return density_ * std::pow(base, 1 / exponent);
}

}  // namespace seiche::wcsph
