/// Particles of weakly compressible SPH: one array per quantity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace seiche::wcsph {

/// Fluid moves by the equations; walls stand; paddle k (kind = paddle, body = k) is carried by its motion.
enum class Kind : std::uint8_t { fluid, wall, paddle };

/// x horizontal, z up [m]; velocities [m/s]; density [kg/m^3]; mass per unit width [kg/m].
struct Particles {
  std::vector<double> x, z, u, w, density, mass;
  std::vector<Kind> kind;
  std::vector<std::int32_t> body;      ///< index of the paddle that carries the particle; -1 otherwise
  std::vector<std::int32_t> identity;  ///< number of the particle in the order of the beginning; sorting keeps it

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Appends one particle with the next identity.
  void add(double x_, double z_, double mass_, double density_, Kind kind_ = Kind::fluid, double u_ = 0, double w_ = 0,
           std::int32_t body_ = -1);
  [[nodiscard]] std::size_t count(Kind wanted) const;
};

// Walls that move: a piston or a flap hinged at the bottom, X_w = (S/2) sin(omega t) at the still-water level.
//
// The flap turns rigidly by theta = atan(X_w/d) about its hinge: sheared instead, its row of particles would stretch
// by sqrt(1 + (X_w/d)^2) and leak at large strokes.

/// Where a rigid body is: turned by angle about (hinge_x, hinge_z), then displaced along x.
struct Pose {
  double displacement = 0;  ///< [m]
  double angle = 0;         ///< [rad], positive: the top goes towards +x
};

/// A rigid body that carries particles. Particle positions of the beginning belong to the pose {0, 0}.
struct Paddle {
  double hinge_x = 0;
  double hinge_z = 0;
  std::function<Pose(double time)> pose;
  std::function<Pose(double time)> rate;  ///< its derivative with respect to time
};

struct PointMotion {
  double x, z, u, w;
};
/// Position and velocity at a time of the particle that is at (x, z) in the pose {0, 0}.
PointMotion carried(const Pose& pose, const Pose& rate, double hinge_x, double hinge_z, double x, double z);

/// @param stroke  S [m];  @param frequency  omega [1/s]
Paddle piston(double stroke, double frequency);
/// @param depth  d [m], from the hinge to the still-water level. Throws std::invalid_argument.
Paddle flap(double hinge_x, double hinge_z, double depth, double stroke, double frequency);

/// Arrays of one length, values finite, masses and densities positive, carriers that exist and can be asked. Throws
/// std::invalid_argument.
void check_particles(const Particles& particles, std::span<const Paddle> paddles);

}  // namespace seiche::wcsph
