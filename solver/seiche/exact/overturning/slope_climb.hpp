/// Functions on a line by their values at Chebyshev-Lobatto nodes s_k = -cos(pi k/n), k = 0 .. n: slopes, integrals,
/// values between the nodes, and a filter of the highest coefficients.
///
/// References: Trefethen, Spectral Methods in MATLAB (2000), chapters 6 and 12; Hou & Li, Computing nearly singular
/// solutions using pseudo-spectral methods, J. Comput. Phys. 226 (2007) 379 (the filter).
///
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
///
/// The motion of water that climbs a slope: dz/dt = u + iv, dphi/dt = |grad phi|^2/2 - (y - 1), depth and gravity 1.
///
/// Nodes move with the water, by the pair of Dormand & Prince with steps of a tolerance; after each the highest
/// coefficients are filtered and the shore is put back on the slope. Over the first depths the water is held at rest.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <Eigen/Core>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact::slope_climb {

struct ChebyshevLine {
  /// @param intervals  n, even
  explicit ChebyshevLine(std::size_t intervals);
  /// Values to those at the nodes of a line of times as many intervals: rows times n + 1, columns n + 1.
  [[nodiscard]] Eigen::MatrixXd refinement(std::size_t times) const;

  Eigen::VectorXd nodes;            ///< s_k, from -1 to 1
  Eigen::VectorXd weights;          ///< of int ds (Clenshaw, Curtis)
  Eigen::MatrixXd differentiation;  ///< values to d/ds
  /// Values to those without what the highest coefficients carry: the k-th times exp(-36 (k/n)^24).
  Eigen::MatrixXd filter;
};

/// Weights of Clenshaw and Curtis for n even intervals of [-1, 1].
Eigen::VectorXd clenshaw_curtis(std::size_t intervals);

class WedgeFlow {
 public:
  /// @param intervals  of the surface, even;  @param slope  beta [rad], in (0, pi/2]
  WedgeFlow(std::size_t intervals, double slope);

  /// @param z    nodes of the surface from the far end to the shore, which lies on the slope
  /// @param phi  potential there, 0 at the far end
  void solve(const Eigen::VectorXcd& z, const Eigen::VectorXd& phi);
  [[nodiscard]] const Eigen::VectorXcd& velocity() const { return velocity_; }  ///< u - iv
  /// T = 1/2 int |grad phi|^2, for density 1.
  [[nodiscard]] double kinetic_energy(const Eigen::VectorXd& phi) const {
    return -0.5 * line_.weights.cwiseProduct(phi).dot(line_.differentiation * psi_);
  }
  [[nodiscard]] const ChebyshevLine& line() const { return line_; }

 private:
  /// The surface in the plane of zeta, on so many times as many intervals.
  struct Curve {
    Eigen::Index times;
    Eigen::MatrixXd refinement;  ///< empty where times is 1
    Eigen::VectorXd weights;
    Eigen::ArrayXd x, y;      ///< zeta
    Eigen::ArrayXd x_s, y_s;  ///< d zeta/ds
    Eigen::VectorXd phi;
  };
  void map(const Eigen::ArrayXcd& z, const Eigen::ArrayXcd& z_s, Curve& curve) const;
  /// The coarsest curve over which the integrals for a node of the coarse one are good.
  [[nodiscard]] const Curve& curve_for(Eigen::Index node) const;
  /// Fills a row of weighted kernels for a node of the curve and returns the first part of the right-hand side.
  double row(const Curve& curve, Eigen::Index node, double curvature, double phi_s, double* kernels) const;

  double beta_, power_;
  ChebyshevLine line_;
  std::vector<Curve> curves_;  ///< from coarse to fine
  Eigen::MatrixXd matrix_;     ///< transposed
  Eigen::VectorXd kernels_;    ///< on a fine curve
  Eigen::VectorXd right_;
  Eigen::VectorXd psi_;
  Eigen::VectorXcd velocity_;
};

class Climb {
 public:
  /// @param z  nodes from the far end to the shore;  @param phi  potential there, 0 at the far end
  Climb(double slope, const Eigen::VectorXcd& z, const Eigen::VectorXd& phi, double tolerance);

  /// One accepted step. Throws Divergence.
  void step();
  /// To before the last step(), and whatever came after it.
  void step_back();
  /// To a time within the next step, not before now.
  void step_to(double time);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double shore() const { return state_[2 * n_ - 1] - 1; }  ///< level above still water
  [[nodiscard]] double shore_speed();                                    ///< of that level
  /// T + V, V = int int y above still water less what is missing below; slope and bottom taken as they are.
  [[nodiscard]] double energy();
  /// Of the water, above that at rest.
  [[nodiscard]] double volume() const { return moment(1); }

 private:
  using State = std::vector<double>;  ///< x, y and phi of all nodes
  void rate(const State& state, State& rate);
  auto system() {
    return [this](const State& now, State& change, double /*time*/) { rate(now, change); };
  }
  void filter();
  void require_finite() const;
  [[nodiscard]] Eigen::VectorXcd nodes(const State& state) const;
  /// x, y or phi of all nodes.
  template <class S>
  [[nodiscard]] auto part(S& state, std::size_t which) const {
    using Vector = std::conditional_t<std::is_const_v<S>, const Eigen::VectorXd, Eigen::VectorXd>;
    return Eigen::Map<Vector>(state.data() + which * n_, static_cast<Eigen::Index>(n_));
  }
  /// int int y^(power - 1) over the water above still water less that over what is missing below, power 1 or 2.
  [[nodiscard]] double moment(int power) const;

  std::size_t n_;  ///< nodes
  double slope_;
  WedgeFlow flow_;
  State state_, before_;
  Eigen::VectorXd moved_;  ///< 1, and 0 where water is held at rest
  double time_ = 0;
  double time_before_ = 0;
  double duration_ = 0.01;
  long steps_ = 0;
  boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_dopri5<State>> stepper_;
};

}  // namespace seiche::exact::slope_climb
