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

/// x - s, y and phi of every marker, one after the other, then the work and the thrust of a pressure on the surface
/// since the start: the form the time integrator wants.
using State = std::vector<double>;

/// What a pressure on the surface has done to the water, per period.
template <class Number>
struct PressureSums {
  Number& work;    ///< -int int p u.n ds dt
  Number& thrust;  ///< horizontal, -int int p n_x ds dt
};

inline constexpr std::size_t pressure_sums = 2;

inline std::size_t marker_count(const State& state) {
  return (state.size() - pressure_sums) / 3;
}

inline State still_water(std::size_t markers) {
  State still(3 * markers + pressure_sums);
  return still;
}

template <class Number>
struct SurfaceView {
  std::span<Number> displacement;
  std::span<Number> y;
  std::span<Number> potential;

  [[nodiscard]] std::size_t size() const { return y.size(); }
};

inline SurfaceView<const double> view(const State& state) {
  const std::span all(state);
  const std::size_t n = marker_count(state);
  return {all.first(n), all.subspan(n, n), all.subspan(2 * n, n)};
}

inline SurfaceView<double> view(State& state) {
  const std::span all(state);
  const std::size_t n = marker_count(state);
  return {all.first(n), all.subspan(n, n), all.subspan(2 * n, n)};
}

inline PressureSums<const double> by_pressure(const State& state) {
  return {state[state.size() - 2], state[state.size() - 1]};
}

inline PressureSums<double> by_pressure(State& state) {
  return {state[state.size() - 2], state[state.size() - 1]};
}

/// Label of marker j out of n.
inline double label(std::size_t j, std::size_t n) {
  return 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
}

/// What the exact motion keeps, per period, where no pressure acts on the surface.
struct Invariants {
  double volume = 0;            ///< int y dx, above the level at rest
  double kinetic_energy = 0;    ///< -1/2 int phi dpsi
  double potential_energy = 0;  ///< 1/2 int y^2 dx
  double impulse = 0;           ///< horizontal, -int phi dy

  [[nodiscard]] double energy() const { return kinetic_energy + potential_energy; }
};

}  // namespace seiche::exact::overturning
