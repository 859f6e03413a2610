/// Masses joined by rigid links of unit length in space: the smallest systems with every property of the models.
///
///     f_s = (|r_b - r_a|^2 - 1)/2,   Pi = sum m (g z + k |r|^2/2 + c z^3/3)
///
/// The first link may be pinned to the origin. Consecutive links share one mass, so A is tridiagonal. Linear, quadratic
/// and cubic potentials are there to be switched on; the constraints are quadratic.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/require.hpp"

namespace seiche::verification {

class RigidChain {
 public:
  struct Settings {
    std::vector<double> masses;
    bool pinned = false;
    double gravity = 0;
    double spring = 0;  ///< k: pulls every mass to the origin
    double cubic = 0;   ///< c
  };

  explicit RigidChain(Settings settings)
      : settings_(std::move(settings)), first_(settings_.pinned ? 0 : 1), links_(settings_.masses.size() - first_) {
    for (const double m : settings_.masses) require_positive("mass", m);
    link_.resize(3 * links_);
    diagonal_.resize(links_);
    off_diagonal_.resize(links_);
    force_.resize(coordinates());
  }

  [[nodiscard]] std::size_t coordinates() const { return 3 * settings_.masses.size(); }
  [[nodiscard]] std::size_t rates() const { return coordinates(); }
  [[nodiscard]] std::size_t constraints() const { return links_; }

  void linearise(mechanics::Interval, mechanics::Input q) {
    for (std::size_t i = 0; i < force_.size(); ++i) force_[i] = force(q, i);
    gradients(q);
    factor();
  }

  /// Links are bilinear: their discrete gradient is that at the middle. The potential is at most cubic: Simpson's rule.
  void linearise_between(mechanics::Interval, mechanics::Input q0, mechanics::Input q1, int sweep) {
    middle_.resize(q0.size());
    for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
    for (std::size_t i = 0; i < force_.size(); ++i) {
      force_[i] = (force(q0, i) + 4 * force(middle_, i) + force(q1, i)) / 6;
    }
    gradients(middle_);
    if (sweep == 0) factor();
  }

  void kick(double h, mechanics::Output u) const {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += h * force_[i];
  }

  void advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const {
    for (std::size_t i = 0; i < u.size(); ++i) to[i] = from[i] + h * u[i];
  }

  void constraint_rates(mechanics::Input u, mechanics::Output w) const {
    for (std::size_t s = 0; s < links_; ++s) w[s] = along_link(link_, u, s);
  }

