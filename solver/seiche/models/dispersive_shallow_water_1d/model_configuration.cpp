// Configurations: bottom and frames under the markers, gradients, the matrix; motion along the frames.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::dispersive_shallow_water_1d {

Range Model::markers_of(std::ptrdiff_t block) const {
  return {block * block_size(), std::min(size_, (block + 1) * block_size())};
}

Range Model::cells_of(std::ptrdiff_t block) const {
  const auto cells = static_cast<std::ptrdiff_t>(cells_);
  return {block * block_size(), std::min(cells, (block + 1) * block_size())};
}

Frame Model::end_frame(End end, Frame frame, double slope) const {
  if (end == End::wall) return {.xp = 0, .xr = 0, .yp = 0, .yr = 1};
  if (end == End::tip) return frame_on(Kinetics::frank, channel_.alpha, slope);
  return frame;
}

bool Model::sample(std::ptrdiff_t block, const double* x, Bed& bed, std::ptrdiff_t begin,
                   std::vector<double>& slope) const {
  const Range range = markers_of(block);
  const auto count = static_cast<std::size_t>(range.last - range.first);
  const std::span places(x + range.first, count);
  const std::span elevation(bed.elevation.row() + begin, count);
  const std::ptrdiff_t end = begin + range.last - range.first;
  const BottomProfile& bottom = *channel_.bottom;
  if (bottom.uniform_slope(places.front(), places.back()) == 0.0) {
    std::fill(elevation.begin(), elevation.end(), bottom.elevation(places.front()));
    bed.set_frame(begin, {});  // read by the cells that this block shares with tilted ones
    bed.set_frame(end - 1, {});
    return true;
  }
  bottom.sample(places, elevation, slope);
  for (std::size_t i = 0; i < count; ++i) {
    bed.set_frame(begin + static_cast<std::ptrdiff_t>(i), frame_on(channel_.kinetics, channel_.alpha, slope[i]));
  }
  if (!channel_.periodic()) {
    if (range.first == 0) bed.set_frame(begin, end_frame(channel_.left, bed.frame(begin), slope[0]));
    if (range.last == size_) {
      bed.set_frame(end - 1, end_frame(channel_.right, bed.frame(end - 1), slope[count - 1]));
    }
  }
  return false;
}

void Model::move_block(std::ptrdiff_t block, Input from, Input u, double h, double* to_x, double* to_y,
                       Desk& desk) const {
  const bool level = sample(block, from.data(), desk.bed, 0, desk.slope);
  const auto [first, last] = markers_of(block);
  const double* const x = from.data() + first;
  const double* const p = u.data() + first;
  advance_rows(desk.bed, level, {0, last - first}, x, x + n_, p, p + n_, h, to_x + first, to_y + first);
}

/// Ghosts beside the first and the last block: in a periodic channel images; at an end an empty cell, whose mean depth
/// is that of what lies beyond it. The water there pushes back with g b^2/2, without which still water would not be at
/// rest.
void Model::close(std::ptrdiff_t block, const Segment* segment) {
  const BottomProfile& bottom = *channel_.bottom;
  const auto close_end = [&](std::ptrdiff_t marker, std::ptrdiff_t ghost, std::ptrdiff_t cell) {
    for (GhostedArray* array : {&rows_.y, &rows_.step_x, &rows_.step_y}) array->row()[ghost] = array->row()[marker];
    const auto i = static_cast<std::size_t>(marker);
    const double bed = rows_.bed.elevation.row()[marker];
    rows_.width.row()[cell] = 0;
    rows_.mean.row()[cell] = segment == nullptr ? bed : std::sqrt(bottom.mean_square(segment->q0[i], segment->q1[i]));
  };
  const auto copy = [&](std::ptrdiff_t marker, std::ptrdiff_t ghost, double shift) {
    for (GhostedArray* array : {&rows_.x, &rows_.y, &rows_.step_x, &rows_.step_y, &rows_.bed.elevation}) {
      array->row()[ghost] = array->row()[marker];
    }
    rows_.x.row()[ghost] += shift;
    rows_.bed.set_frame(ghost, level(marker == 0 ? 0 : blocks() - 1) ? Frame{} : rows_.bed.frame(marker));
  };
  if (channel_.periodic()) {
    copy(size_ - 1, -1, -channel_.period);
    copy(0, size_, channel_.period);
    return;
  }
  if (block == 0) close_end(0, -1, -1);
  if (block + 1 == blocks()) close_end(size_ - 1, size_, size_ - 1);
}

