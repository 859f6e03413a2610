#include "seiche/linear/nine_point_cholesky.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <fmt/format.h>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

bool is_good(double pivot) {
  return pivot > 0 && pivot < std::numeric_limits<double>::infinity();
}

}  // namespace

/// Loops over blocks, compiled for each instruction set; what they call is inlined into them.
struct NinePointCholesky::Kernels {
  static constexpr std::size_t n = Block::n;
  /// Block column p of A. Coefficients outside the lattice are zero, so their places do not matter.
  [[gnu::noinline]] static void load(const NinePointCholesky& s, const StencilMatrix& a, End& end, std::size_t p) {
    Block* const column = s.recent(end, p);
    if (p < s.each_) {
      std::fill_n(column->entry, (end.columns[p].reach + 1) * n * n, 0.0);
    } else {
      const Block* const from = &s.middle_[(p - s.each_) * (s.most_reach_ + 2)];
      std::copy(from, from + s.most_reach_ + 2, column);
    }
    const std::size_t* const cell = end.cells.data() + p * n;
    const std::size_t cells = std::min(n, end.cells.size() - p * n);
    const bool along_x = s.columns_ <= s.rows_;
    const std::array coefficients{a[a.own], a[along_x ? a.right : a.up], a[a.up_left], a[along_x ? a.up : a.right],
                                  a[a.up_right]};
    const std::array distance{std::size_t{0}, std::size_t{1}, s.line_ - 1, s.line_, s.line_ + 1};
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      for (std::size_t i = 0; i < cells; ++i) {
        const std::size_t row = i + distance[k];
        column[row / n].entry[i * n + row % n] += coefficients[k][static_cast<std::ptrdiff_t>(cell[i] + end.offset[k])];
      }
    }
    if (p >= s.each_) {
      // Couplings of the middle with the back are the back's; what fills the last block is coupled with nothing.
      Block& last = column[s.front_.columns.size() - 1 - p];
      for (std::size_t row = (s.front_.cells.size() - 1) % n + 1; row < n; ++row) {
        for (std::size_t i = 0; i < n; ++i) last.entry[i * n + row] = 0;
        if (&last == column) last.entry[row * n + row] = 1;
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t row = i + 1; row < n; ++row) column->entry[row * n + i] = column->entry[i * n + row];
    }
  }

  /// U_ip = A_ip - sum_q L_iq U_pq^T over q < last, in place
  [[gnu::always_inline]] static void subtract_previous(const NinePointCholesky& s, End& end, std::size_t p,
                                                       std::size_t last) {
    Block* const column = s.recent(end, p);
    for (std::size_t q = p - std::min(p, s.most_reach_); q < last; ++q) {
      const Block* const lower = end.lower.data() + end.columns[q].first;
      const Block& upper = s.recent(end, q)[p - q];
      for (std::size_t v = p - q; v <= end.columns[q].reach; ++v) {
        dense_block::subtract_product(lower[v - 1], upper, column[v - (p - q)]);
      }
    }
  }

  /// L_ip = U_ip D_p^-1
  [[gnu::always_inline]] static void divide(const NinePointCholesky& s, End& end, std::size_t p) {
    const Block* const upper = s.recent(end, p);
    Block* const lower = end.lower.data() + end.columns[p].first;
    for (std::size_t v = 1; v <= end.columns[p].reach; ++v) {
      dense_block::subtract_product<true>(upper[v], end.minus_inverse[p], lower[v - 1]);
    }
  }

  /// Puts what the back's elimination leaves into block column t of the middle, turned to the numbering of the front.
  [[gnu::noinline]] static void turn(NinePointCholesky& s, std::size_t t) {
    const Block* const column = s.recent(s.back_, s.each_ + t);
    const std::size_t cells = s.front_.cells.size() - s.each_ * n;
    for (std::size_t e = 0; e < (s.most_reach_ - t) * n * n; ++e) {
      const std::size_t from_end_row = (t + e / (n * n)) * n + e % n;
      const std::size_t from_end_column = t * n + e / n % n;
      if (from_end_row < from_end_column || from_end_row >= cells) continue;
      // The order is reversed: row and column change places in the lower triangle.
      const std::size_t row = cells - 1 - from_end_column;
      const std::size_t in = cells - 1 - from_end_row;
      Block* const to = &s.middle_[in / n * (s.most_reach_ + 2)];
      to[row / n - in / n].entry[in % n * n + row % n] = column->entry[e];
    }
  }

  [[gnu::always_inline]] static void forward(const End& end, std::size_t p, Segment* x) {
    const Block* const lower = end.lower.data() + end.columns[p].first;
    for (std::size_t v = 0; v < end.columns[p].reach; ++v) dense_block::subtract_product(lower[v], x[p], x[p + 1 + v]);
  }

  /// x_p = D_p^-1 x_p - sum_i L_ip^T x_i
  [[gnu::always_inline]] static void backward(const End& end, std::size_t p, Segment* x) {
    const Block* const lower = end.lower.data() + end.columns[p].first;
    dense_block::RowSums sums;
    sums.add(end.minus_inverse[p], x[p]);
    for (std::size_t v = 0; v < end.columns[p].reach; ++v) sums.add(lower[v], x[p + 1 + v]);
    sums.negative(x[p]);
  }

  /// Throws NotPositiveDefinite at the first pivot that is not positive and finite.
  [[gnu::always_inline]] static void check(const End& end, std::size_t p, const double (&pivot)[n]) {
    const double* const bad = std::find_if_not(pivot, pivot + n, is_good);
    if (bad == pivot + n) return;
    throw NotPositiveDefinite(end.cells[p * n + static_cast<std::size_t>(bad - pivot)], *bad);
  }

  static void factor(NinePointCholesky& s, const StencilMatrix& a);
  static void substitute(const NinePointCholesky& s);
};

