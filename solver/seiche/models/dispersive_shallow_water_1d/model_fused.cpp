// Steps in two passes over memory: see TwoEndedSweep.
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include <omp.h>

#include "seiche/flush_denormals.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::dispersive_shallow_water_1d {
namespace {

/// front() and back() by a thread each; what they throw is thrown again, the front's first.
template <class Front, class Back>
void by_two_threads(const Front& front, const Back& back) {
  std::array<std::exception_ptr, 2> thrown;
  const auto keep = [](const auto& work, std::exception_ptr& what) {
    const FlushDenormals guard;
    try {
      work();
    } catch (...) {
      what = std::current_exception();
    }
  };
#pragma omp parallel sections num_threads(2)
  {
#pragma omp section
    keep(front, thrown[0]);
#pragma omp section
    keep(back, thrown[1]);
  }
  for (const std::exception_ptr& what : thrown) {
    if (what) std::rethrow_exception(what);
  }
}

}  // namespace

/// Each end is a chain of its own; one thread works on both at once instead, which small channels gain more from.
bool Model::two_threads() const {
  return n_ >= linear::worth_threads && blocks() > 3 && omp_get_max_threads() > 1;
}

bool Model::fuses_step() const {
  return !channel_.periodic() && channel_.gamma == 0 && !forcing_.surface_pressure && !forcing_.body_force;
}

/// Rows of A mu = target - J u*, u* = u + h W F, for the cells that begin in the block. The marker after the block and
/// the cells beside it are made here too: they cost less than waiting for the neighbour.
void Model::assemble_block(std::ptrdiff_t block, double h, Input rates, const double* target, const Segment* segment,
                           Desk& desk) {
  const Range markers = markers_of(block);
  const Range cells = cells_of(block);
  const auto all_cells = static_cast<std::ptrdiff_t>(cells_);
  const Range wide_markers{markers.first, std::min(markers.last + 1, size_)};
  const Range wide_cells{std::max<std::ptrdiff_t>(markers.first - 1, 0), std::min(markers.last + 1, all_cells)};
  measure_cells(rows_, wide_cells);
  close(block, segment);
  if (wide_markers.last == size_) close(blocks() - 1, segment);
  const auto count = static_cast<std::size_t>(wide_markers.last - wide_markers.first);
  desk.force_x.resize(count);
  desk.force_y.resize(count);
  const Forces forces{desk.force_x.data(), desk.force_y.data()};
  gravity_forces(rows_, wide_markers, weights_, forces);
  if (segment != nullptr) {
    add_increment_forces(rows_, wide_markers, weights_, forces);
    if (wide_markers.first == 0) desk.force_x.front() += release_at_end(0, 1);
    if (wide_markers.last == size_) desk.force_x.back() += release_at_end(size_ - 1, -1);
  }

  double* const p = rows_.star_p.row();
  double* const r = rows_.star_r.row();
  double* const w = rows_.impulse.row();
  std::copy_n(rates.data() + markers.first, count, p + markers.first);
  std::copy_n(rates.data() + n_ + static_cast<std::size_t>(markers.first), count, r + markers.first);
  kick_rows(rows_, level(block), markers, {forces.x, forces.y}, h, p, r);
  if (wide_markers.last > markers.last) {
    kick_rows(rows_, level(block + 1), {markers.last, wide_markers.last}, {&desk.force_x.back(), &desk.force_y.back()},
              h, p, r);
  }

  over_cells(block, [&](bool level_cells, Range range) {
    assemble(rows_, level_cells, range);
    rates_of_cells(rows_, level_cells, range, p, r, w);
  });
  aim(cells, target, w);
  couple(rows_, level(block), markers);

  const bool left_tip = markers.first == 0 && channel_.left == End::tip;
  const bool right_tip = markers.last == size_ && channel_.right == End::tip;
  const Smallest found =
      smallest(rows_, cells, {markers.first + (left_tip ? 1 : 0), markers.last - (right_tip ? 1 : 0)});
  desk.found.depth = std::min(desk.found.depth, found.depth);
  desk.found.width = std::min(desk.found.width, found.width);
}

