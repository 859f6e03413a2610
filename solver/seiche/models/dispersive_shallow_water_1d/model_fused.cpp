// Steps in two passes over memory: see TwoEndedSweep.
#include <algorithm>
#include <cmath>
#include <limits>

#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::dispersive_shallow_water_1d {

bool Model::fuses_step() const {
  return !channel_.periodic() && channel_.gamma == 0 && !forcing_.surface_pressure && !forcing_.body_force;
}

/// Ghosts beside the first and the last block; see close() and bound_ends().
void Model::bound_block(std::ptrdiff_t block, const Segment* segment) {
  const BottomProfile& bottom = *channel_.bottom;
  const auto bound = [&](std::ptrdiff_t marker, std::ptrdiff_t ghost, std::ptrdiff_t cell) {
    const auto i = static_cast<std::size_t>(marker);
    const double bed = rows_.bed.elevation.row()[marker];
    rows_.y.row()[ghost] = rows_.y.row()[marker];
    rows_.step_x.row()[ghost] = rows_.step_x.row()[marker];
    rows_.step_y.row()[ghost] = rows_.step_y.row()[marker];
    rows_.width.row()[cell] = 0;
    rows_.mean.row()[cell] = segment == nullptr ? bed : std::sqrt(bottom.mean_square(segment->q0[i], segment->q1[i]));
  };
  if (block == 0) bound(0, -1, -1);
  if (block + 1 == blocks()) bound(size_ - 1, size_, size_ - 1);
}

/// Rows of A mu = target - J u*, u* = u + h W F, for the cells that begin in the block. The marker after the block and
/// the cells beside it are made here too: they cost less than waiting for the neighbour.
void Model::assemble_block(std::ptrdiff_t block, double h, Input rates, const double* target, const Segment* segment) {
  const Range markers = markers_of(block);
  const Range cells = cells_of(block);
  const auto all_cells = static_cast<std::ptrdiff_t>(cells_);
  const Range wide_markers{markers.first, std::min(markers.last + 1, size_)};
  const Range wide_cells{std::max<std::ptrdiff_t>(markers.first - 1, 0), std::min(markers.last + 1, all_cells)};
  measure_cells(rows_, wide_cells);
  bound_block(block, segment);
  if (wide_markers.last == size_) bound_block(blocks() - 1, segment);
  gravity_forces(rows_, wide_markers, weights_);
  if (segment != nullptr) {
    add_increment_forces(rows_, wide_markers, weights_);
    if (wide_markers.first == 0) release_end(0, 1);
    if (wide_markers.last == size_) release_end(size_ - 1, -1);
  }

  double* const p = rows_.star_p.row();
  double* const r = rows_.star_r.row();
  const auto count = static_cast<std::size_t>(wide_markers.last - wide_markers.first);
  std::copy_n(rates.data() + markers.first, count, p + markers.first);
  std::copy_n(rates.data() + n_ + static_cast<std::size_t>(markers.first), count, r + markers.first);
  kick_rows(rows_, level(block), markers, h, p, r);
  if (wide_markers.last > markers.last) kick_rows(rows_, level(block + 1), {markers.last, wide_markers.last}, h, p, r);

  over_cells(block, [&](bool level_cells, Range range) {
    assemble(rows_, level_cells, range);
    rates_of_cells(rows_, level_cells, range, p, r, rows_.defect.row());
  });
  aim(rows_, cells, target);
  couple(rows_, level(block), markers);

  const bool left_tip = markers.first == 0 && channel_.left == End::tip;
  const bool right_tip = markers.last == size_ && channel_.right == End::tip;
  const Smallest found =
      smallest(rows_, cells, {markers.first + (left_tip ? 1 : 0), markers.last - (right_tip ? 1 : 0)});
  found_.depth = std::min(found_.depth, found.depth);
  found_.width = std::min(found_.width, found.width);
}

