#include "seiche/exact/wall_runup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seiche/exact/wall_collision.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

static_assert(ReferenceSolution<WallRunup>);

}  // namespace

WallRunup::WallRunup(double amplitude, double depth, std::size_t markers, double tolerance)
    : amplitude_(amplitude), depth_(depth), markers_(markers), tolerance_(tolerance) {
  const WallCollision collision(amplitude, depth, markers, tolerance);
  separation_ = collision.separation();
  const double k = collision.wavenumber();
  const std::size_t wall = collision.wall();
  const ow::Moment& highest = collision.highest();
  const auto surface = ow::view(highest.state);
  runup_ = surface.y[wall] / k * depth;
  time_ = highest.time / std::sqrt(k);
  const ow::Invariants& start = collision.motion().moments().front().invariants;
  volume_change_ = std::abs(highest.invariants.volume / start.volume - 1);
  energy_change_ = std::abs(highest.invariants.energy() / start.energy() - 1);
  Worst asymmetry;
  for (std::size_t j = 1; j < wall; ++j) {
    asymmetry.add(std::abs(surface.y[wall + j] - surface.y[wall - j]) / k * depth / runup_);
  }
  asymmetry_ = asymmetry.value();
}

double WallRunup::su_mirie(double amplitude, double depth) {
  const double a = WallCollision::checked_ratio(amplitude, depth);
  return depth * (2 * a + a * a / 2 + 3 * a * a * a / 4);
}

double WallRunup::byatt_smith(double amplitude, double depth) {
  const double a = WallCollision::checked_ratio(amplitude, depth);
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
