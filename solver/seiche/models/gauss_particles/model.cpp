#include "seiche/models/gauss_particles/model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

/// Where the surface's markers are taken to be in the middle of a step: their last mean velocity and so much of its
/// last change. The force that meets the water then is, to third order in tau, even in time, and the energy does not
/// drift.
constexpr double surface_lead = 1.0 / 3;

}  // namespace

Model::Model(Particles particles, std::unique_ptr<FieldSpace> space, Settings settings, Forcing forcing)
    : particles_(std::move(particles)), space_(std::move(space)), settings_(settings), forcing_(std::move(forcing)) {
  require_particles(particles_);
  if (!space_)
    throw std::invalid_argument("no space of velocity fields; allowed: a SplineSpace, a PolynomialSpace, ...");
  require_not_negative("gravity", settings_.gravity);
  require_positive("density", settings_.density);
  require_not_negative("penalty", settings_.penalty);
  CompensatedSum total;
  for (const double m : particles_.mass) total.add(m);
  total_mass_ = total.value();
  if (settings_.surface) surface_.emplace(*settings_.surface, particles_, settings_.density * settings_.gravity);
  const mechanics::State first = state();
  if (surface_) {
    first_potential_ = surface_->energy(first.q);
    marker_lead_ = surface_lead;
  }
  try {
    linearise({0, 0}, first.q);
  } catch (const mechanics::Infeasible& failure) {
    throw std::invalid_argument(failure.what());
  }
}

mechanics::State Model::state(const std::function<Point(Point place)>& velocity, double time) const {
  mechanics::State state;
  state.q = particles_.x;
  state.q.insert(state.q.end(), particles_.y.begin(), particles_.y.end());
  state.u.assign(rates(), 0.0);
  state.time = time;
  if (velocity) {
    for (std::size_t k = 0; k < size(); ++k) {
      const Point v = velocity({particles_.x[k], particles_.y[k]});
      state.u[k] = v.x;
      state.u[size() + k] = v.y;
    }
  }
  return state;
}

void Model::linearise(Interval when, Input q) {
  when_ = when;
  places_.assign(q.begin(), q.end());
  const Input x = q.first(size());
  const Input y = q.last(size());
  space_->place(when, x, y, particles_.mass,
                settings_.penalty * std::sqrt(settings_.gravity) * std::max(when.length, 0.0) / 2);
  force_.clear();
  if (!forcing_.surface_pressure_slope && !forcing_.body_force) return;
  force_.assign(rates(), 0.0);
  for (std::size_t k = 0; k < size(); ++k) {
    if (forcing_.surface_pressure_slope) {
      force_[k] -= forcing_.surface_pressure_slope(x[k], when.middle()) / settings_.density;
    }
    if (forcing_.body_force) {
      const Point force = forcing_.body_force({x[k], y[k]}, when.middle());
      force_[k] += force.x;
      force_[size() + k] += force.y;
    }
  }
}

void Model::kick(double h, Output u) const {
  if (!surface_) {
    for (std::size_t k = size(); k < 2 * size(); ++k) u[k] -= h * settings_.gravity;
  }
  for (std::size_t k = 0; k < force_.size(); ++k) u[k] += h * force_[k];
}

void Model::advance(Input from, Input u, double h, Output to) const {
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = from[k] + h * u[k];
}

void Model::project(Output u, Input, Output) {
  before_.assign(u.begin(), u.end());
  if (surface_) {
    impulse_.assign(rates(), 0.0);
    surface_->push(places_, when_.length / 2, impulse_);
    space_->project(u.first(size()), u.last(size()), Input(impulse_).first(size()), Input(impulse_).last(size()));
    // What flies freely has its own weight.
    const std::span<const std::uint8_t> free = space_->free();
    for (std::size_t k = 0; k < free.size(); ++k) {
      if (free[k] != 0) u[size() + k] -= when_.length / 2 * settings_.gravity;
    }
  } else {
    space_->project(u.first(size()), u.last(size()));
  }
  projected_.assign(u.begin(), u.end());
  step_work_ = 0;
  if (force_.empty()) return;
  CompensatedSum power;
  for (std::size_t k = 0; k < size(); ++k) {
    power.add(particles_.mass[k] * (force_[k] * u[k] + force_[size() + k] * u[size() + k]));
  }
  step_work_ = power.value();
}

void Model::settle(Interval when, Output, Output u) {
  work_.add(when.length * step_work_);
  loss_.add(2 * space_->facts().penalty);
  const std::span<const std::uint8_t> free = space_->free();
  for (std::size_t k = 0; k < size(); ++k) {
    if (particles_.mass[k] > 0 || (!free.empty() && free[k] != 0)) continue;
    for (const std::size_t i : {k, size() + k}) {
      u[i] = projected_[i] + (previous_.empty() ? 0 : marker_lead_ * (projected_[i] - previous_[i]));
    }
  }
  previous_ = projected_;
}

double Model::place(std::size_t rate) const {
  const std::size_t particle = rate % size();
  return places_.empty() ? particles_.x[particle] : places_[particle];
}

std::array<double, 2> Model::momentum(Input, Input u) const {
  CompensatedSum along;
  CompensatedSum up;
  for (std::size_t k = 0; k < size(); ++k) {
    along.add(particles_.mass[k] * u[k]);
    up.add(particles_.mass[k] * u[size() + k]);
  }
  return {along.value(), up.value()};
}

std::array<double, 1> Model::angular_momentum(Input q, Input u) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) {
    sum.add(particles_.mass[k] * q[k] * u[size() + k]);
    sum.add(-particles_.mass[k] * q[size() + k] * u[k]);
  }
  return {sum.value()};
}

double Model::kinetic_energy(Input, Input u) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) {
    sum.add(0.5 * particles_.mass[k] * (u[k] * u[k] + u[size() + k] * u[size() + k]));
  }
  return sum.value();
}

double Model::potential_energy(Input q) const {
  if (surface_) return surface_->energy(q) - first_potential_;
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) {
    sum.add(particles_.mass[k] * settings_.gravity * (q[size() + k] - particles_.y[k]));
  }
  return sum.value();
}

}  // namespace seiche::gauss_particles
