#include "seiche/models/variable_mass/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::variable_mass {

Flow::Flow(ControlVelocity control, const Start& start, Settings settings, double drift_feedback)
    : PlaneFlow(std::make_unique<CellWater>(control.raised(start.elevation), settings), start.velocity),
      control_(std::move(control)),
      force_(model_->nodes()) {
  require_within("drift_feedback", drift_feedback, 0, 1);
  parts_ = std::make_unique<mechanics::StepParts<CellWater>>(*model_, drift_feedback > 0, drift_feedback);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  require_within("rate * tau", control_.control().rate * tau, 0, 1);
  require_within("surface_rate * tau", control_.control().surface_rate * tau, 0, 1);
  parts_->guarded(state_, [&] { take(tau); });
  ++state_.steps;
}

void Flow::take(double tau) {
  const std::size_t n = model_->nodes();
  const std::size_t both = 2 * n;
  const mechanics::Input target = parts_->drift_target(state_.q, tau);
  velocity_.resize(both);
  rates_.resize(both);
  middle_.resize(both);

  // Step 1: the middle of the step, and the control there.
  model_->follow(model_->places(state_.q));
  control_.at(model_->triangulation(), state_.u, velocity_);
  for (std::size_t i = 0; i < both; ++i) middle_[i] = state_.q[i] + tau / 2 * (state_.u[i] + velocity_[i]);
  model_->measure(model_->places(middle_));
  control_.at(model_->triangulation(), state_.u, velocity_);

  // Step 2: masses.
  gather_exchanges(model_->places(middle_), tau);
  convection_.begin(model_->masses(), exchanges_, model_->places(middle_));
  mobility_.resize(n);
  for (std::size_t k = 0; k < n; ++k) mobility_[k] = model_->freedom()[k].over(convection_.mean_masses()[k]);

  // Step 3: mean velocities, those of constant areas.
  model_->factor(mobility_);
  free_lagrangian::gravity_forces(model_->places(middle_), model_->outline(), model_->weight(), force_);
  parts_->guess_impulse(state_, tau, impulse_);
  for (double& value : impulse_) value *= 2;
  defect_.resize(n);
  Worst kicks;
  for (std::size_t k = 0; k < n; ++k) {
    const Point kick = mobility_[k](force_[k]);
    kicks.add(tau * kick.x);
    kicks.add(tau * kick.y);
  }
  const auto respond = [&](std::span<double> u) {
    for (std::size_t k = 0; k < n; ++k) {
      const Point answer = mobility_[k]({u[k] + tau * force_[k].x, u[n + k] + tau * force_[k].y});
      u[k] = answer.x;
      u[n + k] = answer.y;
    }
    model_->constraint_rates(u, defect_);
    for (std::size_t s = 0; s < n; ++s) defect_[s] = (target.empty() ? 0.0 : target[s]) - defect_[s];
    model_->solve(defect_, impulse_);
    model_->react(impulse_, u);
  };
  mean_.assign(state_.u.begin(), state_.u.end());
  const int iterations = convection_.settle(state_.u, respond, std::abs(kicks.value()), mean_);

  // Step 4: the end of the step.
  convection_.finish(state_.u, mean_, next_u_);
  parts_->require_finite_rates(state_, next_u_);
  for (std::size_t i = 0; i < both; ++i) rates_[i] = mean_[i] + velocity_[i];
  next_.resize(both);
  model_->advance(state_.q, rates_, tau, next_);

  state_.q.swap(next_);
  state_.u.swap(next_u_);
  model_->set_masses(convection_.next_masses());
  CompensatedSum work;
  for (std::size_t s = 0; s < target.size(); ++s) work.add(impulse_[s] * target[s]);
  book(model_->stabilisation_loss(impulse_) / 2, work.value());
  for (double& value : impulse_) value /= 2;
  parts_->keep_multipliers(state_, impulse_, tau);
  iterations_ += iterations;
  state_.time += tau;
}

