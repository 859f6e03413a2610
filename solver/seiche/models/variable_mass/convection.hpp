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
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche::variable_mass {

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

}  // namespace seiche::variable_mass