SEICHE_SIMD_CLONES void NinePointCholesky::Kernels::factor(NinePointCholesky& s, const StencilMatrix& a) {
  End& front = s.front_;
  End& back = s.back_;
  double pivot[2][n];
  if (s.each_ > 0) {
    load(s, a, front, 0);
    load(s, a, back, 0);
  }
  for (std::size_t p = 0; p < s.each_; ++p) {
    subtract_previous(s, front, p, p);
    subtract_previous(s, back, p, p);
    front.minus_inverse[p] = *s.recent(front, p);
    back.minus_inverse[p] = *s.recent(back, p);
    // Stored number by number and soon read in vectors: here, so that it has arrived by then.
    if (p + 1 < s.each_) {
      load(s, a, front, p + 1);
      load(s, a, back, p + 1);
    }
    dense_block::invert<2>({&front.minus_inverse[p], &back.minus_inverse[p]}, pivot);
    check(front, p, pivot[0]);
    check(back, p, pivot[1]);
    divide(s, front, p);
    divide(s, back, p);
  }
  for (std::size_t t = 0; t < s.most_reach_; ++t) {
    std::fill_n(s.recent(back, s.each_ + t)->entry, (s.most_reach_ + 1) * n * n, 0.0);
    subtract_previous(s, back, s.each_ + t, s.each_);
    turn(s, t);
  }
  double last[1][n];
  for (std::size_t p = s.each_; p < front.columns.size(); ++p) {
    load(s, a, front, p);
    subtract_previous(s, front, p, p);
    front.minus_inverse[p] = *s.recent(front, p);
    dense_block::invert<1>({&front.minus_inverse[p]}, last);
    check(front, p, last[0]);
    divide(s, front, p);
  }
}

SEICHE_SIMD_CLONES void NinePointCholesky::Kernels::substitute(const NinePointCholesky& s) {
  Segment* const front = s.front_.x.data();
  Segment* const back = s.back_.x.data();
  for (std::size_t p = 0; p < s.each_; ++p) {
    forward(s.front_, p, front);
    forward(s.back_, p, back);
  }
  // The cells that the back is coupled with are the last of the middle.
  double* const last = front->entry + s.front_.cells.size() - 1;
  double* const shared = back[s.each_].entry;
  const std::size_t cells = std::min(s.most_reach_ * n, s.front_.cells.size() - s.each_ * n);
  for (std::size_t t = 0; t < cells; ++t) *(last - t) += shared[t];
  for (std::size_t p = s.each_; p < s.front_.columns.size(); ++p) forward(s.front_, p, front);
  for (std::size_t p = s.front_.columns.size(); p-- > s.each_;) backward(s.front_, p, front);
  for (std::size_t t = 0; t < cells; ++t) shared[t] = *(last - t);
  for (std::size_t p = s.each_; p-- > 0;) {
    backward(s.front_, p, front);
    backward(s.back_, p, back);
  }
}

