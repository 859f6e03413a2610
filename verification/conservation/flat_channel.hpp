/// Discrete dispersive shallow water over a flat bottom (Frank 1994, formulas 8-14 with b = -1, g = 1), as the smallest
/// fluid that the integrators can be tried on: markers (x, y), rates (p, r), masses m and alpha m, cells of constant
/// volume between neighbouring markers, tridiagonal A.
///
///     V_j = Dx_j (1 + (y_j + y_{j+1})/2),   Pi = sum Dx_j (y_j^2 + y_j y_{j+1} + y_{j+1}^2)/6
///
/// Periodic, or closed by vertical walls through the first and the last marker.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::verification {

template <class Matrix>
class FlatChannel {
 public:
  static constexpr bool periodic = std::is_same_v<Matrix, linear::PeriodicTridiagonal>;
  static constexpr double alpha = 1.0 / 3;

  /// Rest volumes and masses from the polygon through the markers q = (x_0 .. x_{n-1}, y_0 .. y_{n-1}).
  FlatChannel(std::vector<double> q, double length)
      : n_(q.size() / 2), cells_(periodic ? n_ : n_ - 1), length_(length), weight_(n_) {
    for (auto* array : {&width_, &depth_}) array->assign(n_ + 1, 0.0);
    for (auto* array : {&diagonal_, &off_diagonal_, &px_, &py_}) array->assign(n_, 0.0);
    std::vector<double> mass(n_, 0.0);
    for (std::size_t j = 0; j < cells_; ++j) {
      const Cell cell = at(q, j);
      const double left = 1 + cell.left;
      const double right = 1 + cell.right;
      mass[j] += cell.width * (3 * left + right) / 8;
      mass[(j + 1) % n_] += cell.width * (left + 3 * right) / 8;
      rest_volume_.push_back(cell.width * 0.5 * (left + right));
    }
    for (std::size_t i = 0; i < n_; ++i) weight_[i] = 1 / mass[i];
    mass_ = mass;
    across_ = weight_;
    if (!periodic) across_.front() = across_.back() = 0;
  }

  [[nodiscard]] std::size_t coordinates() const { return 2 * n_; }
  [[nodiscard]] std::size_t rates() const { return 2 * n_; }
  [[nodiscard]] std::size_t constraints() const { return cells_; }

  void linearise(mechanics::Interval, mechanics::Input q) {
    gradients(q);
    matrix_.factor({std::span(diagonal_).first(cells_), off_diagonal_});
  }

  /// Volumes are bilinear: J at the middle. The mean of grad Pi over the segment is grad Pi at the middle and a term in
  /// the increments.
  void linearise_between(mechanics::Interval when, mechanics::Input q0, mechanics::Input q1, int) {
    middle_.resize(q0.size());
    for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
    linearise(when, middle_);
    for (std::size_t j = 0; j < cells_; ++j) {
      const Cell a = at(q0, j);
      const Cell b = at(q1, j);
      const double left = b.left - a.left;
      const double right = b.right - a.right;
      const double widening = b.width - a.width;
      const double mean = 0.5 * (left + right);
      const double tilt = right - left;
      const std::size_t k = (j + 1) % n_;
      const double thrust = (mean * mean + tilt * tilt / 12) / 24;
      px_[j] -= thrust;
      px_[k] += thrust;
      py_[j] += widening * (mean - tilt / 6) / 24;
      py_[k] += widening * (mean + tilt / 6) / 24;
    }
  }

  void kick(double h, mechanics::Output u) const {
    double* const p = u.data();
    double* const r = u.data() + n_;
#pragma omp simd
    for (std::size_t i = 0; i < n_; ++i) {
      p[i] -= h * across_[i] * px_[i];
      r[i] -= h / alpha * weight_[i] * py_[i];
    }
  }

  void advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const {
    const double* const a = from.data();
    const double* const rate = u.data();
    double* const b = to.data();
#pragma omp simd
    for (std::size_t i = 0; i < 2 * n_; ++i) b[i] = a[i] + h * rate[i];
  }

  void constraint_rates(mechanics::Input u, mechanics::Output w) const {
    const double* const p = u.data();
    const double* const r = u.data() + n_;
    double* const out = w.data();
#pragma omp simd
    for (std::size_t j = 0; j < n_ - 1; ++j) {
      out[j] = depth_[j + 1] * (p[j + 1] - p[j]) + 0.5 * width_[j + 1] * (r[j + 1] + r[j]);
    }
    if (periodic) out[n_ - 1] = depth_[n_] * (p[0] - p[n_ - 1]) + 0.5 * width_[n_] * (r[0] + r[n_ - 1]);
  }

  void react(mechanics::Input mu, mechanics::Output u) const {
    double* const p = u.data();
    double* const r = u.data() + n_;
    const auto add = [&](std::size_t i, double left, double right) {
      p[i] += across_[i] * (left * depth_[i] - right * depth_[i + 1]);
      r[i] += 0.5 / alpha * weight_[i] * (left * width_[i] + right * width_[i + 1]);
    };
    add(0, periodic ? mu[n_ - 1] : 0.0, mu[0]);
    const double* const impulse = mu.data();
#pragma omp simd
    for (std::size_t i = 1; i < n_ - 1; ++i) add(i, impulse[i - 1], impulse[i]);
    add(n_ - 1, mu[n_ - 2], periodic ? mu[n_ - 1] : 0.0);
  }

  void solve(mechanics::Input right_hand_side, mechanics::Output mu) {
    matrix_.solve(right_hand_side, mu);
    ++solves_;
  }