void Flow::gather_exchanges(Places at, double tau) {
  exchanges_.clear();
  const DirichletCells& cells = model_->cells();
  const auto begin = cells.begin();
  const auto member = cells.members();
  const auto gradient = cells.gradients();
  const std::size_t n = model_->nodes();
  const double mass = tau * model_->settings().density;
  const auto c = [&](int k) { return Point{velocity_[index(k)], velocity_[n + index(k)]}; };
  // Area that i gains from j where the face between them moves: dA_i/dr_j.c_j - dA_j/dr_i.c_i.
  for (int j = 0; j < static_cast<int>(n); ++j) {
    for (int e = begin[index(j)] + 1; e < begin[index(j) + 1]; ++e) {
      const int i = member[index(e)];
      if (i < j) continue;
      const auto ring = member.subspan(index(begin[index(i)]), index(begin[index(i) + 1] - begin[index(i)]));
      const auto back =
          index(begin[index(i)]) + static_cast<std::size_t>(std::find(ring.begin(), ring.end(), j) - ring.begin());
      const double gain = dot(gradient[index(e)], c(j)) - dot(gradient[back], c(i));
      if (gain != 0) exchanges_.push_back({i, j, mass * gain});
    }
  }
  // Along the outline the derivatives hold, besides the face, an eighth of the edge's motion: not of that exchange.
  const auto outline = model_->outline();
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const int i = outline[e];
    const int j = outline[e + 1 == outline.size() ? 0 : e + 1];
    const Point normal{(at[j].y - at[i].y) / 8, (at[i].x - at[j].x) / 8};
    const double gain = dot(normal, c(j) - c(i));
    if (gain != 0) exchanges_.push_back({i, j, -mass * gain});
  }
  const auto surface = control_.surface().nodes();
  const std::vector<double> handed_on =
      control_.surface().handed_on(at, {velocity_.data(), n}, {velocity_.data() + n, n});
  for (std::size_t s = 0; s < handed_on.size(); ++s) {
    if (handed_on[s] != 0) exchanges_.push_back({surface[s], surface[s + 1], mass * handed_on[s]});
  }
}

namespace {

constexpr double settled = 1e-15;   // change of an iteration over the largest velocity
constexpr double rounding = 1e-11;  // below it a change that no longer falls is rounding

}  // namespace

void Convection::begin(std::span<const double> masses, std::span<const Exchange> exchanges, Places at) {
  exchanges_.assign(exchanges.begin(), exchanges.end());
  next_.assign(masses.begin(), masses.end());
  for (const auto& [to, from, mass] : exchanges_) {
    next_[static_cast<std::size_t>(to)] += mass;
    next_[static_cast<std::size_t>(from)] -= mass;
  }
  const std::size_t n = masses.size();
  root_.resize(n);
  next_root_.resize(n);
  mean_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(next_[k] > 0)) {
      const Point r = at[static_cast<int>(k)];
      throw mechanics::Infeasible(r.x, "the mass of node {} at ({:g}, {:g}) becomes {:g}; allowed: positive", k, r.x,
                                  r.y, next_[k]);
    }
    root_[k] = std::sqrt(masses[k]);
    next_root_[k] = std::sqrt(next_[k]);
    const double sum = root_[k] + next_root_[k];
    mean_[k] = sum * sum / 2;
  }
}

void Convection::momenta(std::span<const double> u, std::span<const double> mean, std::vector<double>& out) const {
  const std::size_t n = root_.size();
  out.resize(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const double factor = root_[k] * (root_[k] + next_root_[k]);
    out[k] = factor * u[k];
    out[n + k] = factor * u[n + k];
  }
  for (const auto& [to, from, mass] : exchanges_) {
    const auto i = static_cast<std::size_t>(to);
    const auto j = static_cast<std::size_t>(from);
    out[i] += mass / 2 * mean[j];
    out[j] -= mass / 2 * mean[i];
    out[n + i] += mass / 2 * mean[n + j];
    out[n + j] -= mass / 2 * mean[n + i];
  }
}

int Convection::settle(std::span<const double> u, const Respond& respond, double kicks, std::vector<double>& mean) {
  double last = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= most_iterations; ++k) {
    momenta(u, mean, iterate_);
    respond(iterate_);
    Worst change;
    Worst size;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      change.add(iterate_[i] - mean[i]);
      size.add(iterate_[i]);
    }
    mean.swap(iterate_);
    const double now = std::abs(change.value());
    const double scale = std::abs(size.value()) + kicks;
    if (now <= settled * scale || (now >= last && now <= rounding * scale)) return k;
    last = now;
  }
  throw mechanics::Infeasible(
      0, "the convective term does not settle in {} iterations: the control is too strong for the step",
      most_iterations);
}

void Convection::finish(std::span<const double> u, std::span<const double> mean, std::vector<double>& next) const {
  const std::size_t n = root_.size();
  next.resize(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const std::size_t k = i % n;
    next[i] = ((root_[k] + next_root_[k]) * mean[i] - root_[k] * u[i]) / next_root_[k];
  }
}

}  // namespace seiche::variable_mass