NinePointCholesky::NinePointCholesky(std::size_t columns, std::size_t rows)
    : columns_(columns), rows_(rows), line_(std::min(columns, rows)) {
  require_at_least("columns", static_cast<long>(columns), 1);
  require_at_least("rows", static_cast<long>(rows), 1);
  // The middle has to part the two ends: a line and a cell at least.
  const std::size_t middle = line_ + 1;
  each_ = size() > middle ? (size() - middle) / (2 * Block::n) : 0;
  // From a cell to the next of its line, and to its neighbour in the next line.
  const std::size_t along = columns <= rows ? 1 : columns;
  const std::size_t across = columns <= rows ? columns : 1;
  // Offsets below zero wrap around. Along y the neighbour behind, (i + 1, j - 1), is the one that has the coupling.
  const std::size_t behind = along == 1 ? 0 : across - along;
  front_.offset = {0, 0, behind, 0, 0};
  back_.offset = {0, -along, behind + along - across, -across, -along - across};
  for (std::size_t number = 0; number < size(); ++number) {
    const std::size_t cell = number / line_ * across + number % line_ * along;
    if (number + each_ * Block::n < size()) front_.cells.push_back(cell);
    if (number < each_ * Block::n) back_.cells.push_back(size() - 1 - cell);
  }
  lay_out(front_, front_.cells.size());
  lay_out(back_, size());
  ring_ = std::bit_ceil(most_reach_ + 2) - 1;
  for (End* const end : {&front_, &back_}) end->recent.resize((ring_ + 1) * (most_reach_ + 2));
  back_.x.resize(each_ + most_reach_ + 1);
  front_.x.resize(front_.columns.size() + 1);
  middle_.resize((front_.columns.size() - each_) * (most_reach_ + 2));
}

/// Block columns as far as couplings with `cells` cells reach, also those that arise by elimination.
void NinePointCholesky::lay_out(End& end, std::size_t cells) {
  std::size_t first = 0;
  for (std::size_t p = 0; p * Block::n < end.cells.size(); ++p) {
    const std::size_t last = std::min((p + 1) * Block::n, cells) - 1;
    const std::size_t coupled = std::min(last + line_ + (last % line_ + 1 < line_ ? 1 : 0), cells - 1);
    end.columns.push_back({first, coupled / Block::n - p});
    first += end.columns.back().reach;
    most_reach_ = std::max(most_reach_, end.columns.back().reach);
  }
  end.minus_inverse.resize(end.columns.size());
  end.lower.resize(first);
}

void NinePointCholesky::factor(const StencilMatrix& a) {
  require_that(a.columns() == columns_ && a.rows() == rows_ && a.layers() == 1,
               "matrix of a {} x {} x {} lattice; expected {} x {} x 1", a.columns(), a.rows(), a.layers(), columns_,
               rows_);
  Kernels::factor(*this, a);
}

void NinePointCholesky::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  std::fill(front_.x.end() - 2, front_.x.end(), Segment{});
  std::fill(back_.x.begin() + static_cast<std::ptrdiff_t>(each_), back_.x.end(), Segment{});
  for (End* const end : {&front_, &back_}) {
    double* const numbers = end->x.front().entry;
    for (std::size_t k = 0; k < end->cells.size(); ++k) numbers[k] = right_hand_side[end->cells[k]];
  }
  Kernels::substitute(*this);
  for (const End* const end : {&front_, &back_}) {
    const double* const numbers = end->x.front().entry;
    for (std::size_t k = 0; k < end->cells.size(); ++k) x[end->cells[k]] = numbers[k];
  }
}

}  // namespace seiche::linear
