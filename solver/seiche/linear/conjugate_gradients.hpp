/// Preconditioned conjugate gradients for A x = b, A symmetric positive definite.
///
/// With z = P r the preconditioned residual and p the direction, an iteration is
///
///     alpha = z.r / p.Ap,   x += alpha p,   r -= alpha Ap,   z = P r,   beta = z_new.(r_new - r) / z.r,   p = z_new +
///     beta p
///
/// This beta (Polak-Ribiere; flexible conjugate gradients) bears a preconditioner that is symmetric only to single
/// precision, which z_new.r_new / z.r does not. Here r_new - r = -alpha Ap, so that it costs no further vector.
///
/// The residual is followed by its recurrence. It leaves the true one, b - A x, by round-off: a few units in the last
/// place of |A| |x|.
///
/// References: Hestenes & Stiefel, Methods of conjugate gradients for solving linear systems, J. Res. NBS 49 (1952)
/// 409; Golub & Ye, Inexact preconditioned conjugate gradient method with inner-outer iteration, SIAM J. Sci. Comput.
/// 21 (1999) 1305; Notay, Flexible conjugate gradients, SIAM J. Sci. Comput. 22 (2000) 1444.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace seiche::linear {

// Symmetric matrices that couple a cell of a lattice with its eight neighbours in a plane, or its 26 in space, and the
// arrays that they are stored in.

inline constexpr std::size_t cache_line = 8;  // numbers in it
/// At least `numbers`, an odd number of lines of the cache: arrays so far from each other fall on different ones.
constexpr std::size_t odd_lines(std::size_t numbers) {
  return ((numbers + cache_line - 1) / cache_line | 1) * cache_line;
}

/// Several numbers per cell of a lattice, row by row: all numbers of one row of cells lie together.
///
/// Loops over a row then read as many streams as there are numbers from a few pages, and the streams fall on different
/// lines of the cache: the distance between them is an odd number of lines. Every row has zeros before its first and
/// after its last cell, which nobody writes, and there is one row of zeros to stand for rows outside the lattice.
class RowBlocks {
 public:
  RowBlocks() = default;
  RowBlocks(std::size_t columns, std::size_t rows, std::size_t numbers)
      : numbers_(numbers),
        rows_(rows),
        stride_(odd_lines(columns + 2 * margin)),
        values_((rows + 1) * numbers * stride_, 0.0) {}

  /// Numbers of one row; number k of cell i is at data[k stride + i], -1 <= i <= columns.
  template <class Number>
  struct Numbers {
    Number* data;
    std::size_t stride;
    [[nodiscard]] Number* operator[](std::size_t number) const { return data + number * stride; }
  };
  using Row = Numbers<double>;
  using ConstRow = Numbers<const double>;

  [[nodiscard]] Row row(std::size_t r) { return {values_.data() + begin(r), stride_}; }
  [[nodiscard]] ConstRow row(std::size_t r) const { return {values_.data() + begin(r), stride_}; }
  [[nodiscard]] ConstRow zeros() const { return row(rows_); }

 private:
  static constexpr std::size_t margin = cache_line;

  [[nodiscard]] std::size_t begin(std::size_t r) const { return r * numbers_ * stride_ + margin; }

  std::size_t numbers_ = 0;
  std::size_t rows_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> values_;
};

/// An array of one number per cell with a margin of zeros before and after, so that data()[-margin] may be read.
class LatticeArray {
 public:
  LatticeArray() = default;
  LatticeArray(std::size_t columns, std::size_t rows)
      : margin_(columns + 1), size_(columns * rows), values_(size_ + 2 * margin_, 0.0) {}

  [[nodiscard]] double* data() { return values_.data() + margin_; }
  [[nodiscard]] const double* data() const { return values_.data() + margin_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<double> values() { return {data(), size_}; }
  [[nodiscard]] std::span<const double> values() const { return {data(), size_}; }

 private:
  std::size_t margin_ = 0;
  std::size_t size_ = 0;
  std::vector<double> values_;
};

/// Number of the coefficient of the neighbour (di, dj, dl) that comes after a cell: 0..12.
constexpr std::size_t later_neighbour(int di, int dj, int dl) {
  return static_cast<std::size_t>(dl == 1 ? 4 + 3 * (dj + 1) + di + 1 : dj == 0 ? 0 : 2 + di);
}

/// Symmetric matrix on a lattice of columns x rows x layers cells, each coupled with its 26 neighbours; in one layer
/// with its eight.
///
/// Cell (i, j, l) has index c = (l rows + j) columns + i: rows of the lattice are contiguous. Fourteen coefficients are
/// stored per cell, in one layer five: its own, and those of the neighbours (i + di, j + dj, l + dl) that come after
/// it:
///
///     dl = 0:  (1, 0)  (-1, 1)  (0, 1)  (1, 1)          dl = 1:  all nine (di, dj)
///
/// Coefficients of neighbours outside the lattice must be zero: products then run over contiguous memory without
/// branches. Arrays of coefficients have margins as LatticeArray, and begin on different lines of the cache.
class StencilMatrix {
 public:
  /// Numbers of the coefficients: of the cell itself, and of its neighbours (1, 0), (-1, 1), (0, 1), (1, 1).
  static constexpr std::size_t own = 0, right = 1, up_left = 2, up = 3, up_right = 4;

