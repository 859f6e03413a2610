#include "seiche/models/gauss_particles/spline_axis.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/LU>
#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr std::size_t most = CellPolynomials::most;
using Polynomial = std::array<double, most>;

/// (a + b z) times a polynomial of lower than the highest degree, added to a sum.
void add_linear_times(double a, double b, const Polynomial& factor, Polynomial& sum) {
  for (std::size_t power = 0; power < most; ++power) sum[power] += a * factor[power];
  for (std::size_t power = 1; power < most; ++power) sum[power] += b * factor[power - 1];
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d{};
  for (std::size_t power = 1; power < most; ++power) d[power - 1] = static_cast<double>(power) * p[power];
  return d;
}

void multiply(const Polynomial& a, const Polynomial& b, std::size_t powers, double* product) {
  for (std::size_t i = 0; i < most; ++i) {
    for (std::size_t k = 0; k < most; ++k) {
      if (i + k < powers) product[i + k] += a[i] * b[k];
    }
  }
}

}  // namespace

SplineAxis::SplineAxis(int degree, double begin, double cell, long cells, Ends ends, long first)
    : degree_(degree), begin_(begin), cell_(cell), cells_(cells), ends_(ends), first_(first) {
  require_within("degree of the splines", degree, lowest_degree, highest_degree);
  require_finite("begin of the lattice", begin);
  require_positive("cell of the lattice", cell);
  require_at_least(periodic() ? "cells of a periodic lattice" : "cells of the lattice", cells,
                   periodic() ? 2 * degree + 1 : 1);
}

std::size_t SplineAxis::kind(long cell) const {
  const long far = degree_ - 1;
  const long below = wall_below() ? std::min(cell, far) : far;
  const long above = wall_above() ? std::min(cells_ - 1 - cell, far) : far;
  return static_cast<std::size_t>(below * degree_ + above);
}

double SplineAxis::knot(long k) const {
  long line = k - degree_;
  if (wall_below()) line = std::max(line, 0L);
  if (wall_above()) line = std::min(line, cells_);
  return static_cast<double>(line);
}

bool SplineAxis::uniform(long from, long to) const {
  return (!wall_below() || from >= 0) && (!wall_above() || to <= cells_);
}

void SplineAxis::extend(long i, long i0, std::span<double> weights) const {
  if (i >= i0 && i < i0 + static_cast<long>(weights.size())) {
    std::fill(weights.begin(), weights.end(), 0.0);
    weights[static_cast<std::size_t>(i - i0)] = 1;
  } else if (static_cast<int>(weights.size()) == degree_ + 1) {
    blossom(i, i0, weights);
  } else {
    fit(i, i0, weights);
  }
}

void SplineAxis::blossom(long i, long i0, std::span<double> weights) const {
  const auto order = static_cast<std::size_t>(degree_) + 1;
  // Row a: the coefficients of functions i0 ... i0 + degree in the point a of de Boor's triangle.
  std::array<Polynomial, most> points{};
  for (std::size_t a = 0; a < order; ++a) points[a][a] = 1;
  for (int r = 1; r <= degree_; ++r) {
    const double at = knot(i + r);
    for (auto a = static_cast<std::size_t>(degree_); a >= static_cast<std::size_t>(r); --a) {
      const long f = i0 + static_cast<long>(a);
      const double low = knot(f);
      const double width = knot(f + degree_ + 1 - r) - low;
      const double part = (at - low) / width;
      for (std::size_t b = 0; b < order; ++b) points[a][b] = (1 - part) * points[a - 1][b] + part * points[a][b];
    }
  }
  std::copy_n(points[order - 1].begin(), order, weights.begin());
}

