#include "seiche/models/gauss_particles/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

namespace {

/// Where the surface's markers are taken to be in the middle of a step: their last mean velocity and so much of its
/// last change. The force that meets the water then is, to third order in tau, even in time, and the energy does not
/// drift.
constexpr double surface_lead = 1.0 / 3;
constexpr int most_sweeps = 200;

}  // namespace

Model::Model(Particles particles, std::unique_ptr<FieldSpace> space, Settings settings, Forcing forcing)
    : particles_(std::move(particles)), space_(std::move(space)), settings_(settings), forcing_(std::move(forcing)) {
  require_particles(particles_);
  require_that(space_ != nullptr, "no space of velocity fields; allowed: a SplineSpace, a PolynomialSpace, ...");
  require_ranges(settings_);
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

void Model::enter(Input q, Output) {
  if (surface_ && settings_.surface->exact_energy) start_.assign(q.begin(), q.end());
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

void Model::push_and_project(Output u) {
  space_->project(u.first(size()), u.last(size()), Input(impulse_).first(size()), Input(impulse_).last(size()));
  // What flies freely has its own weight.
  const std::span<const std::uint8_t> free = space_->free();
  for (std::size_t k = 0; k < free.size(); ++k) {
    if (free[k] != 0) u[size() + k] -= when_.length / 2 * settings_.gravity;
  }
}

/// The force is the mean over the way of the markers, which it makes itself: a fixed point, which contracts like
/// (omega tau)^2/4.
void Model::project_under_surface(Output u) {
  impulse_.assign(rates(), 0.0);
  if (!settings_.surface->exact_energy) {
    surface_->push(places_, when_.length / 2, impulse_);
    push_and_project(u);
    return;
  }
  end_.resize(places_.size());
  for (std::size_t i = 0; i < end_.size(); ++i) end_[i] = 2 * places_[i] - start_[i];
  double last = std::numeric_limits<double>::infinity();
  for (int sweep = 0;; ++sweep) {
    std::fill(impulse_.begin(), impulse_.end(), 0.0);
    surface_->push_between(start_, end_, when_.length / 2, impulse_);
    std::copy(before_.begin(), before_.end(), u.begin());
    push_and_project(u);
    double change = 0;
    double largest = 0;
    for (const std::size_t k : surface_->markers()) {
      for (const std::size_t i : {k, size() + k}) {
        const double to = start_[i] + when_.length * u[i];
        const double moved = std::abs(to - end_[i]);
        if (!(moved <= change)) change = moved;
        if (!(std::abs(to) <= largest)) largest = std::abs(to);
        end_[i] = to;
      }
    }
    const double roundoff = std::numeric_limits<double>::epsilon() * largest;
    if (change <= roundoff || (change <= 100 * roundoff && change >= last)) return;
    if (sweep == most_sweeps) {
      throw mechanics::Infeasible(
          places_[surface_->markers().front()],
          "markers under gravity not found in {} iterations: they still move by {:.2g} m; take a shorter "
          "step",
          most_sweeps, change);
    }
    last = change;
  }
}

void Model::project(Output u, Input, Output) {
  before_.assign(u.begin(), u.end());
  if (surface_) {
    project_under_surface(u);
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
  return (places_.empty() ? particles_.x : places_)[rate % size()];
}

double Model::potential_energy(Input q) const {
  if (surface_) return surface_->energy(q) - first_potential_;
  CompensatedSum sum;
  for (std::size_t k = 0; k < size(); ++k) {
    sum.add(particles_.mass[k] * settings_.gravity * (q[size() + k] - particles_.y[k]));
  }
  return sum.value();
}

SurfaceGravity::SurfaceGravity(SurfaceLine line, const Particles& particles, double weight)
    : period_(line.period), weight_(weight) {
  require_not_negative("period of the surface", line.period);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (particles.mass[k] == 0) markers_.push_back(k);
  }
  require_that(markers_.size() >= 2, "{} markers for a surface; allowed: at least 2", markers_.size());
}

/// Calls visit(a, b, width, ya, yb) for the pieces of the line.
template <class Visit>
void SurfaceGravity::each_piece(std::span<const double> q, Visit&& visit) const {
  const std::span<const double> x = q.first(q.size() / 2);
  const std::span<const double> y = q.last(q.size() / 2);
  for (std::size_t k = 0; k + 1 < markers_.size(); ++k) {
    const std::size_t a = markers_[k];
    const std::size_t b = markers_[k + 1];
    visit(a, b, x[b] - x[a], y[a], y[b]);
  }
  if (period_ > 0) {
    const std::size_t a = markers_.back();
    const std::size_t b = markers_.front();
    visit(a, b, x[b] + period_ - x[a], y[a], y[b]);
  }
}

double SurfaceGravity::energy(std::span<const double> q) const {
  CompensatedSum sum;
  each_piece(q, [&](std::size_t, std::size_t, double width, double ya, double yb) {
    sum.add(weight_ * width * (ya * ya + ya * yb + yb * yb) / 6);
  });
  return sum.value();
}

void SurfaceGravity::push(std::span<const double> q, double h, std::span<double> impulse) const {
  const std::size_t n = q.size() / 2;
  const double factor = h * weight_ / 6;
  each_piece(q, [&](std::size_t a, std::size_t b, double width, double ya, double yb) {
    const double squares = ya * ya + ya * yb + yb * yb;
    impulse[a] += factor * squares;
    impulse[b] -= factor * squares;
    impulse[n + a] -= factor * width * (2 * ya + yb);
    impulse[n + b] -= factor * width * (ya + 2 * yb);
  });
}

/// Simpson's rule: dPi/dq is quadratic.
void SurfaceGravity::push_between(std::span<const double> q0, std::span<const double> q1, double h,
                                  std::span<double> impulse) {
  middle_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
  push(q0, h / 6, impulse);
  push(middle_, 4 * h / 6, impulse);
  push(q1, h / 6, impulse);
}

}  // namespace seiche::gauss_particles
