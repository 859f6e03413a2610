#include "validation/instruments/mechanics/rigid_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::rigid_chain {

using mechanics::Input;
using mechanics::Output;

namespace {

Vector3 vector(Input v, std::size_t k) {
  return {v[3 * k], v[3 * k + 1], v[3 * k + 2]};
}
double length(Vector3 v) {
  return std::hypot(v.x, v.y, v.z);
}
void put(Vector3 a, std::size_t k, Output v) {
  v[3 * k] = a.x;
  v[3 * k + 1] = a.y;
  v[3 * k + 2] = a.z;
}

}  // namespace

RigidChain::RigidChain(Settings settings) : settings_(std::move(settings)), first_(settings_.pinned ? 0 : 1) {
  require_at_least("number of masses", static_cast<long>(settings_.masses.size()), static_cast<long>(first_) + 1);
  for (const double m : settings_.masses) require_positive("mass", m);
  links_ = settings_.masses.size() - first_;
  link_.resize(links_);
  diagonal_.resize(links_);
  off_diagonal_.resize(links_);
  force_.resize(coordinates());
}

void RigidChain::linearise(mechanics::Interval, Input q) {
  for (std::size_t i = 0; i < force_.size(); ++i) force_[i] = force_per_mass(q, i);
  find_links(q);
  factor();
}

void RigidChain::linearise_between(mechanics::Interval, Input q0, Input q1, int sweep) {
  middle_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
  for (std::size_t i = 0; i < force_.size(); ++i) {
    force_[i] = (force_per_mass(q0, i) + 4 * force_per_mass(middle_, i) + force_per_mass(q1, i)) / 6;
  }
  find_links(middle_);
  if (sweep == 0) factor();
}

void RigidChain::constraint_rates(Input u, Output w) const {
  for (std::size_t s = 0; s < links_; ++s) w[s] = dot(link_[s], along(u, s));
}

void RigidChain::react(Input mu, Output u) const {
  for (std::size_t s = 0; s < links_; ++s) {
    const std::size_t b = s + first_;
    const Vector3 impulse = mu[s] * link_[s];
    put(vector(u, b) + impulse / settings_.masses[b], b, u);
    if (b > 0) put(vector(u, b - 1) - impulse / settings_.masses[b - 1], b - 1, u);
  }
}

void RigidChain::constraint_values(Input q, Output f) const {
  for (std::size_t s = 0; s < links_; ++s) f[s] = 0.5 * (dot(along(q, s), along(q, s)) - 1);
}

void RigidChain::curvature(Input u, Input v, Output b) const {
  for (std::size_t s = 0; s < links_; ++s) b[s] = dot(along(u, s), along(v, s));
}

double RigidChain::kinetic_energy(Input, Input u) const {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += 0.5 * settings_.masses[i / 3] * u[i] * u[i];
  return sum;
}

double RigidChain::potential_energy(Input q) const {
  double sum = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    double height = settings_.spring * q[i] * q[i] / 2;
    if (i % 3 == 2) height += settings_.gravity * q[i] + settings_.cubic * q[i] * q[i] * q[i] / 3;
    sum += settings_.masses[i / 3] * height;
  }
  return sum;
}

std::array<double, 3> RigidChain::momentum(Input, Input u) const {
  Vector3 sum;
  for (std::size_t k = 0; k < masses().size(); ++k) sum = sum + masses()[k] * vector(u, k);
  return {sum.x, sum.y, sum.z};
}

std::array<double, 3> RigidChain::angular_momentum(Input q, Input u) const {
  Vector3 sum;
  for (std::size_t k = 0; k < masses().size(); ++k) sum = sum + masses()[k] * cross(vector(q, k), vector(u, k));
  return {sum.x, sum.y, sum.z};
}

double RigidChain::force_per_mass(Input q, std::size_t i) const {
  double f = -settings_.spring * q[i];
  if (i % 3 == 2) f -= settings_.gravity + settings_.cubic * q[i] * q[i];
  return f;
}

Vector3 RigidChain::along(Input v, std::size_t s) const {
  const std::size_t b = s + first_;
  return vector(v, b) - (b > 0 ? vector(v, b - 1) : Vector3{});
}

void RigidChain::find_links(Input q) {
  for (std::size_t s = 0; s < links_; ++s) link_[s] = along(q, s);
}

void RigidChain::factor() {
  for (std::size_t s = 0; s < links_; ++s) {
    const std::size_t b = s + first_;
    const double across = s + 1 < links_ ? dot(link_[s], link_[s + 1]) : 0;
    diagonal_[s] = dot(link_[s], link_[s]) * (1 / settings_.masses[b] + (b > 0 ? 1 / settings_.masses[b - 1] : 0.0));
    off_diagonal_[s] = -across / settings_.masses[b];
  }
  matrix_.factor({diagonal_, off_diagonal_});
}

void Scales::include(const Scales& other) {
  for (double Scales::*scale : {&Scales::energy, &Scales::momentum, &Scales::angular_momentum}) {
    this->*scale = largest(std::array{this->*scale, other.*scale});
  }
}

Scales scales_of(const RigidChain& chain, const mechanics::State& state) {
  Scales scales{.energy = chain.kinetic_energy(state.q, state.u) + std::abs(chain.potential_energy(state.q))};
  for (std::size_t k = 0; k < chain.masses().size(); ++k) {
    const double momentum = chain.masses()[k] * length(vector(state.u, k));
    scales.momentum += momentum;
    scales.angular_momentum += momentum * length(vector(state.q, k));
  }
  return scales;
}

std::vector<double> alternating_masses(std::size_t count) {
  std::vector<double> masses;
  for (std::size_t k = 0; k < count; ++k) masses.push_back(1 + 0.3 * static_cast<double>(k % 2));
  return masses;
}

mechanics::State spiral_start(RigidChain& chain) {
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

RigidChain double_pendulum() {
  return RigidChain({.masses = alternating_masses(2), .pinned = true, .gravity = 1});
}

RigidChain free_chain() {
  return RigidChain({.masses = alternating_masses(11)});
}

}  // namespace seiche::rigid_chain

namespace seiche::mechanics {

template class OneStep<rigid_chain::RigidChain>;
template class ConservativeStep<rigid_chain::RigidChain>;
template class SchemeStepper<rigid_chain::RigidChain>;
template class Start<rigid_chain::RigidChain>;
template class InvariantsWatch<rigid_chain::RigidChain>;

}  // namespace seiche::mechanics
