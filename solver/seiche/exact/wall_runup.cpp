#include "seiche/exact/wall_runup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/divergence.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/initial.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

static_assert(ReferenceSolution<WallRunup>);

/// Of one wave under the crest of the other at the start, relative to its amplitude. Superposition errs by products of
/// the two elevations, which are nowhere larger.
constexpr double tail = 1e-13;

double checked_ratio(double amplitude, double depth) {
  require_positive("depth", depth);
  require_positive("amplitude", amplitude);
  require_within("amplitude/depth", amplitude / depth, 0.05, 0.6 * (1 + 1e-12));
  return amplitude / depth;
}

}  // namespace

WallRunup::WallRunup(double amplitude, double depth, std::size_t markers, double tolerance)
    : amplitude_(amplitude), depth_(depth), markers_(markers), tolerance_(tolerance) {
  require_at_least("markers", static_cast<long>(markers), 128);
  require_positive("tolerance", tolerance);
  require_within("markers modulo 2", static_cast<double>(markers % 2), 0, 0);
  // Units of depth and sqrt(depth/g) for the wave, of period/2 pi for the motion: lengths times k, potentials times
  // k^(3/2), times times sqrt(k).
  const SolitaryWave wave(checked_ratio(amplitude, depth));
  const double distance = -0.5 * std::log(tail) / wave.decay_rate();
  separation_ = distance * depth;
  const double k = 2 * std::numbers::pi / (4 * distance);
  // The wall is at x = pi: the label in the middle. The waves start a quarter of the channel from it.
  const auto sum_of_waves = [&](const auto& of_right_going) {
    return [&, of_right_going](double x) {
      const double from_wall = (x - std::numbers::pi) / k;
      return of_right_going(from_wall + distance) + of_right_going(-from_wall + distance);
    };
  };
  ow::Evolution motion(
      ow::from_functions(markers, sum_of_waves([&](double x) { return k * wave.elevation(x); }),
                         sum_of_waves([&](double x) { return std::pow(k, 1.5) * wave.surface_potential(x); })),
      k, k * tolerance);
  const std::size_t wall = markers / 2;
  const double crossing = std::sqrt(k) * distance / wave.speed();
  const auto rising = [&](const ow::Moment& moment) {
    return moment.time < 0.5 * crossing ? 1.0 : ow::view(moment.rate).y[wall];
  };
  motion.advance_to(0.9 * crossing);
  while (motion.ending() == ow::Ending::none && rising(motion.now()) > 0 && motion.now().time < 2 * crossing) {
    motion.advance_to(motion.now().time + 0.1 * crossing);
  }
  if (motion.ending() != ow::Ending::none) {
    throw Divergence(motion.ending_reason(), motion.now().time / std::sqrt(k),
                     static_cast<long>(motion.moments().size() - 1), motion.ending_place() / k * depth);
  }
  const ow::Moment highest = motion.at(motion.first_zero(rising, 1e-10).value());
  const auto surface = ow::view(highest.state);
  runup_ = surface.y[wall] / k * depth;
  time_ = highest.time / std::sqrt(k);
  const ow::Invariants& start = motion.moments().front().invariants;
  volume_change_ = std::abs(highest.invariants.volume / start.volume - 1);
  energy_change_ = std::abs(highest.invariants.energy() / start.energy() - 1);
  Worst asymmetry;
  for (std::size_t j = 1; j < wall; ++j) {
    asymmetry.add(std::abs(surface.y[wall + j] - surface.y[wall - j]) / k * depth / runup_);
  }
  asymmetry_ = asymmetry.value();
}

double WallRunup::su_mirie(double amplitude, double depth) {
  const double a = checked_ratio(amplitude, depth);
  return depth * (2 * a + a * a / 2 + 3 * a * a * a / 4);
}

double WallRunup::byatt_smith(double amplitude, double depth) {
  const double a = checked_ratio(amplitude, depth);
  return depth * (2 * a + a * a / 2);
}

double WallRunup::uncertainty() const {
  const std::size_t fewer = std::max<std::size_t>(128, markers_ / 3 * 2);
  return std::abs(WallRunup(amplitude_, depth_, fewer, 10 * tolerance_).runup() / runup_ - 1);
}

SelfTest WallRunup::self_test() const {
  constexpr double steps = 300;
  constexpr double stages = 6;
  // Of the elevation, relative to the amplitude.
  const double integration = steps * std::pow(tolerance_ * depth_ / amplitude_, 1.2);
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * std::sqrt(steps * stages * static_cast<double>(markers_));
  return {{"volume is conserved", volume_change_, integration,
           "about 300 steps whose errors of fourth order are kept at the tolerance and add up, over the amplitude; the "
           "solution of fifth order that is carried on errs less by a step, the fifth root of the tolerance"},
          {"energy is conserved", energy_change_, 2 * integration, "the same, twice as much of a square"},
          {"the collision is symmetric", asymmetry_, rounding,
           "nothing but round-off tells left from right: about 300 steps of six surfaces, each moved by sums over all "
           "markers"}};
}

Provenance WallRunup::provenance() {
  return {
      "Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980) 509; Cooker, Weidman & "
      "Bale, "
      "Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342 (1997) 141",
      "two mirrored solitary waves of the Euler equations moved by Cauchy's integral; R = max y at the wall"};
}

}  // namespace seiche::exact
