/// The three loops over a row of particles on a flat bed that take all the time, written to vectorise.
///
/// They hold no choices: ends, interior jumps, beds and sources are dealt with outside, particle by particle. Each is
/// compiled for the instruction sets of common processors and picked at run time; results do not depend on the
/// number of threads and are the same in every run on one machine.
#pragma once

#include <cstddef>

namespace seiche::shallow_water_particles {

/// Limited reconstruction and half-step prediction of particles [first, last); reads one particle to either side.
struct PredictionRow {
  const double* edge;
  const double* depth;
  const double* velocity;
  const double* inv_mass;
  double* left_depth;
  double* right_depth;
  double* left_velocity;
  double* right_velocity;
  double gravity;
  double theta;
  double half_step;
};
void predict_row(const PredictionRow& row, std::size_t first, std::size_t last);

/// Riemann problems of edges [first, last), edge k between particles k-1 and k.
struct EdgeRow {
  const double* left_depth;
  const double* right_depth;
  const double* left_velocity;
  const double* right_velocity;
  double* edge_velocity;
  double* edge_thrust;
  double gravity;
  int newton_steps;
};
/// Where both differences over an edge are below 1e-4 (of depth and celerity), jump and simple wave differ by less
/// than 1e-13: the two-wave state is taken without iteration, a block of edges at a time.
void solve_row(const EdgeRow& row, std::size_t first, std::size_t last);

/// x += tau u*, u += tau (p*_i - p*_(i+1))/m.
void move_row(double* edge, double* velocity, const double* inv_mass, const double* edge_velocity,
              const double* edge_thrust, double tau, std::size_t count);

/// What a row must not exceed.
struct RowLimits {
  double celerity_rate = 0;  ///< max c/w [1/s]
  double closing_rate = 0;   ///< max (u_i - u_(i+1))/w_i [1/s]
  bool sound = true;         ///< every width positive, every velocity finite
};
/// Inverse widths and depths of all particles, and the limits.
RowLimits measure_row(const double* edge, const double* velocity, const double* mass, double* inv_width, double* depth,
                      double gravity, std::size_t count);

/// True when some particle i in [first, last) may hold a jump of relative height `threshold` or more between i-1 and
/// i+1: a necessary condition without roots or divisions.
bool may_hold_jump(const double* depth, const double* velocity, double gravity, double threshold, std::size_t first,
                   std::size_t last);

}  // namespace seiche::shallow_water_particles
