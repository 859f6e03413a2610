#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_1d {

double Friction::per_length(double gravity, double depth) const {
  return law == FrictionLaw::quadratic ? coefficient / depth
                                       : gravity * coefficient * coefficient / (depth * std::cbrt(depth));
}

void Channel::validate() const {
  require_that(bottom != nullptr, "channel without a bottom: set Channel::bottom");
  require_ranges(*this);
  require_not_negative("friction coefficient", friction.coefficient);
  if (breaking) require_ranges(*breaking);
  require_that(kinetics != Kinetics::green_naghdi || alpha >= 0.25,
               "kinetics = green_naghdi needs alpha >= 1/4: the kinetic energy over steep slopes "
               "would not be positive");
}

namespace {

/// Marker to the right of a cell.
std::size_t right_of(const BreakingFronts::Surface& surface, std::size_t cell) {
  return cell + 1 < surface.x.size() ? cell + 1 : 0;
}

double width_of(const BreakingFronts::Surface& surface, std::size_t cell) {
  const std::size_t k = right_of(surface, cell);
  return surface.x[k] - surface.x[cell] + (k == 0 ? surface.period : 0.0);
}

bool compressed(const BreakingFronts::Surface& surface, std::size_t cell) {
  constexpr double least = 0.0015;
  const std::size_t k = right_of(surface, cell);
  const double depth = 0.5 * ((surface.y[cell] - surface.bed[cell]) + (surface.y[k] - surface.bed[k]));
  return surface.u[cell] - surface.u[k] > least * width_of(surface, cell) * std::sqrt(surface.gravity / depth);
}

}  // namespace

double BreakingFronts::damping_of_front(const Surface& surface, std::size_t first, std::size_t cells) const {
  const std::size_t all = damping_.size();
  bool broke = false;
  double steepest = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::size_t j = (first + c) % all;
    const std::size_t k = right_of(surface, j);
    steepest = std::max(steepest, std::abs(surface.y[k] - surface.y[j]) / width_of(surface, j));
    broke = broke || were_[j] != 0;
  }
  if (!broke && steepest < settings_.onset_slope) return 0;
  const std::size_t end = right_of(surface, (first + cells - 1) % all);
  const std::size_t foot = surface.y[first] < surface.y[end] ? first : end;
  const double ahead = surface.y[foot] - surface.bed[foot];
  const double rise = std::abs(surface.y[end] - surface.y[first]);
  if (shallow_water::bore_froude(ahead, rise) < settings_.ceasing_froude) return 0;
  return settings_.share * shallow_water::bore_damping(ahead, rise);
}

bool BreakingFronts::find(const Surface& surface) {
  damping_.swap(were_);
  std::fill(damping_.begin(), damping_.end(), 0.0);
  const std::size_t all = damping_.size();
  std::size_t begin = 0;
  if (surface.period > 0) {
    while (begin < all && compressed(surface, begin)) ++begin;  // no front goes round the whole channel
  }
  bool any = false;
  for (std::size_t c = 0; c < all;) {
    std::size_t cells = 0;
    while (c + cells < all && compressed(surface, (begin + c + cells) % all)) ++cells;
    const double damping = cells > 0 ? damping_of_front(surface, (begin + c) % all, cells) : 0.0;
    any = any || damping > 0;
    for (std::size_t k = 0; k < cells; ++k) damping_[(begin + c + k) % all] = damping;
    c += cells + 1;
  }
  return any;
}

}  // namespace seiche::dispersive_shallow_water_1d