void Model::require_sound() {
  const double* const width = rows_.width.row();
  const double* const y = rows_.y.row();
  const double* const bed = rows_.bed.elevation.row();
  const auto cells = static_cast<std::ptrdiff_t>(cells_);
  const std::ptrdiff_t first = !channel_.periodic() && channel_.left == End::tip ? 1 : 0;
  const std::ptrdiff_t last = !channel_.periodic() && channel_.right == End::tip ? size_ - 1 : size_;
  const Smallest found = smallest(rows_, {0, cells}, {first, last});
  if (found.width > 0 && found.depth > 0) {
    smallest_depth_ = found.depth;
    return;
  }
  for (std::ptrdiff_t j = 0; j < cells; ++j) {
    if (!(width[j] > 0)) {
      throw mechanics::Infeasible(rows_.x.row()[j], "markers cross: width of cell {} is {:.6g}", j, width[j]);
    }
  }
  for (std::ptrdiff_t i = first; i < last; ++i) {
    if (!(y[i] - bed[i] > 0)) {
      throw mechanics::Infeasible(rows_.x.row()[i], "no water: depth under marker {} is {:.6g}", i, y[i] - bed[i]);
    }
  }
}

void Model::measure(const Segment* segment) {
  close(0, segment);
  if (blocks() > 1) close(blocks() - 1, segment);
  measure_cells(rows_, {channel_.periodic() ? -1 : 0, static_cast<std::ptrdiff_t>(cells_)});
  require_sound();
}

void Model::assemble_and_factor() {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    over_cells(block, [&](bool level_cells, Range cells) { assemble(rows_, level_cells, cells); });
    couple(rows_, level(block), markers_of(block));
  }
  if (channel_.periodic()) rows_.coupling.row()[size_ - 1] = rows_.coupling.row()[-1];
  try {
    matrix_.factor({{rows_.diagonal.row(), cells_}, {rows_.coupling.row(), cells_}}, channel_.periodic());
  } catch (const linear::NotPositiveDefinite& failure) {
    throw mechanics::Infeasible(failure.what(), rows_.x.row()[failure.row()]);
  }
}

/// Rows, beds and frames at q.
void Model::place_at(Input q) {
  std::copy_n(q.data(), n_, rows_.x.row());
  std::copy_n(q.data() + n_, n_, rows_.y.row());
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    level_[static_cast<std::size_t>(block)] =
        sample(block, rows_.x.row(), rows_.bed, markers_of(block).first, desks_.front().slope);
  }
  measure(nullptr);
}

void Model::linearise(Interval when, Input q) {
  place_at(q);
  gather_forces(when);
  if (channel_.gamma > 0) add_dispersion_forces(q, q);
  assemble_and_factor();
}

/// Middle of the segment q0 -> q1, and the motion along it.
void Model::place_between(std::ptrdiff_t block, Input q0, Input q1) {
  const Range markers = markers_of(block);
  middle_rows(markers, q0.data(), q1.data(), rows_.x.row(), rows_.step_x.row());
  middle_rows(markers, q0.data() + n_, q1.data() + n_, rows_.y.row(), rows_.step_y.row());
}

/// Ghost cells have no extent, but the loop over increments saw an end's motion in them.
double Model::release_at_end(std::ptrdiff_t marker, double sign) const {
  const double dy = rows_.step_y.row()[marker];
  return sign * weights_.gravity / 24 * dy * dy;
}

void Model::linearise_between(Interval when, Input q0, Input q1, int sweep) {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    place_between(block, q0, q1);
    mean_bed(block, q0, q1, sweep < sweeps_with_new_frames, desks_.front());
  }
  const Segment segment{q0, q1};
  measure(&segment);
  gather_forces(when);
  add_increment_forces(rows_, {0, size_}, weights_, forces());
  if (!channel_.periodic()) {
    rows_.force_x.row()[0] += release_at_end(0, 1);
    rows_.force_x.row()[size_ - 1] += release_at_end(size_ - 1, -1);
  }
  if (channel_.gamma > 0) add_dispersion_forces(q0, q1);
  assemble_and_factor();
}

