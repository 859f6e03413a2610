/// Gauss's principle of least constraint on free particles in space, without walls: drops.
///
/// The equations are those of model.hpp, with fields v = rot A instead of those of a stream function. Energy is exact
/// for any space of fields; momentum and angular momentum are with a space that holds the translations and the
/// rotations, as that of all linear solenoidal fields does.
///
/// With the linear fields and masses of isotropic second moments, sum m r r^T = c I, about their centre, a velocity
/// G r of the particles stays one: with r = F r(0) the projection is of matrices of nine numbers alone, and of
///
/// @f[ F'' = 2 P_0 F^{-T}, \qquad P_0 = \frac{\mathrm{tr} (F' F^{-1})^2}{2 \, \mathrm{tr} (F F^T)^{-1}} @f]
///
/// (exact/affine_ellipsoid.hpp) there is only the error in time, for four particles as for a million. That the
/// transpose of a motion is a motion, Dedekind's theorem, holds for the steps as well.
///
/// When not to use it: walls, flows that are not polynomial; there are no splines in space.
///
/// References: Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 6; Dirichlet, J. reine
/// angew. Math. 58 (1861) 181; Dedekind, ibid. 217.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/gauss_particles/spatial_fields.hpp"

namespace seiche::gauss_particles {

struct SpatialParticles {
  std::vector<double> x, y, z;  ///< [m]
  std::vector<double> mass;     ///< [kg], positive
  [[nodiscard]] std::size_t size() const { return mass.size(); }
};

/// A ball of the radius about the origin, of shells of equal thickness: shell i of so many holds n = 6 i^2 particles,
/// in octahedra turned about, so that the second moments of each shell are isotropic. Masses are the shell's volume
/// over n, at the radius whose square is the mean square of the shell.
SpatialParticles ball(double radius, std::size_t shells, double density = 1);

class SpatialModel {
 public:
  /// @param gravity  along -z [m/s^2]. Throws std::invalid_argument: arrays of different lengths, masses not positive,
  ///                 places not finite, fields that are dependent on the particles.
  SpatialModel(SpatialParticles particles, SpatialFields fields, double gravity = 0);

  using Vector = std::array<double, 3>;
  /// The particles as they were given, with these velocities [m/s].
  [[nodiscard]] mechanics::State state(const std::function<Vector(const Vector& place)>& velocity) const;

  // What mechanics/constrained_model.hpp asks for; q and u are (along x of all, along y of all, along z of all).
  [[nodiscard]] std::size_t coordinates() const { return 3 * size(); }
  [[nodiscard]] std::size_t rates() const { return 3 * size(); }
  void linearise(mechanics::Interval when, mechanics::Input q);
  void kick(double h, mechanics::Output u) const;
  void advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const;
  void project(mechanics::Output u, mechanics::Input target, mechanics::Output mu);

  [[nodiscard]] double mass() const;                                                    ///< [kg]
  [[nodiscard]] Vector momentum(mechanics::Input q, mechanics::Input u) const;          ///< [kg m/s]
  [[nodiscard]] Vector angular_momentum(mechanics::Input q, mechanics::Input u) const;  ///< about the origin
  [[nodiscard]] double kinetic_energy(mechanics::Input q, mechanics::Input u) const;    ///< [J]
  [[nodiscard]] double potential_energy(mechanics::Input q) const;                      ///< [J]

  [[nodiscard]] std::size_t size() const { return particles_.size(); }
  [[nodiscard]] const SpatialParticles& particles() const { return particles_; }  ///< at the beginning
  [[nodiscard]] const SpatialFields& fields() const { return fields_; }

 private:
  SpatialParticles particles_;
  SpatialFields fields_;
  double gravity_;
};

}  // namespace seiche::gauss_particles
