// From particle means to one velocity and one thrust per edge, and the motion: loops over the whole row.
//
// A stretch of particles goes through several loops while it is in the cache. Where stretches begin does not depend on
// the number of threads, and no loop reads what another stretch writes: results are the same for any number.
#include <algorithm>

#include <omp.h>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"

namespace seiche::shallow_water_particles {
namespace {

constexpr std::size_t stretch = 2048;  // particles

}  // namespace

std::size_t ParticleFlow::stretches() const {
  return (now_.size() + stretch - 1) / stretch;
}

/// A bed or a body force may be anything but safe to be asked by two threads.
std::size_t ParticleFlow::threads() const {
  const bool worth = now_.size() >= linear::worth_threads && !forcing_.bed && !forcing_.body_force;
  return worth ? static_cast<std::size_t>(omp_get_max_threads()) : 1;
}

/// Edge values of particles [first, last), `to` beginning with the first.
void ParticleFlow::predict_particles(double tau, std::size_t first, std::size_t last, EdgeValues& to) const {
  const auto one = [&](std::size_t i) {
    const EdgePair e = edges_of(i, 0.5 * tau);
    to.left_depth[i - first] = e.h_left;
    to.right_depth[i - first] = e.h_right;
    to.left_velocity[i - first] = e.u_left;
    to.right_velocity[i - first] = e.u_right;
  };
  const bool plain = !forcing_.bed && !forcing_.body_force && forcing_.manning == 0 && scheme_.level != Level::godunov;
  if (!plain) {
    for (std::size_t i = first; i < last; ++i) one(i);
    return;
  }
  const std::size_t count = now_.size();
  const std::size_t begin = std::max<std::size_t>(first, 1);
  const std::size_t end = std::min(last, count - 1);
  const std::size_t at = begin - first;
  if (begin < end) {
    predict_row({&now_.edge[begin], &depth_[begin], &now_.velocity[begin], &inv_mass_[begin], &to.left_depth[at],
                 &to.right_depth[at], &to.left_velocity[at], &to.right_velocity[at], forcing_.gravity, scheme_.theta,
                 0.5 * tau},
                end - begin);
  }
  // Ends, neighbours of a tip, particles that hold a jump and their neighbours are not plain.
  const auto again = [&](std::size_t i) {
    if (i >= first && i < last) one(i);
  };
  for (const Side s : {side(false), side(true)}) {
    again(s.particle(0));
    if (has_tip(s)) again(s.particle(1));
  }
  const auto near = std::lower_bound(structures_.begin(), structures_.end(), first,
                                     [](const Structure& s, std::size_t v) { return s.particle + 1 < v; });
  for (auto s = near; s != structures_.end() && s->particle <= last; ++s) {
    if (s->particle > 0) again(s->particle - 1);
    again(s->particle);
    again(s->particle + 1);
  }
}

/// Edges before the particles [first, last); the last one before is predicted once more, for the edge between.
void ParticleFlow::solve_stretch(double tau, std::size_t first, std::size_t last, EdgeValues& values) {
  const std::size_t from = first > 0 ? first - 1 : 0;
  predict_particles(tau, from, last, values);
  const std::size_t edge = from + 1;
  solve_row({values.right_depth.data(), values.right_velocity.data(), &values.left_depth[1], &values.left_velocity[1],
             &edge_velocity_[edge], &edge_thrust_[edge], forcing_.gravity},
            last - edge);
  if (first == 0) at_end_[0] = {values.left_depth[0], values.left_velocity[0]};
  if (last == now_.size()) at_end_[1] = {values.right_depth[last - edge], values.right_velocity[last - edge]};
  if (!keeps_edge_values()) return;
  for (std::size_t k = 0; k < 4; ++k) {
    std::copy_n(values.all()[k]->data() + (first - from), last - first, values_.all()[k]->data() + first);
  }
}

void ParticleFlow::solve_edges(double tau) {
  const std::size_t count = now_.size();
  while (edge_values_.size() < threads()) {
    edge_values_.emplace_back();
    edge_values_.back().resize(stretch + 1);
  }
  share(stretches(), threads(), [&](std::size_t s, std::size_t thread) {
    solve_stretch(tau, s * stretch, std::min((s + 1) * stretch, count), edge_values_[thread]);
  });
  solve_end(side(false), tau);
  solve_end(side(true), tau);
}

RowLimits ParticleFlow::measure(std::size_t first, std::size_t last) {
  return measure_row(&now_.edge[first], &now_.velocity[first], &now_.mass[first], &depth_[first], forcing_.gravity,
                     last - first, last < now_.size());
}

/// A particle is measured once its right edge and its neighbour have moved: the last of a stretch after all others.
RowLimits ParticleFlow::move_and_measure(double tau) {
  const std::size_t count = now_.size();
  stretch_limits_.resize(stretches());
  share(stretches(), threads(), [&](std::size_t s, std::size_t /*thread*/) {
    const std::size_t first = s * stretch;
    const std::size_t last = std::min(first + stretch, count);
    move_row(&now_.edge[first], &now_.velocity[first], &inv_mass_[first], &edge_velocity_[first], &edge_thrust_[first],
             tau, last - first, last == count);
    stretch_limits_[s] = measure(first, last - 1);
  });
  RowLimits limits;
  for (std::size_t s = 0; s < stretches(); ++s) {
    const std::size_t last = std::min((s + 1) * stretch, count);
    limits.add(stretch_limits_[s]);
    limits.add(measure(last - 1, last));
  }
  return limits;
}

}  // namespace seiche::shallow_water_particles
