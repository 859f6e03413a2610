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
    const std::size_t begin = p * n;
    const std::size_t cells = std::min(n, (end.reversed ? begin + n : s.front_cells_) - begin);
    const std::ptrdiff_t sign = end.reversed ? -1 : 1;
    const std::ptrdiff_t along = sign * static_cast<std::ptrdiff_t>(s.along_);
    const std::ptrdiff_t line_feed = sign * static_cast<std::ptrdiff_t>(s.across_ - s.along_ * s.line_);
    std::ptrdiff_t cell_index[n];
    std::ptrdiff_t c = end.columns[p].cell;
    std::size_t in_line = end.columns[p].in_line;
    for (std::size_t i = 0; i < cells; ++i) {
      cell_index[i] = c;
      c += along;
      if (++in_line == s.line_) {
        in_line = 0;
        c += line_feed;
      }
    }
    const bool along_x = s.along_ == 1;
    const std::array<const double*, couplings> coefficients = {
        a[a.own], a[along_x ? a.right : a.up] + end.next, a[a.up_left] + end.behind,
        a[along_x ? a.up : a.right] + end.across, a[a.up_right] + end.ahead};
    double* const entry = column->entry;
    for (std::size_t k = 0; k < couplings; ++k) {
      const double* const from = coefficients[k];
      const std::size_t* const place = s.place_[k].data();
      if (p < s.each_ && s.line_ > 2) {
        for (std::size_t i = 0; i < n; ++i) entry[place[i]] = from[cell_index[i]];
      } else {
        for (std::size_t i = 0; i < cells; ++i) entry[place[i]] += from[cell_index[i]];
      }
    }
    if (p >= s.each_) {
      // Couplings of the middle with the back are the back's; what fills the last block is coupled with nothing.
      Block& last = column[s.front_.columns.size() - 1 - p];
      for (std::size_t row = (s.front_cells_ - 1) % n + 1; row < n; ++row) {
        for (std::size_t i = 0; i < n; ++i) last.entry[i * n + row] = 0;
        if (&last == column) last.entry[row * n + row] = 1;
      }
    }
    for (const auto [below, above] : s.mirror_) entry[above] = entry[below];
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
    const std::size_t cells = s.front_cells_ - s.each_ * n;
    for (std::size_t e = 0; e < (s.most_reach_ - t) * n * n; ++e) {
      const std::size_t from_end_row = (t + e / (n * n)) * n + e % n;
      const std::size_t from_end_column = t * n + e / n % n;
      if (from_end_row < from_end_column || from_end_row >= cells) continue;
      // The order is reversed: row and column change places in the lower triangle.
      const std::size_t row = cells - 1 - from_end_column;
      const std::size_t in = cells - 1 - from_end_row;
      Block* const to = &s.middle_[in / n * (s.most_reach_ + 2)];
      to[row / n - in / n].entry[in % n * n + row % n] = column->entry[e];
      if (row / n == in / n) to->entry[row % n * n + in % n] = column->entry[e];
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
    sums.assign(end.minus_inverse[p], x[p]);
    for (std::size_t v = 0; v < end.columns[p].reach; ++v) sums.add(lower[v], x[p + 1 + v]);
    sums.negative(x[p]);
  }

  /// The first pivot that was not positive and finite; no end if there is none.
  struct Failure {
    const End* end = nullptr;
    std::size_t number = 0;
    double pivot = 1;
  };
  [[gnu::always_inline]] static bool check(const End& end, std::size_t p, const double (&pivot)[n], Failure& failure) {
    double smallest = pivot[0];
    double sum = 0;  // not finite if one is not
    for (std::size_t k = 0; k < n; ++k) {
      smallest = pivot[k] < smallest ? pivot[k] : smallest;
      sum += pivot[k];
    }
    if (smallest > 0 && is_good(sum)) return true;
    for (std::size_t k = 0; k < n; ++k) {
      if (is_good(pivot[k])) continue;
      failure = {&end, p * n + k, pivot[k]};
      return false;
    }
    return true;
  }

  static Failure factor(NinePointCholesky& s, const StencilMatrix& a);
  static void substitute(const NinePointCholesky& s);
};

SEICHE_SIMD_CLONES NinePointCholesky::Kernels::Failure NinePointCholesky::Kernels::factor(NinePointCholesky& s,
                                                                                          const StencilMatrix& a) {
  End& front = s.front_;
  End& back = s.back_;
  Failure failure;
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
    if (!check(front, p, pivot[0], failure) || !check(back, p, pivot[1], failure)) return failure;
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
    if (!check(front, p, last[0], failure)) return failure;
    divide(s, front, p);
  }
  return failure;
}

