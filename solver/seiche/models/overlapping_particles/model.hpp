/// Discrete incompressible fluid of gridless overlapping particles (Frank 1994, 5.1).
///
/// Particles k with fixed masses m_k are spread over discs. Around each particle s there is a control volume, a disc
/// too; volumes overlap and cover the water. What constrains the motion is that the mass in each of them stays:
///
/// @f[ m_k \ddot{\mathbf{r}}_k = \sum_s \lambda_s \frac{\partial f_s}{\partial \mathbf{r}_k} - m_k g \mathbf{e}_y,
///     \qquad f_s = \sum_k m_k \Phi(|\mathbf{r}_k - \mathbf{r}_s|) = f_s(0) @f]
///
/// @f[ \frac{\partial f_s}{\partial \mathbf{r}_k} = m_k \Phi'(d) \, \mathbf{e}_{sk} \;\; (k \ne s), \qquad
///     \frac{\partial f_s}{\partial \mathbf{r}_s} = - \sum_{k \ne s} m_k \Phi'(d) \, \mathbf{e}_{sk}, \qquad
///     d = |\mathbf{r}_k - \mathbf{r}_s|, \quad \mathbf{e}_{sk} = (\mathbf{r}_k - \mathbf{r}_s)/d @f]
///
/// The source says neither where the volumes are nor how the mass is spread: centred on the particles they are links
/// between particles, invariant to translation and rotation, and a free surface is nothing special. Phi: particles.hpp;
/// plane walls by mirror images: particles.hpp. Smooth multipliers would be a pressure, p = -rho^2 lambda_k/m_k; what
/// one step gives is chequered by hundreds of times as much.
///
/// Neighbours are found on a uniform grid of cells. A = G W G^T couples particles up to 2 S apart, some 60 in a row;
/// sparse Cholesky, analysed anew when the pattern changed.
///
/// **Singular configurations.** A free surface makes A regular. A lattice that fills a box with its mirror images, two
/// particles that are alone with each other, or one that is alone, make it singular. Stabilisation solves
///
/// @f[ \left(A + \epsilon \frac{\mathrm{tr} A}{N} L^T L\right) \lambda = \dots, \qquad
///     L \lambda = \lambda_k - \frac{\sum_s \Phi_{ks} \lambda_s}{\sum_s \Phi_{ks}} @f]
///
/// instead and takes energy from the water, in each step an amount that is known: stabilisation_loss().
///
/// Conserves, stepped by mechanics::OneStep: mass; linear and angular momentum of a free body, the momentum along its
/// walls of others, and the energy with what the stabilisation took, under gravity too (its potential is linear), all
/// to round-off. The masses in the volumes drift by O(tau^2).
///
/// When not to use it: for longer than shear takes to part neighbours. The model is right for smooth flow for less than
/// one turn of an eddy (a quarter of one's energy is lost to noise after a third of a turn); then the energy goes into
/// motions of single particles, without order and Gaussian like molecules', the "stochastic regime" of the source. What
/// is right after that are the statistics of an equilibrium, not the flow. Not for pressures. Not where the pressure is
/// below that of the surroundings, for an unstable surface grows the faster the nearer the particles.
///
/// The class is what mechanics::OneStep steps: q = (x of all particles, y of all), u = (velocities along x, along y).
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 5.1.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/ring_constraints.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/overlapping_particles/neighbourhoods.hpp"
#include "seiche/models/overlapping_particles/particles.hpp"
#include "seiche/ranges.hpp"

namespace seiche::overlapping_particles {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;
using mechanics::VelocityAt;

struct Settings {
  Shape shape = Shape::smoothed;
  double support = 2.6;      ///< S/h, of the spacing; 1.6 for balls
  double gravity = 0;        ///< [m/s^2], down along y
  double stabilisation = 0;  ///< epsilon
  std::vector<Wall> walls = {};

  static constexpr auto ranges() {
    return std::array{Number{"support", &Settings::support, Range::within(1.5, 10)},
                      Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"stabilisation", &Settings::stabilisation, Range::not_negative()}};
  }
};

class Model : public mechanics::PointMasses<Model> {
 public:
  /// Throws std::invalid_argument (particles.hpp): settings out of range, particles at one place, behind
  /// a wall, or without a neighbour.
  explicit Model(Particles particles, Settings settings = {});

  static constexpr bool warm_start = true;

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t constraints() const { return size(); }
  /// Throws mechanics::Infeasible: a particle that is not at a finite place, at another's, behind a wall, without
  /// neighbours; without stabilisation, where A is singular.
  void linearise(Interval when, Input q);
  /// Throws mechanics::Infeasible before `to` is touched where a particle would come behind a wall.
  void advance(Input from, Input u, double h, Output to) const;
  void kick(double h, Output u) const;
  void constraint_rates(Input u, Output w) const { volumes_.rates(u, w); }
  void react(Input mu, Output u) const { volumes_.react(mu, u); }
  void solve(Input right_hand_side, Output mu) { volumes_.solve(right_hand_side, mu); }
  /// f_s - f_s(0).
  void constraint_values(Input q, Output f) const;

  [[nodiscard]] std::span<const double> masses() const { return particles_.mass; }
  [[nodiscard]] Places given() const { return {particles_.x, particles_.y}; }
  [[nodiscard]] double potential_energy(Input q) const;  ///< g sum m y [J/m]

  /// Energy that the stabilisation takes in a step with these impulses of the multipliers, at the last linearisation
  /// [J/m]: 2 mu.(epsilon tr A/N) L^T L mu. Never negative.
  [[nodiscard]] double stabilisation_loss(Input impulses) const { return volumes_.stabilisation_loss(impulses); }

  [[nodiscard]] std::size_t size() const { return particles_.size(); }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Masses, and the places at the beginning.
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] double support() const { return kernel_.support(); }  ///< S [m]
  [[nodiscard]] const linear::RingSolver& solver() const { return volumes_.solver(); }
  /// A with its stabilisation, of the last linearisation.
  [[nodiscard]] const linear::RingMatrix& matrix() const { return volumes_.matrix(); }

 private:
  [[nodiscard]] Point at(Input q, std::size_t k) const { return {q[k], q[size() + k]}; }
  void require_places(Input q) const;
  /// Mass in the control volume of every particle.
  void sum_masses(Input q, Output f) const;
  void measure(Input q);

  Particles particles_;
  Settings settings_;
  Kernel kernel_;
  Walls walls_;
  std::vector<double> first_;  // f_s(0)
  Neighbourhoods near_;
  // Entry by entry of the neighbourhoods: of particle k by volume s,
  std::vector<Point> gradient_;     // df_s/dr_k
  std::vector<double> unevenness_;  // row k of L; empty without stabilisation
  mechanics::RingConstraints volumes_;
};

}  // namespace seiche::overlapping_particles
