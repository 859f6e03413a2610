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
/// r + (tau/2)(u + c) and the means of convection.hpp,
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
#include "seiche/mechanics/plane_flow.hpp"
#include "seiche/mechanics/step_parts.hpp"
#include "seiche/models/variable_mass/control.hpp"
#include "seiche/models/variable_mass/convection.hpp"

namespace seiche::variable_mass {

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

  [[nodiscard]] MeshQuality quality() const { return model_->quality(state_.q); }
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