SEICHE_SIMD_CLONES void NinePointCholesky::Kernels::substitute(const NinePointCholesky& s) {
  Segment* const front = s.front_.x.data();
  Segment* const back = s.back_.x.data();
  for (std::size_t p = 0; p < s.each_; ++p) {
    forward(s.front_, p, front);
    forward(s.back_, p, back);
  }
  // The cells that the back is coupled with are the last of the middle.
  double* const last = front->entry + s.front_cells_ - 1;
  double* const shared = back[s.each_].entry;
  const std::size_t cells = std::min(s.most_reach_ * n, s.front_cells_ - s.each_ * n);
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
    : columns_(columns),
      rows_(rows),
      line_(std::min(columns, rows)),
      along_(columns <= rows ? 1 : columns),
      across_(columns <= rows ? columns : 1) {
  require_at_least("columns", static_cast<long>(columns), 1);
  require_at_least("rows", static_cast<long>(rows), 1);
  // The middle has to part the two ends: a line and a cell at least.
  const std::size_t middle = line_ + 1;
  each_ = size() > middle ? (size() - middle) / (2 * Block::n) : 0;
  front_cells_ = size() - each_ * Block::n;

  const auto along = static_cast<std::ptrdiff_t>(along_);
  const auto across = static_cast<std::ptrdiff_t>(across_);
  // Along y the neighbour behind, (i + 1, j - 1), is the one that has the coupling.
  const std::ptrdiff_t behind = along_ == 1 ? 0 : across - along;
  front_.behind = behind;
  back_.reversed = true;
  back_.next = -along;
  back_.across = -across;
  back_.ahead = -along - across;
  back_.behind = behind + along - across;
  lay_out(front_, front_cells_, (front_cells_ + Block::n - 1) / Block::n);
  lay_out(back_, size(), each_);
  ring_ = std::bit_ceil(most_reach_ + 2) - 1;
  for (End* const end : {&front_, &back_}) end->recent.resize((ring_ + 1) * (most_reach_ + 2));
  back_.x.resize(each_ + most_reach_ + 1);
  front_.x.resize(front_.columns.size() + 1);
  middle_.resize((front_.columns.size() - each_) * (most_reach_ + 2));

  const std::array<std::size_t, couplings> distance = {0, 1, line_ - 1, line_, line_ + 1};
  for (std::size_t k = 0; k < couplings; ++k) {
    for (std::size_t i = 0; i < Block::n; ++i) {
      const std::size_t row = i + distance[k];
      place_[k][i] = row / Block::n * Block::n * Block::n + i * Block::n + row % Block::n;
      if (row > i && row < Block::n) mirror_.push_back({i * Block::n + row, row * Block::n + i});
    }
  }
}

/// Block columns as far as couplings with `cells` cells reach, also those that arise by elimination.
void NinePointCholesky::lay_out(End& end, std::size_t cells, std::size_t blocks) {
  std::size_t first = 0;
  for (std::size_t p = 0; p < blocks; ++p) {
    const std::size_t last = std::min((p + 1) * Block::n, cells) - 1;
    const std::size_t coupled = std::min(last + line_ + (last % line_ + 1 < line_ ? 1 : 0), cells - 1);
    end.columns.push_back(
        {first, coupled / Block::n - p, static_cast<std::ptrdiff_t>(cell(end, p * Block::n)), p * Block::n % line_});
    first += end.columns.back().reach;
    most_reach_ = std::max(most_reach_, end.columns.back().reach);
  }
  end.minus_inverse.resize(blocks);
  end.lower.resize(first);
}

std::size_t NinePointCholesky::cell(const End& end, std::size_t number) const {
  const std::size_t c = number / line_ * across_ + number % line_ * along_;
  return end.reversed ? size() - 1 - c : c;
}

void NinePointCholesky::factor(const StencilMatrix& a) {
  require_that(a.columns() == columns_ && a.rows() == rows_ && a.layers() == 1,
               "matrix of a {} x {} x {} lattice; expected {} x {} x 1", a.columns(), a.rows(), a.layers(), columns_,
               rows_);
  const Kernels::Failure failure = Kernels::factor(*this, a);
  if (failure.end != nullptr) throw NotPositiveDefinite(cell(*failure.end, failure.number), failure.pivot);
}

/// action(number, cell) for every cell; those of the back are numbered backwards.
template <class Action>
void NinePointCholesky::for_each_cell(const Action& action) const {
  double* const front = front_.x.data()->entry;
  double* const back_end = back_.x.data()->entry + size() - 1;
  std::size_t number = 0;
  for (std::size_t line = 0; number < size(); ++line) {
    std::size_t c = line * across_;
    const std::size_t next = number + line_;
    for (; number < std::min(next, front_cells_); ++number, c += along_) action(front[number], c);
    for (; number < next; ++number, c += along_) action(*(back_end - number), c);
  }
}

FactorWork NinePointCholesky::work() const {
  constexpr double product = 2.0 * Block::n * Block::n * Block::n;
  FactorWork work;
  const auto add = [&](const BlockColumn& column) {
    const auto below = static_cast<double>(column.reach);
    work.entries += (below + 1) * Block::n * Block::n;
    work.operations += (below * (below + 1) / 2 + below + 1) * product;  // updates, division, inverse
  };
  for (const BlockColumn& column : front_.columns) add(column);
  for (const BlockColumn& column : back_.columns) add(column);
  return work;
}

void NinePointCholesky::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  std::fill(front_.x.end() - 2, front_.x.end(), Segment{});
  std::fill(back_.x.begin() + static_cast<std::ptrdiff_t>(each_), back_.x.end(), Segment{});
  const double* const from = right_hand_side.data();
  double* const to = x.data();
  for_each_cell([&](double& value, std::size_t c) { value = from[c]; });
  Kernels::substitute(*this);
  for_each_cell([&](double& value, std::size_t c) { to[c] = value; });
}

}  // namespace seiche::linear