void SplineAxis::fit(long i, long i0, std::span<double> weights) const {
  const auto count = static_cast<long>(weights.size());
  if (uniform(std::min(i, i0) + 1 - degree_, std::max(i, i0 + count - 1))) {
    // Coefficients of polynomials are polynomials of the index: Lagrange's weights.
    for (long a = 0; a < count; ++a) {
      double weight = 1;
      for (long b = 0; b < count; ++b) {
        if (b != a) weight *= static_cast<double>(i - i0 - b) / static_cast<double>(a - b);
      }
      weights[static_cast<std::size_t>(a)] = weight;
    }
    return;
  }
  // Coefficients of 1, z, z^2, ... about the block's middle: mean products of a function's inner knots.
  const double middle = static_cast<double>(i0 - degree_) + 0.5 * static_cast<double>(count + degree_);
  const auto coefficients = [&](long f) {
    Eigen::VectorXd symmetric = Eigen::VectorXd::Zero(count);
    symmetric[0] = 1;
    for (int k = 1; k <= degree_; ++k) {
      for (long power = count - 1; power > 0; --power)
        symmetric[power] += (knot(f + k) - middle) * symmetric[power - 1];
    }
    double binomial = 1;
    for (long power = 1; power < count; ++power) {
      binomial *= static_cast<double>(degree_ - power + 1) / static_cast<double>(power);
      symmetric[power] /= binomial;
    }
    return symmetric;
  };
  Eigen::MatrixXd block(count, count);
  for (long a = 0; a < count; ++a) block.col(a) = coefficients(i0 + a);
  const Eigen::VectorXd solution = block.partialPivLu().solve(coefficients(i));
  std::copy_n(solution.data(), weights.size(), weights.begin());
}

namespace {

CellPolynomials polynomials_of(const SplineAxis& axis, long cell) {
  const int degree = axis.degree();
  const auto order = static_cast<std::size_t>(degree) + 1;
  // Cox's and de Boor's recursion on the polynomials; entry i is that of function cell + i - (degree - k).
  const double middle = static_cast<double>(cell) + 0.5;
  std::array<Polynomial, most> functions{};
  functions[0][0] = 1;
  for (int k = 1; k <= degree; ++k) {
    std::array<Polynomial, most> next{};
    for (int i = 0; i <= k; ++i) {
      const long f = cell + degree - k + i;
      const double low = axis.knot(f);
      const double high = axis.knot(f + k + 1);
      if (i > 0) {
        const double width = axis.knot(f + k) - low;
        const double scale = 2 * k / width;
        add_linear_times(scale * (middle - low), scale, functions[static_cast<std::size_t>(i - 1)],
                         next[static_cast<std::size_t>(i)]);
      }
      if (i < k) {
        const double width = high - axis.knot(f + 1);
        const double scale = 2 * k / width;
        add_linear_times(scale * (high - middle), -scale, functions[static_cast<std::size_t>(i)],
                         next[static_cast<std::size_t>(i)]);
      }
    }
    functions = next;
  }
  CellPolynomials tables;
  const std::size_t powers = 2 * order - 1;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t power = 0; power < order; ++power) tables.function[i * order + power] = functions[i][power];
    const Polynomial slope = derivative(functions[i]);
    for (std::size_t k = 0; k < order; ++k) {
      multiply(slope, functions[k], powers, &tables.mixed_product[(i * order + k) * powers]);
      if (k < i) continue;
      multiply(functions[i], functions[k], powers, &tables.product[pair * powers]);
      multiply(slope, derivative(functions[k]), powers, &tables.derivative_product[pair * powers]);
      ++pair;
    }
  }
  return tables;
}

std::vector<CellPolynomials> all_kinds(int degree) {
  std::vector<CellPolynomials> kinds;
  for (long below = 0; below < degree; ++below) {
    for (long above = 0; above < degree; ++above) {
      kinds.push_back(polynomials_of(SplineAxis(degree, 0, 1, below + above + 1, Ends::walls), below));
    }
  }
  return kinds;
}

}  // namespace

std::span<const CellPolynomials> cell_polynomials(int degree) {
  static const std::array<std::vector<CellPolynomials>, 3> all{all_kinds(2), all_kinds(3), all_kinds(4)};
  return all[static_cast<std::size_t>(degree - lowest_degree)];
}

}  // namespace seiche::gauss_particles
