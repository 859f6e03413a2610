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

#include <Eigen/Core>

#include "seiche/exact/overturning/cauchy_kernel.hpp"
#include "seiche/exact/overturning/surface.hpp"
#include "seiche/linear/fourier.hpp"
#include "seiche/linear/gmres.hpp"

namespace seiche::exact::overturning {

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
  [[nodiscard]] Invariants invariants(SurfaceView<const double> surface, const Eigen::VectorXd& psi_s) const;

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
