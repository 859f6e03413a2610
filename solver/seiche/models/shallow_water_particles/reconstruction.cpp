#include "seiche/models/shallow_water_particles/reconstruction.hpp"

#include <algorithm>
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

}  // namespace seiche::shallow_water_particles
