/// Masses joined by rigid links of unit length in space: the smallest system with every property of the models.
///
/// @f[ f_s = \frac{|\mathbf{r}_b - \mathbf{r}_a|^2 - 1}{2}, \qquad
///     \Pi = \sum m \left( g z + \frac{k |\mathbf{r}|^2}{2} + \frac{c z^3}{3} \right) @f]
///
/// The first link may be pinned to the origin. Consecutive links share one mass, so A = J M^-1 J^T is tridiagonal.
/// The constraints are quadratic; linear, quadratic and cubic potentials are there to be switched on.
///
/// When not to use it: it is there to measure integrators with, not to compute chains; links never go slack.
///
/// Reference: Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), VII.1 (pendulums and chains as
/// constrained systems in Cartesian coordinates).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "seiche/geometry/vector.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::rigid_chain {

class RigidChain {
 public:
  struct Settings {
    std::vector<double> masses;
    bool pinned = false;
    double gravity = 0;
    double spring = 0;  ///< k: pulls every mass to the origin
    double cubic = 0;   ///< c
  };

  /// Throws std::invalid_argument for masses that are not positive and for a chain without links.
  explicit RigidChain(Settings settings);

  [[nodiscard]] std::size_t coordinates() const { return 3 * settings_.masses.size(); }
  [[nodiscard]] std::size_t rates() const { return coordinates(); }
  [[nodiscard]] std::size_t constraints() const { return links_; }
  [[nodiscard]] const std::vector<double>& masses() const { return settings_.masses; }

  void linearise(mechanics::Interval when, mechanics::Input q);
  /// Links are bilinear: their discrete gradient is that at the middle. The potential is at most cubic: Simpson's rule.
  void linearise_between(mechanics::Interval when, mechanics::Input q0, mechanics::Input q1, int sweep);

  void kick(double h, mechanics::Output u) const {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += h * force_[i];
  }
  void advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const {
    for (std::size_t i = 0; i < u.size(); ++i) to[i] = from[i] + h * u[i];
  }
  void constraint_rates(mechanics::Input u, mechanics::Output w) const;
  void react(mechanics::Input mu, mechanics::Output u) const;
  void solve(mechanics::Input right_hand_side, mechanics::Output mu) {
    matrix_.solve(right_hand_side, mu);
    ++solves_;
  }

  void constraint_values(mechanics::Input q, mechanics::Output f) const;
  void curvature(mechanics::Input u, mechanics::Input v, mechanics::Output b) const;

  [[nodiscard]] double kinetic_energy(mechanics::Input q, mechanics::Input u) const;
  [[nodiscard]] double potential_energy(mechanics::Input q) const;
  [[nodiscard]] std::array<double, 3> momentum(mechanics::Input q, mechanics::Input u) const;
  [[nodiscard]] std::array<double, 3> angular_momentum(mechanics::Input q, mechanics::Input u) const;

  /// Solves with A so far: what a step costs, whatever the model.
  [[nodiscard]] long solves() const { return solves_; }

 private:
  [[nodiscard]] double force_per_mass(mechanics::Input q, std::size_t i) const;
  /// Of the far end of a link less the near one.
  [[nodiscard]] Vector3 along(mechanics::Input v, std::size_t s) const;
  void find_links(mechanics::Input q);
  void factor();

  Settings settings_;
  std::size_t first_;  // mass at the far end of the first link
  std::size_t links_;
  std::vector<Vector3> link_;
  std::vector<double> diagonal_, off_diagonal_, force_, middle_;
  linear::TwoEndedTridiagonal matrix_;
  long solves_ = 0;
};

/// Sums of the magnitudes that energy, momentum and angular momentum are made of: what their rounding is relative to.
struct Scales {
  double energy = 0;
  double momentum = 0;
  double angular_momentum = 0;

  void include(const Scales& other);
};
Scales scales_of(const RigidChain& chain, const mechanics::State& state);

/// 1 and 1.3 in turn.
std::vector<double> alternating_masses(std::size_t count);

/// Links along (sin a cos b, sin a sin b, -cos a), a = 0.9 + 0.4 k, b = 0.7 k; velocities (-0.5 y + 0.1 k, 0.6 x,
/// 0.2 sin(k + 1)), projected.
mechanics::State spiral_start(RigidChain& chain);

/// Spherical double pendulum of masses 1 and 1.3, pinned at the origin, unit gravity: a linear potential.
RigidChain double_pendulum();

/// Eleven masses, ten links, free, without potential.
RigidChain free_chain();

}  // namespace seiche::rigid_chain

namespace seiche::mechanics {

extern template class OneStep<rigid_chain::RigidChain>;
extern template class ConservativeStep<rigid_chain::RigidChain>;
extern template class SchemeStepper<rigid_chain::RigidChain>;
extern template class Start<rigid_chain::RigidChain>;
extern template class InvariantsWatch<rigid_chain::RigidChain>;

}  // namespace seiche::mechanics
