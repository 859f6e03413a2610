/// A periodic free surface marked by N particles, in units of 1/k, sqrt(1/(g k)) and unit density: period 2 pi, g = 1.
///
///     z_j = x_j + i y_j,  s_j = 2 pi j/N,  y = 0 the level at rest,  fluid below,  phi_j the velocity potential.
///
/// Kept is the displacement x - s, which is periodic.
///
/// Row by row, the matrix and the right-hand side of the integral equation in surface_velocity.hpp: additions,
/// multiplications and one division per pair of markers.
///
/// With E = exp(iz) and e = exp(i z - h) of every marker,
///
///     (1/2) cot((z_j - z_i)/2)                 =  i/2 + i E_i/(E_j - E_i),
///     (1/2) cot((conj z_j - 2ih - z_i)/2)      = -i/2 + i/(1 - e_i conj e_j)
///
/// so that a row needs sums of 1/(E_j - E_i) and 1/(1 - e_i conj e_j) only.
///
/// Velocity of the free surface from its shape and potential, by Cauchy's integral.
///
/// R = z_s f = phi_s + i psi_s on the surface, f = u - i v, fluid below, flat bottom at depth h or none:
///
///     R(s) = (i/pi) z_s PV int R(s') (1/2) cot((z(s') - z(s))/2) ds'
///          - (i/pi) z_s int conj R(s') (1/2) cot((conj z(s') - 2ih - z(s))/2) ds'
///
/// (no second integral without a bottom). Its imaginary part is an equation of the second kind for psi_s. The
/// trapezoid rule without the point s' = s, with the regular part of the integrand there, is spectrally accurate:
///
///     (I - A) psi_s = b,   w = 2 pi/N,  C_ij, C~_ij the two half cotangents,
///     A_ij = -(w/pi) Im[z_s,i (C_ij + C~_ij)],         A_ii = (w/pi) Im[z_ss/(2 z_s) - z_s C~_ii],
///     b_i  =  (w/pi) { Re[z_s,i sum_j (C_ij - C~_ij) phi_s,j] + phi_ss - phi_s Re[z_ss/(2 z_s)] }.
///
/// A is stored in single precision, which halves the traffic: it only corrects a first guess whose residual is formed
/// in double precision together with A.
///
/// When not to use it: corners, or two parts of the surface closer than about two marker spacings.
///
/// References: Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123
/// (1982) 477; Dold & Peregrine, An efficient boundary-integral method for steep unsteady water waves (1986).
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "seiche/exact/overturning/bars.hpp"
#include "seiche/exact/reference_solution.hpp"
#include "seiche/linear/fourier.hpp"
#include "seiche/linear/gmres.hpp"

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
  return State(3 * markers + pressure_sums);
}

template <class Number>
struct SurfaceView {
  std::span<Number> displacement;
  std::span<Number> y;
  std::span<Number> potential;

  [[nodiscard]] std::size_t size() const { return y.size(); }
};

/// Of a State: of its numbers, or of those of one that is const.
template <class S>
auto view(S& state) {
  const std::span all(state);
  const std::size_t n = marker_count(state);
  return SurfaceView<std::remove_reference_t<decltype(all[0])>>{all.first(n), all.subspan(n, n), all.subspan(2 * n, n)};
}

template <class S>
auto by_pressure(S& state) {
  return PressureSums<std::remove_reference_t<decltype(state[0])>>{state[state.size() - 2], state[state.size() - 1]};
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

/// Real and imaginary parts apart: the loops load both with unit stride.
struct Complexes {
  std::vector<double> re;
  std::vector<double> im;

  explicit Complexes(std::size_t n) : re(n), im(n) {}
  [[nodiscard]] std::complex<double> operator[](std::size_t i) const { return {re[i], im[i]}; }
  void set(std::size_t i, std::complex<double> value) {
    re[i] = value.real();
    im[i] = value.imag();
  }
};

class SurfaceVelocity {
 public:
  /// @param markers  N >= 8, even;  @param depth  > 0, may be infinite. Throws std::invalid_argument.
  SurfaceVelocity(std::size_t markers, double depth);

  /// Solves for the slope of the stream function psi_s of every marker.
  ///
  /// @param psi_s      in: first guess; out: solution
  /// @param tolerance  of the residual, relative to b; the default lies below the round-off of the kernels for markers
  ///                   as close as those of a jet
  void solve(SurfaceView<const double> surface, Eigen::VectorXd& psi_s, double tolerance = 1e-12);

  /// Of the surface solved last: velocity u - i v of marker i, its z_s, and the integrals over the period.
  [[nodiscard]] std::complex<double> velocity(std::size_t i) const { return velocity_[i]; }
  [[nodiscard]] std::complex<double> tangent(std::size_t i) const { return z_s_[i]; }
  /// Over bars the surface is that in the plane of zeta.
  [[nodiscard]] Invariants invariants(SurfaceView<const double> surface, const Eigen::VectorXd& psi_s,
                                      const Bars& bars) const;

  /// Iterations and equations solved so far.
  [[nodiscard]] long iterations() const { return iterations_; }
  [[nodiscard]] long solves() const { return solves_; }

 private:
  void differentiate(SurfaceView<const double> surface);
  void exponentials(SurfaceView<const double> surface);
  /// Fills A_ and residual_ = b - (I - A) psi_s; returns |b|.
  double assemble(const Eigen::VectorXd& psi_s);

  std::size_t n_;
  double depth_;
  bool has_bottom_;
  linear::Fourier fourier_;
  std::vector<std::complex<double>> work_;
  std::vector<std::complex<double>> coefficients_;
  std::vector<std::complex<double>> z_s_;
  std::vector<std::complex<double>> z_ss_;
  std::vector<std::complex<double>> velocity_;
  std::vector<double> phi_s_;
  std::vector<double> phi_ss_;
  Complexes E_;
  Complexes e_;
  std::vector<float> A_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd correction_;
  linear::Gmres gmres_;
  long iterations_ = 0;
  long solves_ = 0;
};

}  // namespace seiche::exact::overturning
