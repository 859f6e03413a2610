/// Serre's solitary wave that runs into a wall y = 0 at an angle, and the flows of two models that carry it.
///
///     elevation a sech^2(k s),   s = (x - crest) cos psi - y sin psi - c t
///
/// The water lies in a window that follows the crest along the wall: 0 <= y <= height, with the undisturbed wave let in
/// at the north side, water at rest ahead, and a rear side whose influence cannot catch up: the crest runs along the
/// wall at c/cos psi, faster than any wave behind it.
#pragma once

#include <cmath>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "validation/instruments/plan/surface_lattice.hpp"

namespace seiche::validation {

/// Depth 1, gravity 1.
class ObliqueWave {
 public:
  /// @param angle  psi between the crest and the normal of the wall [rad], 0 to 75 degrees
  /// @param crest  x of the crest on the wall at t = 0
  /// Throws std::invalid_argument.
  ObliqueWave(double amplitude, double angle, double crest = 0);

  [[nodiscard]] double amplitude() const { return amplitude_; }
  [[nodiscard]] double angle() const { return angle_; }
  [[nodiscard]] double elevation(double x, double y, double time) const { return wave_.elevation(phase(x, y, time)); }
  /// Of the water at the surface; the horizontal one is that of the whole column.
  [[nodiscard]] dispersive_shallow_water_2d::Velocity velocity(double x, double y, double time) const;
  /// x of the crest at y.
  [[nodiscard]] double crest_at(double y, double time) const;
  /// Distance along x ahead of the crest beyond which the wave is lower than 1e-5 (of the depth).
  [[nodiscard]] double margin() const;
  /// Widths of waves go like sqrt(0.3/a) of that with a = 0.3.
  [[nodiscard]] double width_unit() const { return std::sqrt(0.3 / amplitude_); }

 private:
  [[nodiscard]] double phase(double x, double y, double time) const;

  double amplitude_, angle_, crest_;
  exact::SerreSolitary wave_;
};

/// The window of a run.
struct ReflectionWindow {
  double spacing;  ///< of the lattice at rest, both ways
  double height;   ///< along y, at least
  double rear;     ///< behind the crest on the wall
  /// The first wave is higher than the undisturbed one by this part next to the wall, and faster; at six width units
  /// from it by a third of that. For runs that show how little the end owes to the start.
  double excess = 0;
};

/// The window of a run that ends at `time`.
///
/// Its height: where the stem will end at most, and 36 or 46 width units for the wave to be undisturbed there. At most:
/// the lesser of two angles of the path of the stem's end. That of the theory of small amplitudes is too large for high
/// waves, and so is, next to resonance, the one at which the crests of stem and incident wave stay together,
/// tan chi = (cos psi - c_i/c_w)/sin psi, c = sqrt(1 + a), with the theory's a_w.
///
/// Its rear: the reflected crest must not stay where the rear and the north side meet, for the lattice tangles there.
/// If the crest is steep it leaves the window 10 width units below the corner, else it meets the north side well
/// before, and the window ends before the wave that returns from there meets the wall.
ReflectionWindow window_until(double time, const ObliqueWave& wave, double spacing);

/// What a flow of the plan model in that window is made of.
struct PlanReflection {
  dispersive_shallow_water_2d::Rectangle water;
  dispersive_shallow_water_2d::VelocityAt velocity;
  plan_lattice::Window window;
};
PlanReflection plan_reflection(const ObliqueWave& wave, const ReflectionWindow& window);

dispersive_shallow_water_2d::Flow reflection_flow(const ObliqueWave& wave, const ReflectionWindow& window,
                                                  dispersive_shallow_water_2d::Settings settings,
                                                  dispersive_shallow_water_2d::Scheme scheme = {});

/// The same water, of depth 1, in layers of hexahedra: horizontal velocities of the column, vertical ones linear in the
/// height.
lagrangian_mesh_3d::Layer layers_of(const dispersive_shallow_water_2d::Rectangle& water, std::size_t layers);
lagrangian_mesh_3d::VelocityAt layered(const dispersive_shallow_water_2d::VelocityAt& of_columns,
                                       const dispersive_shallow_water_2d::Rectangle& water);
struct LayeredReflection {
  lagrangian_mesh_3d::Layer water;
  lagrangian_mesh_3d::VelocityAt velocity;
  plan_lattice::Window window;
};
LayeredReflection layered_reflection(const ObliqueWave& wave, const ReflectionWindow& window, std::size_t layers);

lagrangian_mesh_3d::Flow layered_reflection_flow(const ObliqueWave& wave, const ReflectionWindow& window,
                                                 std::size_t layers, lagrangian_mesh_3d::Settings settings,
                                                 lagrangian_mesh_3d::Scheme scheme = {});

/// The surface of a flow at this moment; valid until its next step.
SurfaceLattice surface_of(const dispersive_shallow_water_2d::Flow& flow);
SurfaceLattice surface_of(const lagrangian_mesh_3d::Flow& flow);

}  // namespace seiche::validation
