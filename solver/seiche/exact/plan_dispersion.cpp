#include "seiche/exact/plan_dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/dispersion_identities.hpp"
#include "seiche/exact/frank_dispersion.hpp"
#include "seiche/exact/plan_symbol.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<PlanDispersion>);

namespace {

/// The law for one direction, as a function of |k|.
struct Ray {
  const PlanDispersion& law;
  double cosine, sine;

  [[nodiscard]] double frequency(double k) const { return law.frequency(k * cosine, k * sine); }
  [[nodiscard]] double group_speed(double k) const {
    const auto velocity = law.group_velocity(k * cosine, k * sine);
    return velocity.x * cosine + velocity.y * sine;
  }
};

}  // namespace

PlanDispersion::PlanDispersion(double gravity, double depth, double spacing_x, double spacing_y, double alpha)
    : gravity_(gravity), depth_(depth), spacing_x_(spacing_x), spacing_y_(spacing_y), alpha_(alpha) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("spacing_x", spacing_x);
  require_positive("spacing_y", spacing_y);
  require_positive("alpha", alpha);
}

double PlanDispersion::frequency(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  const double slope = depth_ * symbol.gradient;
  return slope * std::sqrt(gravity_ / depth_ * symbol.potential / (symbol.mean * symbol.mean + alpha_ * slope * slope));
}

double PlanDispersion::phase_speed(double kx, double ky) const {
  return frequency(kx, ky) / std::hypot(kx, ky);
}

PlanDispersion::Vector PlanDispersion::group_velocity(double kx, double ky) const {
  const double omega = frequency(kx, ky);
  const double tx = 2 / spacing_x_ * std::tan(0.5 * kx * spacing_x_);
  const double ty = 2 / spacing_y_ * std::tan(0.5 * ky * spacing_y_);
  const double k2 = tx * tx + ty * ty;
  const double inertia = k2 * (1 + alpha_ * depth_ * depth_ * k2);
  // d ln(omega)/dk_i = dG/(2G) + T_i dT_i/(K^2 (1 + alpha H^2 K^2))
  const auto along = [&](double t, double k, double h) {
    const double potential = -0.5 * h * std::sin(k * h) / (2 + std::cos(k * h));
    return omega * (potential + t * (1 + 0.25 * h * h * t * t) / inertia);
  };
  return {along(tx, kx, spacing_x_), along(ty, ky, spacing_y_)};
}

RationalDispersion PlanDispersion::limit() const {
  return RationalDispersion::green_naghdi(gravity_, depth_, alpha_);
}

double PlanDispersion::frequency_error(double wavenumber, double direction) const {
  require_positive("wavenumber", wavenumber);
  require_finite("direction", direction);
  return frequency(wavenumber * std::cos(direction), wavenumber * std::sin(direction)) / limit().frequency(wavenumber) -
         1;
}

double PlanDispersion::leading_error(double wavenumber, double direction) const {
  require_positive("wavenumber", wavenumber);
  require_finite("direction", direction);
  const double c2 = std::pow(std::cos(direction), 2);
  const double s2 = std::pow(std::sin(direction), 2);
  const double kh = wavenumber * depth_;
  const double potential = c2 * spacing_x_ * spacing_x_ + s2 * spacing_y_ * spacing_y_;
  const double inertia =
      (c2 * c2 * spacing_x_ * spacing_x_ + s2 * s2 * spacing_y_ * spacing_y_) / (1 + alpha_ * kh * kh);
  return wavenumber * wavenumber / 12 * (inertia - potential);
}

double PlanDispersion::frequency_bound() const {
  return std::sqrt(gravity_ / (alpha_ * depth_));
}

Provenance PlanDispersion::provenance() {
  return {
      "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13), and section 4.2; closed form in "
      "plan derived from the linearised cells",
      "omega^2 = g H G K^2/(1 + alpha H^2 K^2), K^2 = sum ((2/h_i) tan(k_i h_i/2))^2, "
      "G = product (2 + cos k_i h_i)/3"};
}

double PlanDispersion::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest PlanDispersion::self_test() const {
  const double shortest_x = std::numbers::pi / spacing_x_;
  const double shortest_y = std::numbers::pi / spacing_y_;
  const FrankDispersion chain(gravity_, depth_, spacing_x_, {.alpha = alpha_, .beta = 1.0 / 3, .gamma = 0});
  const PlanDispersion turned(gravity_, depth_, spacing_y_, spacing_x_, alpha_);
  Worst chain_defect;
  Worst turned_defect;
  Largest group_defect;
  constexpr int waves = 16;
  for (int i = 1; i < waves; ++i) {
    const double kx = shortest_x * i / waves;
    chain_defect.add(frequency(kx, 0) / chain.frequency(kx) - 1);
    for (int j = 0; j < waves; ++j) {
      const double ky = shortest_y * j / waves;
      turned_defect.add(frequency(kx, -ky) / turned.frequency(ky, kx) - 1);
    }
  }
  Worst longest_defect;
  const double longest = 1e-9 / std::max({depth_, spacing_x_, spacing_y_});
  constexpr int directions = 8;
  for (int i = 0; i <= directions; ++i) {
    const double direction = 0.5 * std::numbers::pi * i / directions;
    const Ray ray{*this, std::cos(direction), std::sin(direction)};
    const double edge = 1 / std::max(ray.cosine / shortest_x, ray.sine / shortest_y);
    group_defect.add(group_speed_identity(ray, std::min(0.9 * edge, 6 / depth_)).defect);
    const double speed = phase_speed(longest * ray.cosine, longest * ray.sine);
    longest_defect.add(speed / std::sqrt(gravity_ * depth_) - 1);
  }
  // Algebraic at k_i h_i = pi/2: T_i = 2/h_i, G = 4/9.
  const double k2 = 4 / (spacing_x_ * spacing_x_) + 4 / (spacing_y_ * spacing_y_);
  const double middle = std::sqrt(4 * gravity_ * depth_ * k2 / (9 * (1 + alpha_ * depth_ * depth_ * k2)));
  return {
      {"along an axis: formula (13)", chain_defect.value(), 2e-14,
       "90 ulp: 40 roundings, the shortest of the waves makes a rounding of the phase ten of the tangent"},
      {"mirrored and with the axes exchanged: the same", turned_defect.value(), 4e-15, "18 ulp for as many roundings"},
      {"integral of the group velocity along rays = frequency", group_defect.value(), 2e-14,
       "30-point Gauss on eighths of the ray resolves the law to round-off; 90 roundings"},
      {"frequency at k_i h_i = pi/2 in closed form",
       std::abs(frequency(0.5 * shortest_x, 0.5 * shortest_y) / middle - 1), 1e-14, "45 ulp for 25 roundings"},
      {"shortest waves in x: omega^2 = g (2 + cos k2 h2)/(9 alpha H)",
       std::abs(frequency(shortest_x, 0.5 * shortest_y) / (frequency_bound() * std::numbers::sqrt2 / 3) - 1),
       4e-15 + std::pow(std::numeric_limits<double>::epsilon() * spacing_x_ / depth_, 2) / alpha_,
       "18 ulp for as many roundings; the law is stationary there in 1/(K H), which is 0 to a rounding of pi h1/H"},
      {"long waves in every direction: omega = k sqrt(g H)", longest_defect.value(), 4e-15,
       "18 ulp for as many roundings; the next term of the law is 1e-18"}};
}

}  // namespace seiche::exact
