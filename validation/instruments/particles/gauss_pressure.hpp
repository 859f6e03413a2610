/// The pressure behind the reactions of a step.
///
/// At the places of the projection grad p = rho (2/tau)(w - u~), particle by particle, with the lattice's residue of 1
/// to 10 per cent in it; its smooth part is accurate. It is fitted by a pressure that vanishes on the surface, a level
/// function times a polynomial:
///
/// @f[ p = \ell(x, y) \sum_{i + j \le d} a_{ij} \, x^i y^j, \qquad
///     \sum_k m_k \left| \rho \frac{2}{\tau} (\mathbf{w}_k - \tilde{\mathbf{u}}_k) - \nabla p(\mathbf{q}_k) \right|^2 =
///     \min @f]
///
/// When not to use it: surfaces without a level function, as after breaking.
#pragma once

#include <functional>
#include <vector>

#include "seiche/models/gauss_particles/model.hpp"

namespace seiche::gauss_particles {

/// A function that is zero on the surface, with its gradient.
struct Level {
  double value = 0;
  Point gradient = {};
};

class PressureFit {
 public:
  /// Of the model's last step, taken by the conservative scheme.
  /// @param tau  its length. @param degree  d, of the polynomial
  /// Throws std::invalid_argument: tau not positive, degree negative, no level function; std::logic_error before a
  /// step.
  PressureFit(const Model& model, double tau, std::function<Level(Point place)> level, int degree);

  [[nodiscard]] double pressure(Point place) const;  ///< [Pa]

 private:
  std::function<Level(Point place)> level_;
  int degree_;
  std::vector<double> coefficients_;
};

}  // namespace seiche::gauss_particles
