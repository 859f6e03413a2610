/// Walls that move: a piston or a flap hinged at the bottom, X_w = (S/2) sin(omega t) at the still-water level.
///
/// The flap turns rigidly by theta = atan(X_w/d) about its hinge: sheared instead, its row of particles would stretch
/// by sqrt(1 + (X_w/d)^2) and leak at large strokes.
#pragma once

#include <functional>

namespace seiche::wcsph {

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

}  // namespace seiche::wcsph
