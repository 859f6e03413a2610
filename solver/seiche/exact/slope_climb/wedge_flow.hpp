/// Velocities of water over a level bottom that ends at a plane slope, from the potential on its surface.
///
/// z = x + iy with the toe of the slope at 0, still water at y = 1, bottom x < 0, slope z = r exp(i beta). The map
///
///     zeta = (z exp(-i beta))^p,   p = pi/(pi - beta),
///
/// makes one straight line of bottom and slope, the real axis, with the water above it. There the stream function is 0,
/// and w = phi + i psi goes on below it by reflection, w(conj zeta) = conj w(zeta). Cauchy's integral along the surface
/// and its mirror image, real part, with the kernel K = zeta_s/(zeta - zeta_i) and that of the image, K':
///
///     pi psi_i + int psi Im(K + K') ds = int (phi - phi_i) Re(K - K') ds
///                                        - phi_i ln|(zeta_L - zeta_i)/(conj zeta_L - zeta_i)|
///
/// L is the far end, where the water rests and phi = 0; at both ends psi = 0. The velocity is u - iv = w_s/z_s.
///
/// The image comes as close to the surface as the shore is near, closer than the nodes are to each other: the integrals
/// of the nodes there are taken over four or sixteen times as many.
///
/// References: Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350
/// (1976) 1; Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123
/// (1982) 477.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "seiche/exact/slope_climb/chebyshev_line.hpp"

namespace seiche::exact::slope_climb {

class WedgeFlow {
 public:
  /// @param intervals  of the surface, even;  @param slope  beta [rad], in (0, pi/2]
  WedgeFlow(std::size_t intervals, double slope);

  /// @param z    nodes of the surface from the far end to the shore, which lies on the slope
  /// @param phi  potential there, 0 at the far end
  void solve(const Eigen::VectorXcd& z, const Eigen::VectorXd& phi);
  [[nodiscard]] const Eigen::VectorXd& stream_function() const { return psi_; }
  [[nodiscard]] const Eigen::VectorXcd& velocity() const { return velocity_; }  ///< u - iv
  /// T = 1/2 int |grad phi|^2, for density 1.
  [[nodiscard]] double kinetic_energy(const Eigen::VectorXd& phi) const;
  [[nodiscard]] const ChebyshevLine& line() const { return line_; }

 private:
  /// The surface in the plane of zeta, on so many times as many intervals.
  struct Curve {
    std::size_t times;
    Eigen::MatrixXd refinement;  ///< empty where times is 1
    Eigen::VectorXd weights;
    std::vector<double> x, y;      ///< zeta
    std::vector<double> x_s, y_s;  ///< d zeta/ds
    Eigen::VectorXd phi;
  };
  void map(const Eigen::VectorXcd& z, const Eigen::VectorXcd& z_s, Curve& curve) const;
  /// The coarsest curve over which the integrals for a node of the coarse one are good.
  [[nodiscard]] const Curve& curve_for(std::size_t node) const;
  /// Fills a row of weighted kernels for a node of the curve and returns the first part of the right-hand side.
  double row(const Curve& curve, std::size_t node, double curvature, double phi_s, double* kernels) const;

  double beta_;
  double power_;
  ChebyshevLine line_;
  std::vector<Curve> curves_;  ///< from coarse to fine
  Eigen::MatrixXd matrix_;     ///< transposed
  Eigen::VectorXd kernels_;    ///< on a fine curve
  Eigen::VectorXd right_;
  Eigen::VectorXd psi_;
  Eigen::VectorXcd velocity_;
};

}  // namespace seiche::exact::slope_climb