  void react(mechanics::Input mu, mechanics::Output u) const {
    for (std::size_t s = 0; s < links_; ++s) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double impulse = mu[s] * link_[3 * s + c];
        const std::size_t b = s + first_;
        u[3 * b + c] += impulse / settings_.masses[b];
        if (b > 0) u[3 * (b - 1) + c] -= impulse / settings_.masses[b - 1];
      }
    }
  }

  void solve(mechanics::Input right_hand_side, mechanics::Output mu) {
    matrix_.solve(right_hand_side, mu);
    ++solves_;
    for (double& impulse : mu) impulse *= 1 + looseness_;
  }

  void constraint_values(mechanics::Input q, mechanics::Output f) const {
    for (std::size_t s = 0; s < links_; ++s) f[s] = 0.5 * (length_squared(q, s) - 1);
  }

  void curvature(mechanics::Input u, mechanics::Input v, mechanics::Output b) const {
    for (std::size_t s = 0; s < links_; ++s) {
      b[s] = 0;
      for (std::size_t c = 0; c < 3; ++c) b[s] += difference(u, s, c) * difference(v, s, c);
    }
  }

  [[nodiscard]] double kinetic_energy(mechanics::Input, mechanics::Input u) const {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += 0.5 * settings_.masses[i / 3] * u[i] * u[i];
    return sum;
  }
  [[nodiscard]] double potential_energy(mechanics::Input q) const {
    double sum = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      double height = settings_.spring * q[i] * q[i] / 2;
      if (i % 3 == 2) height += settings_.gravity * q[i] + settings_.cubic * q[i] * q[i] * q[i] / 3;
      sum += settings_.masses[i / 3] * height;
    }
    return sum;
  }
  [[nodiscard]] std::array<double, 3> momentum(mechanics::Input, mechanics::Input u) const {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < u.size(); ++i) sum[i % 3] += settings_.masses[i / 3] * u[i];
    return sum;
  }
  [[nodiscard]] std::array<double, 3> angular_momentum(mechanics::Input q, mechanics::Input u) const {
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < q.size(); k += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t a = k + (c + 1) % 3;
        const std::size_t b = k + (c + 2) % 3;
        sum[c] += settings_.masses[k / 3] * (q[a] * u[b] - q[b] * u[a]);
      }
    }
    return sum;
  }

  /// Every impulse of a solve is wrong by this fraction from now on, as an iterative solver's would be.
  void loosen(double relative_error) { looseness_ = relative_error; }
  [[nodiscard]] long solves() const { return solves_; }
  void reset_solves() { solves_ = 0; }

 private:
  /// Force per mass.
  [[nodiscard]] double force(mechanics::Input q, std::size_t i) const {
    double f = -settings_.spring * q[i];
    if (i % 3 == 2) f -= settings_.gravity + settings_.cubic * q[i] * q[i];
    return f;
  }
  [[nodiscard]] double difference(mechanics::Input v, std::size_t s, std::size_t c) const {
    const std::size_t b = s + first_;
    return v[3 * b + c] - (b > 0 ? v[3 * (b - 1) + c] : 0.0);
  }
  [[nodiscard]] double length_squared(mechanics::Input q, std::size_t s) const {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += difference(q, s, c) * difference(q, s, c);
    return sum;
  }
  [[nodiscard]] double along_link(mechanics::Input link, mechanics::Input u, std::size_t s) const {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += link[3 * s + c] * difference(u, s, c);
    return sum;
  }
  void gradients(mechanics::Input q) {
    for (std::size_t s = 0; s < links_; ++s) {
      for (std::size_t c = 0; c < 3; ++c) link_[3 * s + c] = difference(q, s, c);
    }
  }
  void factor() {
    for (std::size_t s = 0; s < links_; ++s) {
      const std::size_t b = s + first_;
      double square = 0;
      double across = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        square += link_[3 * s + c] * link_[3 * s + c];
        if (s + 1 < links_) across += link_[3 * s + c] * link_[3 * (s + 1) + c];
      }
      diagonal_[s] = square * (1 / settings_.masses[b] + (b > 0 ? 1 / settings_.masses[b - 1] : 0.0));
      off_diagonal_[s] = -across / settings_.masses[b];
    }
    matrix_.factor({diagonal_, off_diagonal_});
  }

  Settings settings_;
  std::size_t first_;  // mass at the far end of the first link
  std::size_t links_;
  std::vector<double> link_, diagonal_, off_diagonal_, force_, middle_;
  linear::Tridiagonal matrix_;
  double looseness_ = 0;
  std::minstd_rand random_;
  long solves_ = 0;
};

/// The chain of the tests: links point along (sin a cos b, sin a sin b, -cos a), a = 0.9 + 0.4 k, b = 0.7 k; velocities
/// (-0.5 y + 0.1 k, 0.6 x, 0.2 sin(k+1)), projected; masses 1 and 1.3 in turn.
inline std::vector<double> alternating_masses(std::size_t count) {
  std::vector<double> masses;
  for (std::size_t k = 0; k < count; ++k) masses.push_back(1 + 0.3 * static_cast<double>(k % 2));
  return masses;
}

inline mechanics::State spiral_start(RigidChain& chain) {
  mechanics::State state;
  std::array<double, 3> r{};
  for (std::size_t i = 0; 3 * i < chain.coordinates(); ++i) {
    const auto k = static_cast<double>(i);
    const double a = 0.9 + 0.4 * k;
    const double b = 0.7 * k;
    r = {r[0] + std::sin(a) * std::cos(b), r[1] + std::sin(a) * std::sin(b), r[2] - std::cos(a)};
    state.q.insert(state.q.end(), r.begin(), r.end());
    state.u.insert(state.u.end(), {-0.5 * r[1] + 0.1 * k, 0.6 * r[0], 0.2 * std::sin(k + 1)});
  }
  mechanics::Start(chain).project(state);
  return state;
}

/// Spherical double pendulum, pinned at the origin, unit gravity.
inline RigidChain double_pendulum() {
  return RigidChain({.masses = alternating_masses(2), .pinned = true, .gravity = 1});
}

/// Eleven masses, ten links, free, without gravity.
inline RigidChain free_chain() {
  return RigidChain({.masses = alternating_masses(11)});
}

}  // namespace seiche::verification
