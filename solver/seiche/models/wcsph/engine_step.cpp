#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/density_filter.hpp"
#include "seiche/models/wcsph/engine.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// Densities within these, over rho_0, are a run that goes on.
constexpr double least_density = 0.5;
constexpr double greatest_density = 1.5;
/// Particles that are updated together.
constexpr std::size_t chunk = 2048;

SEICHE_SIMD_CLONES void add_scaled(const double* value, const double* rate, double tau, std::size_t first,
                                   std::size_t last, double* sum) {
  for (std::size_t i = first; i < last; ++i) sum[i] = value[i] + tau * rate[i];
}

struct Survey {
  bool bad = false;
  double speed2 = 0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0;
};

/// Comparisons that NaN fails, so that it counts as bad.
SEICHE_SIMD_CLONES Survey survey(const State& state, std::size_t first, std::size_t last, double lowest,
                                 double highest) {
  constexpr double largest = std::numeric_limits<double>::max();
  const double *x = state.x.data(), *z = state.z.data(), *u = state.u.data(), *w = state.w.data(),
               *density = state.density.data();
  Survey found;
  std::int64_t good = -1;
  for (std::size_t i = first; i < last; ++i) {
    const double speed2 = u[i] * u[i] + w[i] * w[i];
    const bool fine = (density[i] >= lowest) & (density[i] <= highest) & (std::abs(x[i]) <= largest) &
                      (std::abs(z[i]) <= largest) & (speed2 <= largest);
    good &= fine ? -1 : 0;
    found.speed2 = speed2 > found.speed2 ? speed2 : found.speed2;
    found.lowest = density[i] < found.lowest ? density[i] : found.lowest;
    found.highest = density[i] > found.highest ? density[i] : found.highest;
  }
  found.bad = good == 0;
  return found;
}

}  // namespace

void Flow::Engine::advance_by(double tau) {
  fill_level();
  evaluate_level(false);
  finish_step(tau);
}

double Flow::Engine::advance_at_most(double longest) {
  fill_level();
  evaluate_level(true);
  const double tau = std::min(step_by_rule(), longest);
  finish_step(tau);
  return tau;
}

double Flow::Engine::step_by_rule() const {
  double tau = settings_.courant / rates_.largest_limit();
  if (settings_.limit_by_viscosity) {
    if (const auto* laminar = std::get_if<LaminarSps>(&settings_.viscosity);
        laminar && laminar->kinematic_viscosity > 0) {
      tau = std::min(tau, viscous_courant * smoothing_ * smoothing_ / laminar->kinematic_viscosity);
    }
  }
  if (settings_.limit_by_forces) {
    double greatest = 0;
    for (std::size_t i = 0; i < neighbours_.fluid(); ++i) {
      greatest = std::max(greatest, std::hypot(rates_.du[i], rates_.dw[i]) / stage_.records()[i].smoothing);
    }
    if (greatest > 0) tau = std::min(tau, 0.3 / std::sqrt(greatest));
  }
  const double acoustic = settings_.courant * smoothing_ / settings_.sound_speed;
  if (!(tau >= shortest_step * acoustic)) {
    throw Divergence(fmt::format("step {:.3g} is below a thousandth of the acoustic one, {:.3g},", tau, acoustic),
                     time_, steps_, particles_.x[rates_.most_limited()]);
  }
  return tau;
}

/// From rates at level n: formulas (7), (8), which are y <- y + tau f(y + tau/2 f(y)).
void Flow::Engine::finish_step(double tau) {
  // Step 1: to the middle. Lists that do not last so far are made anew, wide enough.
  move(0.5 * tau);
  double used = stage_.fill(StateView(next_));
  if (used > reserve_) {
    sort(std::max(reserve_, 1.5 * (used + used_)));
    evaluate_level(false);
    move(0.5 * tau);
    used = stage_.fill(StateView(next_));
  }
  // Step 2: rates there, from level n with them.
  evaluate(time_ + 0.5 * tau, next_.density, false);
  move(tau);
  commit(tau);
  // Step 3: what is done now and then.
  rearrange(tau);
}