  void constraint_values(mechanics::Input q, mechanics::Output f) const {
    for (std::size_t j = 0; j < cells_; ++j) {
      const Cell cell = at(q, j);
      f[j] = cell.width * (1 + 0.5 * (cell.left + cell.right)) - rest_volume_[j];
    }
  }

  [[nodiscard]] double kinetic_energy(mechanics::Input, mechanics::Input u) const {
    CompensatedSum sum;
    for (std::size_t i = 0; i < n_; ++i) sum.add(0.5 * mass_[i] * (u[i] * u[i] + alpha * u[n_ + i] * u[n_ + i]));
    return sum.value();
  }
  /// Zero at rest.
  [[nodiscard]] double potential_energy(mechanics::Input q) const {
    CompensatedSum sum;
    for (std::size_t j = 0; j < cells_; ++j) {
      const Cell cell = at(q, j);
      sum.add(cell.width * (cell.left * cell.left + cell.left * cell.right + cell.right * cell.right) / 6);
    }
    return sum.value();
  }
  [[nodiscard]] std::array<double, 1> momentum(mechanics::Input, mechanics::Input u) const {
    CompensatedSum sum;
    for (std::size_t i = 0; i < n_; ++i) sum.add(mass_[i] * u[i]);
    return {sum.value()};
  }
  [[nodiscard]] long solves() const {
    return solves_;
  }

 private:
  struct Cell {
    double width, left, right;
  };
  [[nodiscard]] Cell at(mechanics::Input q, std::size_t j) const {
    const std::size_t k = j + 1 < n_ ? j + 1 : 0;
    return {q[k] - q[j] + (k == 0 ? length_ : 0.0), q[n_ + j], q[n_ + k]};
  }

  /// One pass. Cell j is stored at j + 1, the cell before the first marker at 0; outside walls it has no extent.
  void gradients(mechanics::Input q) {
    const double* const x = q.data();
    const double* const y = q.data() + n_;
    const std::size_t last = n_ - 1;
    constexpr double sixth = 1.0 / 6;
    constexpr double quarter_inverse_alpha = 1 / (4 * alpha);
    const auto cell = [&](std::size_t j, std::size_t k, double width) {
      width_[j + 1] = width;
      depth_[j + 1] = 1 + 0.5 * (y[j] + y[k]);
      const double flat = depth_[j + 1] * depth_[j + 1];
      const double upright = width * width * quarter_inverse_alpha;
      diagonal_[j] = flat * (across_[j] + across_[k]) + upright * (weight_[j] + weight_[k]);
    };
#pragma omp simd
    for (std::size_t j = 0; j < last; ++j) cell(j, j + 1, x[j + 1] - x[j]);
    if (periodic) {
      cell(last, 0, x[0] - x[last] + length_);
      width_[0] = width_[n_];
      depth_[0] = depth_[n_];
    }
    const auto marker = [&](std::size_t i, double before, double after) {
      px_[i] = (before - after) * (before + y[i] + after) * sixth;
      py_[i] = (width_[i] * (before + 2 * y[i]) + width_[i + 1] * (2 * y[i] + after)) * sixth;
    };
    const auto coupling = [&](std::size_t i) {
      return width_[i] * width_[i + 1] * quarter_inverse_alpha * weight_[i] - depth_[i] * depth_[i + 1] * across_[i];
    };
    marker(0, y[last], y[1]);
#pragma omp simd
    for (std::size_t i = 1; i < last; ++i) {
      marker(i, y[i - 1], y[i + 1]);
      off_diagonal_[i - 1] = coupling(i);
    }
    marker(last, y[last - 1], y[0]);
    if (periodic) {
      off_diagonal_[last - 1] = coupling(last);
      off_diagonal_[last] = coupling(0);
    }
  }

  std::size_t n_, cells_;
  double length_;
  std::vector<double> weight_;  // 1/m
  std::vector<double> across_;  // 1/m for the horizontal rate: 0 at walls
  std::vector<double> mass_, rest_volume_;
  std::vector<double> width_, depth_, diagonal_, off_diagonal_, px_, py_, middle_;
  Matrix matrix_;
  long solves_ = 0;
};

/// Solitary wave of Serre's equations, amplitude a, crest in the middle of the channel: markers that split its mass
/// equally, and their rates.
inline mechanics::State solitary_start(double amplitude, double length, std::size_t markers, bool periodic) {
  const double k = std::sqrt(3 * amplitude / (4 * (1 + amplitude)));
  const double c = std::sqrt(1 + amplitude);
  const double centre = length / 2;
  const auto label = [&](double x) { return x + amplitude / k * std::tanh(k * (x - centre)); };
  mechanics::State state;
  state.q.resize(2 * markers);
  state.u.resize(2 * markers);
  const double first = label(0);
  const double step = (label(length) - first) / static_cast<double>(periodic ? markers : markers - 1);
  double x = 0;
  for (std::size_t i = 0; i < markers; ++i) {
    for (int iteration = 0; iteration < 50; ++iteration) {
      const double s = 1 / std::cosh(k * (x - centre));
      x -= (label(x) - first - static_cast<double>(i) * step) / (1 + amplitude * s * s);
    }
    const double s = 1 / std::cosh(k * (x - centre));
    const double eta = amplitude * s * s;
    state.q[i] = x;
    state.q[markers + i] = eta;
    state.u[i] = c * eta / (1 + eta);
    state.u[markers + i] = c * 2 * k * std::tanh(k * (x - centre)) * eta / (1 + eta);
  }
  if (!periodic) state.u[0] = state.u[markers - 1] = 0;
  return state;
}

}  // namespace seiche::verification
