#include "seiche/models/shallow_water_particles/reconstruction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace seiche::shallow_water_particles {

Reconstruction::Reconstruction(double gravity, std::vector<Piece> pieces, std::optional<Bed> bed)
    : gravity_(gravity), pieces_(std::move(pieces)), bed_(std::move(bed)) {}

State Reconstruction::at(double x) const {
  if (!(x >= left_end() && x <= right_end())) return {0, 0};
  auto next = std::upper_bound(pieces_.begin(), pieces_.end(), x, [](double v, const Piece& p) { return v < p.left; });
  const Piece& piece = *std::prev(next);
  const double s = (x - piece.left) / (piece.right - piece.left);
  if (piece.tip) {
    const State state = piece.tip->at(gravity_, std::clamp(piece.tip_on_right ? 1 - s : s, 0.0, 1.0));
    return piece.tip_on_right ? state : State{state.depth, -state.velocity};
  }
  const double surface = piece.surface_left + s * (piece.surface_right - piece.surface_left);
  const double depth = bed_ ? std::max(surface - bed_->elevation(x), 0.0) : surface;
  return {depth, piece.velocity_left + s * (piece.velocity_right - piece.velocity_left)};
}

shallow_water::State TipProfile::at(double gravity, double s) const {
  const double depth = exponent == 0 ? edge_depth : edge_depth * std::pow(s, exponent);
  return {depth, front_velocity - 2 * std::sqrt(gravity * depth)};
}

TipProfile tip_profile(double gravity, shallow_water::State mean, double front_velocity, double highest) {
  // (u_f - u)/(2 c) of the means is (pi + 1)^(3/2)/(1.5 pi + 1): with w = (pi + 1)^(-1/2) a cubic, w^3 - 3 w + 2/ratio.
  const double steepest = 0.75 * std::numbers::sqrt3;  // of the parabola, pi = 2
  const double ratio = (front_velocity - mean.velocity) / (2 * shallow_water::celerity(gravity, mean.depth));
  const double angle = std::acos(-1 / std::clamp(ratio, 1.0, steepest));
  const double w = 2 * std::cos((2 * std::numbers::pi - angle) / 3);
  const double exponent = 1 / (w * w) - 1;
  const double edge_depth = std::clamp((exponent + 1) * mean.depth, mean.depth, std::max(mean.depth, highest));
  // A clamped edge depth changes the exponent: the profile keeps the mass of the particle.
  return {edge_depth / mean.depth - 1, edge_depth, front_velocity};
}

}  // namespace seiche::shallow_water_particles
