/// The loops over a row of particles on a flat bed that take all the time, written to vectorise.
///
/// They hold no choices: ends, interior jumps, beds and sources are dealt with outside, particle by particle. Each is
/// compiled for the instruction sets of common processors and picked at run time. Pointers are to the first particle or
/// edge of the row: what a row makes of a particle does not depend on where the row begins.
#pragma once

#include <cstddef>

#include <omp.h>

namespace seiche::shallow_water_particles {

/// Limited reconstruction and half-step prediction of `count` particles; reads one particle to either side.
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
void predict_row(const PredictionRow& row, std::size_t count);

/// Riemann problems of `count` edges, between the particle before and the one behind.
struct EdgeRow {
  const double* depth_before;
  const double* velocity_before;
  const double* depth_behind;
  const double* velocity_behind;
  double* edge_velocity;
  double* edge_thrust;
  double gravity;
};
/// Where both differences over an edge are below 1e-4 (of depth and celerity), jump and simple wave differ by less
/// than 1e-13: the two-wave state is taken without iteration, a block of edges at a time, counted from the row's first.
void solve_row(const EdgeRow& row, std::size_t count);

/// x += tau u*, u += tau (p*_i - p*_(i+1))/m, of `count` particles and their left edges.
/// @param closes  whether the row's last edge moves too
void move_row(double* edge, double* velocity, const double* inv_mass, const double* edge_velocity,
              const double* edge_thrust, double tau, std::size_t count, bool closes);

/// What a row must not exceed.
struct RowLimits {
  double celerity_rate = 0;  ///< max c/w [1/s]
  double closing_rate = 0;   ///< max (u_i - u_(i+1))/w_i [1/s]
  bool sound = true;         ///< every width positive, every velocity finite

  /// Of both rows.
  void add(const RowLimits& other);
};
/// Depths of `count` particles, and the limits.
/// @param goes_on  whether a particle follows that the last one may close in on
RowLimits measure_row(const double* edge, const double* velocity, const double* mass, double* depth, double gravity,
                      std::size_t count, bool goes_on);

/// True when some particle of `count` may hold a jump of relative height `threshold` or more between its neighbours: a
/// necessary condition without roots or divisions.
bool may_hold_jump(const double* depth, const double* velocity, double gravity, double threshold, std::size_t count);

/// Calls work(k, thread) for 0, ..., count - 1.
template <class Work>
void share(std::size_t count, std::size_t threads, const Work& work) {
  if (threads == 1) {  // a parallel region of one costs as much as a hundred particles
    for (std::size_t k = 0; k < count; ++k) work(k, std::size_t{0});
    return;
  }
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads))
  for (std::size_t k = 0; k < count; ++k) work(k, static_cast<std::size_t>(omp_get_thread_num()));
}

}  // namespace seiche::shallow_water_particles
