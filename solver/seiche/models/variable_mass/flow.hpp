/// Discrete incompressible fluid of particles whose masses change (Frank 1994, 5.3).
///
/// The nodes of Dirichlet cells move with the water's velocity u and a control velocity c, by which the cells keep
/// their shape (control.hpp). The water that a cell then gains, it gains from its neighbours, with half of either's
/// velocity:
///
/// @f[ \dot{\mathbf{r}}_i = \mathbf{u}_i + \mathbf{c}_i, \qquad \dot{m}_i = \rho \sum_j q_{ij}, \qquad
///     q_{ij} = -q_{ji}, \qquad \sum_k \frac{\partial A_i}{\partial \mathbf{r}_k} \cdot \mathbf{u}_k = 0, @f]
/// @f[ \frac{d (m_i \mathbf{u}_i)}{dt} = \sum_j \lambda_j \frac{\partial A_j}{\partial \mathbf{r}_i}
///       - \frac{\partial \Pi}{\partial \mathbf{r}_i} + \rho \sum_j q_{ij} \frac{\mathbf{u}_i + \mathbf{u}_j}{2} . @f]
///
/// The areas change by c alone, as the masses do. In a step, with the geometry at the middle
/// r + (tau/2)(u + c) and the means of Exchange,
///
///     D ubar - sum_j (d_ij/2) ubar_j - G^T mu = a (a + b) u - tau dPi,   G ubar = 0,   r' = r + tau (ubar + c).
///
/// The masses differ before and after a step, and the matrix is that of the mean masses D: that is not a step of
/// mechanics::OneStep, whose W is one and the same throughout; the projections, the water and its pressures
/// (free_lagrangian/cell_water.hpp) are the same as of the Dirichlet mesh.
///
/// Conserves: mass; linear momentum of a free body, and without gravity the energy with what was booked, to round-off.
/// Under gravity energy is kept to O(tau^2), since c does no work on the potential energy either (control.hpp). Angular
/// momentum is not kept: water is handed over at two places. A_i - m_i/rho drifts by O(tau^2), with stabilisation at a
/// rate of its own; what stabilisation and the feedback of the drift do to the energy is booked.
///
/// When not to use it: high standing waves, where energy goes to short motions after a few periods; surfaces that turn
/// over, for nodes slide along them as functions of x.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 5.3.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/mechanics/plane_flow.hpp"
#include "seiche/mechanics/step_parts.hpp"
#include "seiche/models/variable_mass/control.hpp"

namespace seiche::variable_mass {

/// The convective term of masses that change: cells hand mass to one another, with half of either's velocity, and the
/// kinetic energy does not notice (Frank 1994, 5.3).
///
/// In a step node i gains the mass d_ij = -d_ji from its neighbours j. With a = sqrt(m), b = sqrt(m + sum_j d_ij)
/// before and after it, and velocities averaged with the roots of the masses,
///
/// @f[ \bar{u} = \frac{a u + b u'}{a + b}, \qquad
///     b^2 u' - a^2 u = \sum_j d_{ij} \frac{\bar{u}_i + \bar{u}_j}{2} + \text{impulse}, @f]
///
/// the kinetic energy changes by ubar.impulse exactly, whatever the exchanges, small or finite: they are antisymmetric.
/// The mean velocities solve
///
/// @f[ \frac{(a + b)^2}{2} \bar{u}_i - \sum_j \frac{d_{ij}}{2} \bar{u}_j = a (a + b) u_i + \text{impulse} @f]
///
/// by iteration on the sum. What is left of angular momentum is not kept: masses hand it over at two places.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), 5.3.
struct Exchange {
  int to;
  int from;
  double mass;  ///< in a step
};

class Convection {
 public:
  /// Throws mechanics::Infeasible naming the node whose mass would not be positive. @param at  of its place
  void begin(std::span<const double> masses, std::span<const Exchange> exchanges, Places at);

  [[nodiscard]] std::span<const double> next_masses() const { return next_; }
  /// (a + b)^2/2
  [[nodiscard]] std::span<const double> mean_masses() const { return mean_; }

  /// What answers momenta, in place, by mean velocities: divided by mean_masses() at least, with forces and pressures.
  using Respond = std::function<void(std::span<double>)>;
  /// Mean velocities, on entry a guess; all velocities along x, then all along y. Returns the number of iterations.
  /// @param kicks  largest velocity that forces give in the step, before pressures balance them: it is rounded too
  /// Throws mechanics::Infeasible where they do not settle.
  int settle(std::span<const double> u, const Respond& respond, double kicks, std::vector<double>& mean);
  /// u' = ((a + b) ubar - a u)/b.
  void finish(std::span<const double> u, std::span<const double> mean, std::vector<double>& next) const;

 private:
  static constexpr int most_iterations = 60;

  void momenta(std::span<const double> u, std::span<const double> mean, std::vector<double>& out) const;

  std::vector<Exchange> exchanges_;
  std::vector<double> root_, next_root_, next_, mean_;
  std::vector<double> iterate_;
};

using free_lagrangian::CellWater;
using free_lagrangian::Mesh;
using free_lagrangian::Settings;

/// The first instant; empty: flat, at rest.
struct Start {
  std::function<double(double x)> elevation = {};  ///< of the surface above the mesh at rest
  free_lagrangian::VelocityAt velocity = {};       ///< projected on constant areas
};

class Flow : public mechanics::PlaneFlow<CellWater> {
 public:
  /// @param rest            the mesh under a flat surface
  /// @param drift_feedback  share of A_i - m_i/rho that a step takes back, in [0, 1]
  /// Throws std::invalid_argument for bad input, a singular mesh without stabilisation among it.
  explicit Flow(const Mesh& rest, const Start& start = {}, Control control = {}, Settings settings = {},
                double drift_feedback = 0)
      : Flow(ControlVelocity(rest, control), start, settings, drift_feedback) {}

  /// One step of length tau > 0. Throws std::invalid_argument where a rate of the control times tau exceeds 1;
  /// Divergence, with time, step and place, where the mesh tangles, a mass would not be positive, the convective term
  /// does not settle, the surface goes back in x under control, a value is not finite. The state then is as before.
  void advance(double tau) override;

  [[nodiscard]] const CellWater& water() const { return *model_; }
  [[nodiscard]] const ControlVelocity& control() const { return control_; }
  [[nodiscard]] Places nodes() const { return model_->places(state_.q); }
  [[nodiscard]] std::span<const double> masses() const { return model_->masses(); }

  [[nodiscard]] long flips() const { return model_->triangulation().flips(); }
  /// Of the convective term, over all steps.
  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  Flow(ControlVelocity control, const Start& start, Settings settings, double drift_feedback);
  void take(double tau);
  /// What the cells hand to one another in the step, at the cells last measured.
  void gather_exchanges(Places at, double tau);

  ControlVelocity control_;
  std::unique_ptr<mechanics::StepParts<CellWater>> parts_;
  long iterations_ = 0;

  // Of a step.
  std::vector<double> velocity_;  // of the control
  std::vector<double> middle_, next_, rates_;
  std::vector<Exchange> exchanges_;
  Convection convection_;
  std::vector<free_lagrangian::Mobility> mobility_;
  std::vector<Point> force_;
  std::vector<double> defect_, mean_, next_u_;
};

}  // namespace seiche::variable_mass