void Flow::Engine::move(double tau) {
  const std::size_t n = particles_.size();
  const std::size_t fluid = neighbours_.fluid();
  const std::size_t chunks = (n + chunk - 1) / chunk;
  const bool clamped = settings_.walls == WallPressure::clamped;
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::size_t c = 0; c < chunks; ++c) {
    const std::size_t first = c * chunk;
    const std::size_t last = std::min(n, first + chunk);
    add_scaled(particles_.x.data(), rates_.dx.data(), tau, first, last, next_.x.data());
    add_scaled(particles_.z.data(), rates_.dz.data(), tau, first, last, next_.z.data());
    add_scaled(particles_.u.data(), rates_.du.data(), tau, first, last, next_.u.data());
    add_scaled(particles_.w.data(), rates_.dw.data(), tau, first, last, next_.w.data());
    add_scaled(particles_.density.data(), rates_.ddensity.data(), tau, first, last, next_.density.data());
    if (!clamped) continue;
    for (std::size_t i = std::max(first, fluid); i < last; ++i) {
      next_.density[i] = std::max(next_.density[i], settings_.density);
    }
  }
  place_paddles(time_ + tau, next_.x, next_.z, next_.u, next_.w);
}

void Flow::Engine::commit(double tau) {
  const std::size_t n = particles_.size();
  const std::size_t fluid = neighbours_.fluid();
  const double lowest = least_density * settings_.density;
  const double highest = greatest_density * settings_.density;
  const std::size_t chunks = (fluid + chunk - 1) / chunk;
  bool bad = survey(next_, fluid, n, lowest, highest).bad;
  Survey all;
#pragma omp parallel for schedule(static) reduction(|| : bad) if (chunks > 1)
  for (std::size_t c = 0; c < chunks; ++c) {
    const Survey found = survey(next_, c * chunk, std::min(fluid, (c + 1) * chunk), lowest, highest);
    bad = bad || found.bad;
#pragma omp critical
    {
      all.speed2 = std::max(all.speed2, found.speed2);
      all.lowest = std::min(all.lowest, found.lowest);
      all.highest = std::max(all.highest, found.highest);
    }
  }
  if (bad) report_bad_state();
  particles_.x.swap(next_.x);
  particles_.z.swap(next_.z);
  particles_.u.swap(next_.u);
  particles_.w.swap(next_.w);
  particles_.density.swap(next_.density);
  time_ += tau;
  ++steps_;
  const double speed = std::sqrt(all.speed2);
  // Twice the way of half a step, and a tenth in case it is a longer one.
  half_travel_ = 1.1 * tau * speed;
  extremes_.mach = std::max(extremes_.mach, speed / settings_.sound_speed);
  extremes_.lowest_density = std::min(extremes_.lowest_density, all.lowest / settings_.density);
  extremes_.highest_density = std::max(extremes_.highest_density, all.highest / settings_.density);
}

void Flow::Engine::rearrange(double tau) {
  const bool filter = settings_.filter_every > 0 && steps_ % settings_.filter_every == 0;
  if (!filter && !settings_.particle_shifting) return;
  fill_level();
  if (filter) {
    filter_density(settings_.kernel, smoothing_, settings_.density, stage_, neighbours_, particles_.density);
  }
  if (settings_.particle_shifting) shifting_.apply(tau, stage_, neighbours_, particles_);
}

void Flow::Engine::report_bad_state() const {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double relative = next_.density[i] / settings_.density;
    const bool finite = std::isfinite(next_.x[i]) && std::isfinite(next_.z[i]) && std::isfinite(next_.u[i]) &&
                        std::isfinite(next_.w[i]) && std::isfinite(next_.density[i]);
    if (finite && relative >= least_density && relative <= greatest_density) continue;
    const auto identity = particles_.identity[i];
    throw Divergence(finite ? fmt::format("density of particle {} over rho_0 becomes {:.4g}, outside [{:g}, {:g}],",
                                          identity, relative, least_density, greatest_density)
                            : fmt::format("state of particle {} is not finite", identity),
                     time_, steps_, particles_.x[i]);
  }
  throw Divergence("speed of a particle overflows", time_, steps_, particles_.x.front());
}

}  // namespace seiche::wcsph
