#include "seiche/exact/wall_collision.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/overturning/initial.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

/// Of one wave under the crest of the other at the start, relative to its amplitude. Superposition errs by products of
/// the two elevations, which are nowhere larger.
constexpr double negligible = 1e-13;

std::size_t checked(std::size_t markers, double tolerance) {
  require_at_least("markers", static_cast<long>(markers), 128);
  require_positive("tolerance", tolerance);
  require_within("markers modulo 2", static_cast<double>(markers % 2), 0, 0);
  return markers;
}

/// The waves a quarter of the channel from the wall. Units of depth and sqrt(depth/g) for the wave, of period/2 pi for
/// the motion: lengths times k, potentials times k^(3/2), times times sqrt(k).
ow::State start(std::size_t markers, const SolitaryWave& wave, double distance, double k) {
  const auto sum_of_waves = [&](const auto& of_right_going) {
    return [&, of_right_going](double x) {
      const double from_wall = (x - std::numbers::pi) / k;
      return of_right_going(from_wall + distance) + of_right_going(-from_wall + distance);
    };
  };
  return ow::from_functions(markers, sum_of_waves([&](double x) { return k * wave.elevation(x); }),
                            sum_of_waves([&](double x) { return std::pow(k, 1.5) * wave.surface_potential(x); }));
}

}  // namespace

double WallCollision::checked_ratio(double amplitude, double depth) {
  require_positive("depth", depth);
  require_positive("amplitude", amplitude);
  require_within("amplitude/depth", amplitude / depth, 0.05, 0.6 * (1 + 1e-12));
  return amplitude / depth;
}

WallCollision::WallCollision(double amplitude, double depth, std::size_t markers, double tolerance)
    : WallCollision(SolitaryWave(checked_ratio(amplitude, depth)), depth, checked(markers, tolerance), tolerance) {}

WallCollision::WallCollision(const SolitaryWave& wave, double depth, std::size_t markers, double tolerance)
    : depth_(depth),
      separation_(-0.5 * std::log(negligible) / wave.decay_rate()),
      k_(2 * std::numbers::pi / (4 * separation_)),
      crossing_(std::sqrt(k_) * separation_ / wave.speed()),
      wall_(markers / 2),
      motion_(start(markers, wave, separation_, k_), k_, k_ * tolerance) {
  separation_ *= depth;
  motion_.advance_to(0.9 * crossing_);
  while (motion_.ending() == ow::Ending::none && rise(motion_.now()) > 0 && motion_.now().time < 2 * crossing_) {
    motion_.advance_to(motion_.now().time + 0.1 * crossing_);
  }
  require_resolved();
  highest_ = motion_.at(motion_.first_zero([&](const ow::Moment& moment) { return rise(moment); }, 1e-10).value());
}

double WallCollision::rise(const ow::Moment& moment) const {
  return moment.time < 0.5 * crossing_ ? 1.0 : ow::view(moment.rate).y[wall_];
}

void WallCollision::require_resolved() const {
  if (motion_.ending() == ow::Ending::none) return;
  throw Divergence(fmt::format("{} (markers = {} are too few, or the wave breaks)", motion_.ending_reason(), 2 * wall_),
                   motion_.now().time / std::sqrt(k_), static_cast<long>(motion_.moments().size() - 1),
                   motion_.ending_place() / k_ * depth_);
}

void WallCollision::advance_until_below(double level) {
  const double low = level / length();
  while (motion_.ending() == ow::Ending::none && ow::view(motion_.now().state).y[wall_] > low) {
    motion_.advance_to(motion_.now().time + 0.02 * crossing_);
  }
  require_resolved();
}

}  // namespace seiche::exact