  StencilMatrix() = default;
  StencilMatrix(std::size_t columns, std::size_t rows, std::size_t layers = 1);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t layers() const { return layers_; }
  [[nodiscard]] std::size_t size() const { return columns_ * rows_ * layers_; }
  /// Coefficients of all cells: `own`, or 1 + later_neighbour.
  [[nodiscard]] double* operator[](std::size_t part) { return values_.data() + begin(part); }
  [[nodiscard]] const double* operator[](std::size_t part) const { return values_.data() + begin(part); }
  /// The stored coefficient of cells a and b, in either order, which must be neighbours or one cell.
  [[nodiscard]] const double& coefficient(std::size_t a, std::size_t b) const;
  [[nodiscard]] double& coefficient(std::size_t a, std::size_t b) {
    return const_cast<double&>(std::as_const(*this).coefficient(a, b));
  }
  void clear() { std::ranges::fill(values_, 0.0); }
  /// result = A x; returns x . A x. Threads share the rows of the lattice: one partial sum per row, summed in order, so
  /// the same for any number of threads. Margins of x must be finite.
  double multiply_and_dot(const LatticeArray& x, LatticeArray& result) const;

 private:
  [[nodiscard]] std::size_t begin(std::size_t part) const { return part * stride_ + columns_ + 1; }

  std::size_t columns_ = 0, rows_ = 0, layers_ = 0;
  std::size_t stride_ = 0;  // from part to part
  std::vector<double> values_;
};

// Passes over long vectors for iterative solvers, several operations at a time: they are limited by memory.
//
// Threads share chunks of fixed length; sums are taken within each chunk and then in order, so that results do not
// depend on the number of threads. All spans of one call have the same length; outputs do not overlap inputs.

/// x . y
double dot(std::span<const double> x, std::span<const double> y);
/// y = x + factor y
void scale_and_add(std::span<const double> x, double factor, std::span<double> y);
/// x += step p, r -= step q; returns r . r.
double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r);

/// The tolerance was not reached.
class NotConverged : public std::runtime_error {
 public:
  NotConverged(int iterations, double relative_residual, double tolerance)
      : std::runtime_error(
            fmt::format("conjugate gradients: relative residual {:.3g} after {} iterations; wanted: {:.3g}",
                        relative_residual, iterations, tolerance)) {}
};

/// A direction p or a residual r was found with p . A p or r . P r not positive: not positive definite, or not numbers.
class NotPositiveDirection : public std::runtime_error {
 public:
  NotPositiveDirection(const char* form, double value, int iteration)
      : std::runtime_error(fmt::format("conjugate gradients: {} = {:.6g} in iteration {}; the matrix and the "
                                       "preconditioner must be positive definite and all entries finite",
                                       form, value, iteration)) {}
};

/// Keeps its work arrays from solution to solution.
///
/// @tparam Vector  copyable, with values() giving a span of the unknowns and whatever else Multiply needs around them
template <class Vector = LatticeArray>
class ConjugateGradients {
 public:
  struct Goal {
    double tolerance = 1e-10;  ///< |r| <= tolerance |b|, Euclidean norms
    int most_iterations = 200;
  };
  struct Result {
    int iterations = 0;
    double relative_residual = 0;  ///< |r|/|b| at the end
  };

  /// Starts from the x given. Throws NotConverged, NotPositiveDirection.
  ///
  /// @param multiply       multiply(const Vector& p, Vector& q) sets q = A p and returns p . q
  /// @param precondition   precondition(span of r, span of z, magnitude) sets z = P r; magnitude: typical size of r
  template <class Multiply, class Precondition>
  Result solve(const Multiply& multiply, Precondition&& precondition, const Vector& b, Vector& x, Goal goal) {
    const double b_norm = std::sqrt(dot(b.values(), b.values()));
    if (b_norm == 0) {
      for (double& value : x.values()) value = 0;
      return {};
    }
    shape_like(b);
    multiply(x, residual_);
    scale_and_add(b.values(), -1, residual_.values());
    double r_norm = std::sqrt(dot(residual_.values(), residual_.values()));
    double zr = 0;
    double beta = 0;
    double step = 0;
    int iteration = 0;
    for (; !(r_norm <= goal.tolerance * b_norm); ++iteration) {
      if (iteration == goal.most_iterations) throw NotConverged(iteration, r_norm / b_norm, goal.tolerance);
      precondition(residual_.values(), preconditioned_.values(), typical_size(r_norm));
      const double zr_new = dot(preconditioned_.values(), residual_.values());
      if (!(zr_new > 0)) throw NotPositiveDirection("r.Pr", zr_new, iteration);
      const double zq = dot(preconditioned_.values(), product_.values());
      if (iteration > 0) beta = -step * zq / zr;
      zr = zr_new;
      scale_and_add(preconditioned_.values(), beta, direction_.values());
      const double curvature = multiply(direction_, product_);
      if (!(curvature > 0)) throw NotPositiveDirection("p.Ap", curvature, iteration);
      step = zr / curvature;
      r_norm = std::sqrt(advance(step, direction_.values(), product_.values(), x.values(), residual_.values()));
    }
    return {iteration, r_norm / b_norm};
  }

 private:
  void shape_like(const Vector& b) {
    if (residual_.values().size() == b.values().size()) return;
    residual_ = preconditioned_ = direction_ = product_ = b;
  }
  [[nodiscard]] double typical_size(double norm) const {
    return norm / std::sqrt(static_cast<double>(residual_.values().size()));
  }

  Vector residual_, preconditioned_, direction_, product_;
};

}  // namespace seiche::linear
