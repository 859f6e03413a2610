/// Choices of the conservative particle method that do not change the equations: level, limiter, step.
#pragma once

namespace seiche::shallow_water_particles {

/// How an edge between two particles gets its velocity and pressure.
enum class Level {
  godunov,  ///< G1: Riemann problem of the two particle means; first order, a jump is 3-4 particles wide
  muscl,    ///< M2: limited linear reconstruction and a half-step predictor; second order, a jump is 1-3 particles wide
  hand_over  ///< H2: M2 with the jump kept inside one particle and handed from one to the next; isolated jumps are
             ///< exact
};

/// Numerical parameters with the values recommended for all flows.
struct Scheme {
  Level level = Level::hand_over;
  double theta = 2;      ///< generalised minmod: 1 most dissipative, 2 monotonised central
  double courant = 0.4;  ///< largest tau c / w that largest_step() proposes, at most 0.9
};

/// Smallest relative depth jump that is handed over.
inline constexpr double jump_threshold = 0.02;

}  // namespace seiche::shallow_water_particles
