/// A periodic free surface marked by N particles, in units of 1/k, sqrt(1/(g k)) and unit density: period 2 pi, g = 1.
///
///     z_j = x_j + i y_j,  s_j = 2 pi j/N,  y = 0 the level at rest,  fluid below,  phi_j the velocity potential.
///
/// Kept is the displacement x - s, which is periodic.
#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace seiche::exact::overturning {

/// x - s, y and phi of every marker, one after the other: the form the time integrator wants.
using State = std::vector<double>;

template <class Number>
struct SurfaceView {
  std::span<Number> displacement;
  std::span<Number> y;
  std::span<Number> potential;

  [[nodiscard]] std::size_t size() const { return y.size(); }
};

inline SurfaceView<const double> view(const State& state) {
  const std::span all(state);
  const std::size_t n = state.size() / 3;
  return {all.first(n), all.subspan(n, n), all.last(n)};
}

inline SurfaceView<double> view(State& state) {
  const std::span all(state);
  const std::size_t n = state.size() / 3;
  return {all.first(n), all.subspan(n, n), all.last(n)};
}

/// Label of marker j out of n.
inline double label(std::size_t j, std::size_t n) {
  return 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
}

/// What the exact motion keeps, per period.
struct Invariants {
  double volume = 0;            ///< int y dx, above the level at rest
  double kinetic_energy = 0;    ///< -1/2 int phi dpsi
  double potential_energy = 0;  ///< 1/2 int y^2 dx
  double impulse = 0;           ///< horizontal, -int phi dy

  [[nodiscard]] double energy() const { return kinetic_energy + potential_energy; }
};

}  // namespace seiche::exact::overturning