template <class Prepare>
void Model::assemble_from_both_ends(double h, Input rates, Input target, const Segment* segment,
                                    const Prepare& prepare) {
  const std::ptrdiff_t last = blocks() - 1;
  auto& [from_front, from_back] = desks_;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  from_front.found = from_back.found = {infinity, infinity};
  sweep_.begin({.diagonal = rows_.diagonal.row(),
                .off_diagonal = rows_.coupling.row(),
                .right_hand_side = rows_.impulse.row(),
                .multiplier = rows_.coupling.row(),
                .x = rows_.impulse.row()},
               static_cast<std::ptrdiff_t>(cells_));
  const double* const aims = target.empty() ? nullptr : target.data();
  // Blocks [0, front) and (back, last] are prepared, one more than are assembled.
  std::ptrdiff_t front = 0;
  std::ptrdiff_t back = last;
  const auto prepare_front = [&](std::ptrdiff_t to) {
    for (; front <= std::min(to, back); ++front) prepare(front, from_front);
  };
  const auto prepare_back = [&](std::ptrdiff_t to) {
    for (; back >= std::max(to, front); --back) prepare(back, from_back);
  };
  std::ptrdiff_t f = 0;
  if (two_threads()) {
    // As far as the ends do not see each other.
    const std::ptrdiff_t apart = (blocks() - 2) / 2;
    const auto work = [&](std::ptrdiff_t begin, std::ptrdiff_t step, Desk& desk, const auto& eliminate) {
      prepare(begin, desk);
      for (std::ptrdiff_t k = 0; k < apart; ++k) {
        prepare(begin + (k + 1) * step, desk);
        assemble_block(begin + k * step, h, rates, aims, segment, desk);
        eliminate(cells_of(begin + k * step));
      }
    };
    by_two_threads([&] { work(0, 1, from_front, [&](Range cells) { sweep_.eliminate_front(cells.last); }); },
                   [&] { work(last, -1, from_back, [&](Range cells) { sweep_.eliminate_back(cells.first); }); });
    f = apart;
    front = apart + 1;
    back = last - apart - 1;
  }
  for (std::ptrdiff_t b = last - f; f <= b; ++f, --b) {
    prepare_front(f + 1);
    prepare_back(b - 1);
    assemble_block(f, h, rates, aims, segment, from_front);
    if (b > f) assemble_block(b, h, rates, aims, segment, from_back);
    if (f + 1 < b) {
      sweep_.eliminate(cells_of(f).last, cells_of(b).first);
    } else {  // all rows are there
      sweep_.eliminate(static_cast<std::ptrdiff_t>(cells_), 0);
    }
  }
  ++solves_;
  const Smallest found{.width = std::min(from_front.found.width, from_back.found.width),
                       .depth = std::min(from_front.found.depth, from_back.found.depth)};
  if (!(found.width > 0 && found.depth > 0)) require_sound();
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
  smallest_depth_ = found.depth;
}

/// use(block, desk) as soon as the impulses of all cells beside the block's markers are there.
template <class Use>
void Model::substitute_from_the_middle(const Use& use) {
  const auto cells = static_cast<std::ptrdiff_t>(cells_);
  const std::ptrdiff_t last = blocks() - 1;
  const std::ptrdiff_t middle = cells / 2 / block_size();
  auto& [to_front, to_back] = desks_;
  rows_.impulse.row()[-1] = rows_.impulse.row()[size_ - 1] = 0;
  const auto first_of = [&](std::ptrdiff_t block) { return std::max<std::ptrdiff_t>(block * block_size() - 1, 0); };
  const auto last_of = [&](std::ptrdiff_t block) { return std::min((block + 1) * block_size(), cells); };
  sweep_.substitute(first_of(middle), last_of(middle));
  use(middle, to_front);
  if (two_threads()) {
    by_two_threads(
        [&] {
          for (std::ptrdiff_t block = middle - 1; block >= 0; --block) {
            sweep_.substitute_front(first_of(block));
            use(block, to_front);
          }
        },
        [&] {
          for (std::ptrdiff_t block = middle + 1; block <= last; ++block) {
            sweep_.substitute_back(last_of(block));
            use(block, to_back);
          }
        });
    return;
  }
  for (std::ptrdiff_t f = middle - 1, b = middle + 1; f >= 0 || b <= last; --f, ++b) {
    sweep_.substitute(first_of(f), last_of(b));
    if (f >= 0) use(f, to_front);
    if (b <= last) use(b, to_back);
  }
}

void Model::fused_step(Interval when, Output q, Output u, Input target, Output multipliers) {
  const double tau = when.length;
  double* const x = q.data();
  double* const y = q.data() + n_;
  double* const p = u.data();
  double* const r = u.data() + n_;
  const auto prepare = [&](std::ptrdiff_t block, Desk& desk) {
    move_block(block, q, u, tau / 2, rows_.x.row(), rows_.y.row(), desk);
    level_[static_cast<std::size_t>(block)] =
        sample(block, rows_.x.row(), rows_.bed, markers_of(block).first, desk.slope);
  };
  assemble_from_both_ends(tau / 2, u, target, nullptr, prepare);
  double* const mean_p = rows_.star_p.row();
  double* const mean_r = rows_.star_r.row();
  substitute_from_the_middle([&](std::ptrdiff_t block, Desk&) {
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
  const auto prepare = [&](std::ptrdiff_t block, Desk& desk) {
    place_between(block, q0, q1);
    mean_bed(block, q0, q1, sweep < sweeps_with_new_frames, desk);
  };
  assemble_from_both_ends(when.length / 2, u0, target, &segment, prepare);
  double* const p = rows_.star_p.row();
  double* const r = rows_.star_r.row();
  for (Desk& desk : desks_) desk.change = {};
  substitute_from_the_middle([&](std::ptrdiff_t block, Desk& desk) {
    const Range markers = markers_of(block);
    react_rows(rows_, level(block), markers, rows_.impulse.row(), p, r);
    const RowChange along = replace_row(markers, p, mean.data());
    const RowChange across = replace_row(markers, r, mean.data() + n_);
    mechanics::SweepChange& change = desk.change;
    change.largest_change = std::max({change.largest_change, along.change, across.change});
    change.largest_rate = std::max({change.largest_rate, along.value, across.value});
    advance_rows(rows_.bed, level(block), markers, q0.data(), q0.data() + n_, p, r, when.length, q1.data(),
                 q1.data() + n_);
    const Range cells = cells_of(block);
    std::copy(rows_.impulse.row() + cells.first, rows_.impulse.row() + cells.last, mu.data() + cells.first);
  });
  const auto& [front, back] = desks_;
  return {std::max(front.change.largest_change, back.change.largest_change),
          std::max(front.change.largest_rate, back.change.largest_rate)};
}

}  // namespace seiche::dispersive_shallow_water_1d
