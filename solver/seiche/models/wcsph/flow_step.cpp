#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// Densities within these, over rho_0, are a run that goes on.
constexpr double least_density = 0.5;
constexpr double greatest_density = 1.5;

SEICHE_SIMD_CLONES void add_scaled(const double* value, const double* rate, double tau, std::size_t count,
                                   double* sum) {
  for (std::size_t i = 0; i < count; ++i) sum[i] = value[i] + tau * rate[i];
}
struct Survey {
  bool bad = false;
  double speed2 = 0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0;

  void add(const Survey& other) {
    bad = bad || other.bad;
    speed2 = std::max(speed2, other.speed2);
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
  }
};

/// Comparisons that NaN fails, so that it counts as bad.
SEICHE_SIMD_CLONES Survey survey(const StateBlock& state, std::size_t count, double lowest, double highest) {
  constexpr double largest = std::numeric_limits<double>::max();
  const double *x = state.x.data(), *z = state.z.data(), *u = state.u.data(), *w = state.w.data(),
               *density = state.density.data();
  Survey found;
  std::int64_t good = -1;
  for (std::size_t i = 0; i < count; ++i) {
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

void Flow::advance(double tau) {
  require_positive("tau", tau);
  if (!level_known_) {
    refresh_lists();
    evaluate_level(false);
  }
  level_known_ = false;
  double level_used = stage_.used();
  try {
    // Rates at level n: formulas (7), (8), which are y <- y + tau f(y + tau/2 f(y)). What is in the middle of the step
    // is in the records alone. Step 1: to the middle. Lists that do not last so far are made anew, wide enough.
    const double used = fill_moved(0.5 * tau);
    if (used > reserve_) {
      sort(std::max(reserve_, 1.5 * (used + used)));
      evaluate_level(false);
      level_used = stage_.used();
      fill_moved(0.5 * tau);
    }
    // Step 2: rates there, from level n with them.
    evaluate(time_ + 0.5 * tau, false);
    commit(tau);
  } catch (...) {
    stage_.adopt(particles_, neighbours_.images(), level_used);
    throw;
  }
  stage_.fill(particles_);
  // Step 3: what is done now and then.
  rearrange(tau);
}

double Flow::stable_step() {
  refresh_lists();
  evaluate_level(true);
  level_known_ = true;
  double tau = settings_.courant / rates_.largest_limit();
  if (const auto* laminar = std::get_if<LaminarSps>(&settings_.viscosity);
      laminar && laminar->kinematic_viscosity > 0) {
    tau = std::min(tau, viscous_courant * smoothing_ * smoothing_ / laminar->kinematic_viscosity);
  }
  const double acoustic = settings_.courant * smoothing_ / settings_.sound_speed;
  if (!(tau >= shortest_step * acoustic)) {
    throw Divergence(fmt::format("step {:.3g} is below a thousandth of the acoustic one, {:.3g},", tau, acoustic),
                     time_, steps_, particles_.x[rates_.most_limited()]);
  }
  return tau;
}

void Flow::moved(double tau, const PaddlePoses& poses, std::size_t first, std::size_t count, StateBlock& to) const {
  const Rates& rates = rates_.rates();
  add_scaled(&particles_.x[first], &rates.dx[first], tau, count, to.x.data());
  add_scaled(&particles_.z[first], &rates.dz[first], tau, count, to.z.data());
  add_scaled(&particles_.u[first], &rates.du[first], tau, count, to.u.data());
  add_scaled(&particles_.w[first], &rates.dw[first], tau, count, to.w.data());
  add_scaled(&particles_.density[first], &rates.ddensity[first], tau, count, to.density.data());
  const bool clamped = settings_.walls == WallPressure::clamped;
  for (std::size_t i = std::max(first, neighbours_.fluid()); i < first + count; ++i) {
    const std::size_t k = i - first;
    if (clamped) to.density[k] = std::max(to.density[k], settings_.density);
    if (particles_.kind[i] != Kind::paddle) continue;
    const PointMotion motion = carried_by_paddle(i, poses);
    to.x[k] = motion.x;
    to.z[k] = motion.z;
    to.u[k] = motion.u;
    to.w[k] = motion.w;
  }
}

double Flow::fill_moved(double tau) {
  const PaddlePoses poses = paddles_at(time_ + tau);
  return stage_.fill(
      [&](std::size_t first, std::size_t count, StateBlock& block) { moved(tau, poses, first, count, block); });
}

/// Looks at all particles before it moves one: what moves them is computed twice, and no second state is kept.
void Flow::commit(double tau) {
  const std::size_t n = particles_.size();
  const std::size_t fluid = neighbours_.fluid();
  const double lowest = least_density * settings_.density;
  const double highest = greatest_density * settings_.density;
  const PaddlePoses poses = paddles_at(time_ + tau);
  const auto look = [&](std::size_t first, std::size_t count, Survey& found) {
    StateBlock block;
    moved(tau, poses, first, count, block);
    found.add(survey(block, count, lowest, highest));
  };
  const auto all = over_blocks<Survey>(0, fluid, look);
  if (all.bad || over_blocks<Survey>(fluid, n, look).bad) report_bad_state(tau, poses);
  struct Nothing {
    void add(Nothing /*other*/) {}
  };
  over_blocks<Nothing>(0, n, [&](std::size_t first, std::size_t count, Nothing& /*found*/) {
    StateBlock block;
    moved(tau, poses, first, count, block);
    for (const auto& [to, of] : matched(particles_, block)) std::copy_n(of->data(), count, &(*to)[first]);
  });
  time_ += tau;
  ++steps_;
  const double speed = std::sqrt(all.speed2);
  // Twice the way of half a step, and a tenth in case it is a longer one.
  half_travel_ = 1.1 * tau * speed;
  extremes_.mach = std::max(extremes_.mach, speed / settings_.sound_speed);
  extremes_.lowest_density = std::min(extremes_.lowest_density, all.lowest / settings_.density);
  extremes_.highest_density = std::max(extremes_.highest_density, all.highest / settings_.density);
}

void Flow::rearrange(double tau) {
  const bool filter = settings_.filter_every > 0 && steps_ % settings_.filter_every == 0;
  if (!filter && !settings_.particle_shifting) return;
  refresh_lists();
  if (filter) corrections_.filter(stage_, neighbours_, particles_.density);
  if (settings_.particle_shifting) corrections_.shift(tau, stage_, neighbours_, particles_);
  stage_.fill(particles_);
}

void Flow::report_bad_state(double tau, const PaddlePoses& poses) const {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    StateBlock next;
    moved(tau, poses, i, 1, next);
    const double relative = next.density[0] / settings_.density;
    const bool finite = std::isfinite(next.x[0]) && std::isfinite(next.z[0]) && std::isfinite(next.u[0]) &&
                        std::isfinite(next.w[0]) && std::isfinite(next.density[0]);
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
