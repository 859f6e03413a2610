/// Choices of the conservative particle method that do not change the equations: level, limiter, thresholds.
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
  double theta = 2;              ///< generalised minmod: 1 most dissipative, 2 monotonised central
  int newton_steps = 4;          ///< fixed steps per edge; 4 reach round-off, conservation holds for any number
  double courant = 0.4;          ///< largest tau c / w that largest_step() proposes, at most 0.9
  double jump_threshold = 0.02;  ///< smallest relative depth jump that is handed over
  double isolation = 2;          ///< a jump must exceed this many times the variation beside it
};

}  // namespace seiche::shallow_water_particles