/// Frames at the middle of the step, but of the elevation its mean over the step, which makes volumes exact.
void Model::mean_bed(std::ptrdiff_t block, Input q0, Input q1, bool new_frames, Desk& desk) {
  const Range range = markers_of(block);
  const auto first = static_cast<std::size_t>(range.first);
  const auto last = static_cast<std::size_t>(range.last);
  const BottomProfile& bottom = *channel_.bottom;
  char& level = level_[static_cast<std::size_t>(block)];
  if (new_frames) level = sample(block, rows_.x.row(), rows_.bed, range.first, desk.slope);
  double* const bed = rows_.bed.elevation.row();
  const auto [left, right] = std::minmax({q0[first], q1[first], q0[last - 1], q1[last - 1]});
  if (level != 0 && bottom.uniform_slope(left, right) == 0.0) return;
  for (std::size_t i = first; i < last; ++i) bed[i] = bottom.mean(q0[i], q1[i]);
}

void Model::predict(Input from, Input u, double h, Output to) const {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    move_block(block, from, u, h, to.data(), to.data() + n_, desks_.front());
  }
}

void Model::advance(Input from, Input u, double h, Output to) const {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    advance_rows(rows_.bed, level(block), markers_of(block), from.data(), from.data() + n_, u.data(), u.data() + n_, h,
                 to.data(), to.data() + n_);
  }
}

void Model::kick(double h, Output u) const {
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    const Range markers = markers_of(block);
    const GivenForces forces{rows_.force_x.row() + markers.first, rows_.force_y.row() + markers.first};
    kick_rows(rows_, level(block), markers, forces, h, u.data(), u.data() + n_);
  }
  if (!forcing_.body_force) return;
  for (std::size_t i = 0; i < n_; ++i) {
    const auto k = static_cast<std::ptrdiff_t>(i);
    u[i] += h * rows_.mobility_p.row()[k] * mass_[i] * along_[i];
    u[n_ + i] += h * rows_.mobility_r.row()[k] * mass_[i] * across_[i];
  }
}

void Model::constraint_rates(Input u, Output w) const {
  const double* p = u.data();
  const double* r = u.data() + n_;
  if (channel_.periodic()) {  // the last cell needs the first marker's rates
    std::copy_n(p, n_, p_.row());
    std::copy_n(r, n_, r_.row());
    p_.row()[size_] = u[0];
    r_.row()[size_] = u[n_];
    p = p_.row();
    r = r_.row();
  }
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    over_cells(block,
               [&](bool level_cells, Range cells) { rates_of_cells(rows_, level_cells, cells, p, r, w.data()); });
  }
}

void Model::react(Input mu, Output u) const {
  double* const impulse = impulse_.row();
  std::copy_n(mu.data(), cells_, impulse);
  impulse[-1] = channel_.periodic() ? mu[cells_ - 1] : 0.0;
  if (!channel_.periodic()) impulse[size_ - 1] = 0;
  for (std::ptrdiff_t block = 0; block < blocks(); ++block) {
    react_rows(rows_, level(block), markers_of(block), impulse, u.data(), u.data() + n_);
  }
}

void Model::solve(Input right_hand_side, Output mu) {
  ++solves_;
  matrix_.solve(right_hand_side, mu);
}

void Model::settle(Interval, Output q, Output u) const {
  if (channel_.periodic()) return;
  const BottomProfile& bottom = *channel_.bottom;
  const auto end = [&](End kind, std::size_t i) {
    if (kind == End::tip) {
      u[n_ + i] = 0;
      // A tip beyond the bottom profile stays where its motion brought it: the next step finds it there.
      if (q[i] >= bottom.begin() && q[i] <= bottom.end()) q[n_ + i] = bottom.elevation(q[i]);
    }
    if (kind == End::wall) u[i] = 0;
  };
  end(channel_.left, 0);
  end(channel_.right, n_ - 1);
}

}  // namespace seiche::dispersive_shallow_water_1d