template <class Prepare>
void Model::assemble_from_both_ends(double h, Input rates, Input target, const Segment* segment,
                                    const Prepare& prepare) {
  const std::ptrdiff_t last = blocks() - 1;
  found_ = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  sweep_.begin({.diagonal = rows_.diagonal.row(),
                .off_diagonal = rows_.coupling.row(),
                .right_hand_side = rows_.defect.row(),
                .multiplier = rows_.multiplier.row(),
                .x = rows_.impulse.row()},
               static_cast<std::ptrdiff_t>(cells_));
  // Blocks [0, front) and (back, last] are prepared.
  std::ptrdiff_t front = 0;
  std::ptrdiff_t back = last;
  const auto prepare_to = [&](std::ptrdiff_t from_front, std::ptrdiff_t from_back) {
    for (; front <= std::min(from_front, back); ++front) prepare(front);
    for (; back >= std::max(from_back, front); --back) prepare(back);
  };
  const double* const aims = target.empty() ? nullptr : target.data();
  for (std::ptrdiff_t f = 0, b = last; f <= b; ++f, --b) {
    prepare_to(f + 1, b - 1);
    assemble_block(f, h, rates, aims, segment);
    if (b > f) assemble_block(b, h, rates, aims, segment);
    if (f + 1 < b) {
      sweep_.eliminate(cells_of(f).last, cells_of(b).first);
    } else {  // all rows are there
      sweep_.eliminate(static_cast<std::ptrdiff_t>(cells_), 0);
    }
  }
  ++solves_;
  if (!(found_.width > 0 && found_.depth > 0)) require_sound();
  try {
    sweep_.join();
  } catch (const linear::NotPositiveDefinite& failure) {
    throw mechanics::Infeasible(failure.what(), rows_.x.row()[failure.row()]);
  }
  // Whatever is not a number reaches the middle row of the elimination.
  const std::ptrdiff_t middle = static_cast<std::ptrdiff_t>(cells_) / 2;
  if (!std::isfinite(rows_.impulse.row()[middle])) {
    throw mechanics::Infeasible("a velocity is not finite", rows_.x.row()[middle]);
  }
  smallest_depth_ = found_.depth;
}

/// use(block) as soon as the impulses of all cells beside the block's markers are there.
template <class Use>
void Model::substitute_from_the_middle(const Use& use) {
  const auto cells = static_cast<std::ptrdiff_t>(cells_);
  const std::ptrdiff_t middle = cells / 2 / block_size;
  rows_.impulse.row()[-1] = rows_.impulse.row()[size_ - 1] = 0;
  const std::ptrdiff_t turns = std::max(middle, blocks() - 1 - middle);
  for (std::ptrdiff_t turn = 0; turn <= turns; ++turn) {
    const std::ptrdiff_t f = middle - turn;
    const std::ptrdiff_t b = middle + turn;
    sweep_.substitute(std::max<std::ptrdiff_t>(f * block_size - 1, 0), std::min((b + 1) * block_size, cells));
    if (f >= 0) use(f);
    if (b < blocks() && turn > 0) use(b);
  }
}

void Model::fused_step(Interval when, Output q, Output u, Input target, Output multipliers) {
  const double tau = when.length;
  double* const x = q.data();
  double* const y = q.data() + n_;
  double* const p = u.data();
  double* const r = u.data() + n_;
  const auto prepare = [&](std::ptrdiff_t block) {
    const bool level_now = sample(block, x, bed_elsewhere());
    advance_rows(other_bed_, level_now, markers_of(block), x, y, p, r, tau / 2, rows_.x.row(), rows_.y.row());
    level_[static_cast<std::size_t>(block)] = sample(block, rows_.x.row(), rows_.bed);
  };
  assemble_from_both_ends(tau / 2, u, target, nullptr, prepare);
  double* const mean_p = rows_.star_p.row();
  double* const mean_r = rows_.star_r.row();
  substitute_from_the_middle([&](std::ptrdiff_t block) {
    const Range markers = markers_of(block);
    react_rows(rows_, level(block), markers, rows_.impulse.row(), mean_p, mean_r);
    advance_rows(rows_.bed, level(block), markers, x, y, mean_p, mean_r, tau, x, y);
    reflect_rows(markers, mean_p, mean_r, p, r);
    scale_row(cells_of(block), 2 / tau, rows_.impulse.row(), multipliers.data());
  });
}

mechanics::SweepChange Model::fused_sweep(Interval when, Input q0, Output q1, Input u0, Output mean, Input target,
                                          Output mu, int sweep) {
  const Segment segment{q0, q1};
  const auto prepare = [&](std::ptrdiff_t block) {
    place_between(block, q0, q1);
    mean_bed(block, q0, q1, sweep < sweeps_with_new_frames);
  };
  assemble_from_both_ends(when.length / 2, u0, target, &segment, prepare);
  double* const p = rows_.star_p.row();
  double* const r = rows_.star_r.row();
  mechanics::SweepChange change;
  substitute_from_the_middle([&](std::ptrdiff_t block) {
    const Range markers = markers_of(block);
    react_rows(rows_, level(block), markers, rows_.impulse.row(), p, r);
    const RowChange along = replace_row(markers, p, mean.data());
    const RowChange across = replace_row(markers, r, mean.data() + n_);
    change.largest_change = std::max({change.largest_change, along.change, across.change});
    change.largest_rate = std::max({change.largest_rate, along.value, across.value});
    advance_rows(rows_.bed, level(block), markers, q0.data(), q0.data() + n_, p, r, when.length, q1.data(),
                 q1.data() + n_);
    const Range cells = cells_of(block);
    std::copy(rows_.impulse.row() + cells.first, rows_.impulse.row() + cells.last, mu.data() + cells.first);
  });
  return change;
}

}  // namespace seiche::dispersive_shallow_water_1d
