#include "seiche/exact/frank_dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/dispersion_identities.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<FrankDispersion>);

FrankDispersion::FrankDispersion(double gravity, double depth, double spacing, Parameters parameters)
    : gravity_(gravity), depth_(depth), spacing_(spacing), parameters_(parameters) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("spacing", spacing);
  require_positive("alpha", parameters.alpha);
  require_finite("beta", parameters.beta);
  require_finite("gamma", parameters.gamma);
  // The potential energy is linear in cos k s: positive at k s = pi is positive everywhere.
  const double h = spacing / depth;
  require_positive("1 - 2 beta + 4 gamma (depth/spacing)^2", 1 - 2 * parameters.beta + 4 * parameters.gamma / (h * h));
}

FrankDispersion FrankDispersion::tuned(double gravity, double depth, double spacing, double time_step) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("spacing", spacing);
  require_not_negative("time_step", time_step);
  const double h2 = spacing * spacing / (depth * depth);
  const double tau2 = time_step * time_step * gravity / depth;
  // Coefficients that nu must have in nu = kappa^2 (1 + c1 kappa^2 + c2 kappa^4) so that Omega is Airy's.
  const double c1 = -1.0 / 3 - tau2 / 12;
  const double c2 = 2.0 / 15 - c1 * tau2 / 6 - tau2 * tau2 / 90;
  const double gamma = (c2 - 7 * h2 * h2 / 720 - c1 * h2 / 6 - c1 * c1) / (-c1 - h2 / 12);
  return {gravity, depth, spacing, {.alpha = gamma - c1, .beta = 1.0 / 3, .gamma = gamma}};
}

void FrankDispersion::require_resolved(double k) const {
  require_positive("wavenumber", k);
  if (!(k * spacing_ < std::numbers::pi)) {
    throw std::invalid_argument(fmt::format(
        "wavenumber = {:.17g} is out of range: must be below pi/spacing = {:g}, the shortest wave that markers resolve",
        k, std::numbers::pi / spacing_));
  }
}

double FrankDispersion::phase_speed(double k) const {
  require_resolved(k);
  const auto& [alpha, beta, gamma] = parameters_;
  const double h = spacing_ / depth_;
  const double kappa = k * depth_;
  const double sine = std::sin(0.5 * kappa * h);
  const double slope = 2 * sine / h;
  const double rise = 2 * std::tan(0.5 * kappa * h) / (h * kappa);  // -> 1 for long waves
  const double potential = 1 - 2 * beta * sine * sine + gamma * slope * slope;
  const double inertia = 1 + alpha * rise * rise * kappa * kappa;
  return rise * std::sqrt(gravity_ * depth_ * potential / inertia);
}

double FrankDispersion::frequency(double k) const {
  return k * phase_speed(k);
}

double FrankDispersion::group_speed(double k) const {
  const double omega = frequency(k);
  const auto& [alpha, beta, gamma] = parameters_;
  const double h = spacing_ / depth_;
  const double angle = k * spacing_;
  const double sine = std::sin(0.5 * angle);
  const double t = 2 * std::tan(0.5 * angle) / h;
  const double potential = 1 - 2 * beta * sine * sine + 4 * gamma * sine * sine / (h * h);
  const double inertia = 1 + alpha * t * t;
  // nu = potential t^2/inertia, dt/dkappa = 1 + (h t/2)^2
  const double potential_slope = (2 * gamma / h - beta * h) * std::sin(angle);
  const double t_slope = 1 + 0.25 * h * h * t * t;
  const double nu_slope = potential_slope * t * t / inertia + potential * 2 * t * t_slope / (inertia * inertia);
  return 0.5 * gravity_ * nu_slope / omega;
}

RationalDispersion FrankDispersion::limit() const {
  return {gravity_, depth_, parameters_.gamma, parameters_.alpha};
}

Provenance FrankDispersion::provenance() {
  return {"Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13); general beta, gamma derived",
          "omega^2 = (g/H) (1 - beta (1 - cos ks) + 4 gamma sin^2(ks/2)/h^2) 4 t^2/(4 alpha t^2 + h^2), "
          "t = tan(ks/2), h = s/H"};
}

double FrankDispersion::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest FrankDispersion::self_test() const {
  SelfTest identities{group_speed_identity(*this, std::min(0.9 * std::numbers::pi / spacing_, 6 / depth_))};
  // The frequency of the middle wave, k s = pi/2, is algebraic.
  const double h2 = spacing_ * spacing_ / (depth_ * depth_);
  const double nu = (1 - parameters_.beta + 2 * parameters_.gamma / h2) * 4 / (4 * parameters_.alpha + h2);
  const double omega = frequency(0.5 * std::numbers::pi / spacing_);
  identities.push_back({"frequency at k s = pi/2 in closed form",
                        std::abs(omega * omega * depth_ / (gravity_ * nu) - 1), 1e-14,
                        "45 ulp for 25 roundings, squared"});
  return identities;
}

double discrete_frequency(double omega, double time_step, TimeScheme scheme) {
  require_positive("frequency", omega);
  require_positive("time_step", time_step);
  const double half = 0.5 * omega * time_step;
  if (scheme == TimeScheme::conservative) return 2 * std::atan(half) / time_step;
  if (!(half <= 1)) {
    throw std::invalid_argument(fmt::format(
        "time_step = {:.17g} is out of range: the one-step scheme needs frequency * time_step <= 2, here {:g}",
        time_step, omega * time_step));
  }
  return 2 * std::asin(half) / time_step;
}

}  // namespace seiche::exact
