#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

double WallLoad::pressure_at(double elevation) const {
  if (!(elevation <= contact)) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t n = y.size();
  const auto between = [&](double y0, double p0, double y1, double p1) {
    return p0 + (p1 - p0) * (elevation - y0) / (y1 - y0);
  };
  if (elevation >= y[n - 1] || n == 1) return between(y[n - 1], pressure[n - 1], contact, 0);
  const auto above = std::upper_bound(y.begin() + 1, y.end() - 1, elevation);
  const auto k = static_cast<std::size_t>(above - y.begin());
  return between(y[k - 1], pressure[k - 1], y[k], pressure[k]);
}

Flow::Flow(Mesh mesh, const Velocity& velocity, Scheme scheme, Settings settings, Forcing forcing, bool smooth_start)
    : lattice::Flow<Model>(scheme) {
  auto model = std::make_unique<Model>(std::move(mesh), settings, std::move(forcing));
  const double stable = longest_stable_step(*model);
  const bool smooth = smooth_start && model->nodes().driven().empty();
  mechanics::State state = model->state(velocity);
  begin_at_first(std::move(model), std::move(state), stable, smooth);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  rezone_where_due();
  const double before = time();
  std::vector<double> y_before(y().begin(), y().end());
  step(tau);
  time_before_ = before;
  y_before_ = std::move(y_before);
}

WallLoad Flow::wall_load(WallSide side) const {
  const Mesh& mesh = model_->mesh();
  if (!knows_loads()) throw std::logic_error("the load of a wall is known after two steps");
  const double weight = model_->settings().density * model_->settings().gravity;
  const std::size_t column = side == WallSide::left ? 0 : mesh.columns - 1;
  const auto y = [&](std::size_t row) { return y_before_[mesh.node(side == WallSide::left ? 0 : mesh.columns, row)]; };
  WallLoad load{.time = time_before_, .contact = y(mesh.rows), .y = {}, .pressure = {}, .force = 0};
  for (std::size_t j = 0; j < mesh.rows; ++j) {
    const std::size_t cell = j * mesh.columns + column;
    const double dynamic = 0.5 * (state_.multipliers[cell] + state_.earlier_multipliers[cell]);
    const double middle = 0.5 * (y(j) + y(j + 1));
    load.y.push_back(middle);
    load.pressure.push_back(dynamic - weight * middle);
    // Hydrostatic pressure is linear in y: its integral over a cell is exact.
    load.force += (dynamic - weight * middle) * (y(j + 1) - y(j));
  }
  return load;
}

std::vector<double> Flow::elevation_at(std::span<const double> places) const {
  const auto xs = surface_x();
  const auto ys = surface_y();
  std::vector<double> elevation;
  for (const double place : places) {
    const auto k = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), place) - xs.begin());
    if (k > 0 && k < xs.size()) {
      elevation.push_back(ys[k - 1] + (ys[k] - ys[k - 1]) * (place - xs[k - 1]) / (xs[k] - xs[k - 1]));
    } else if (place == xs.back()) {
      elevation.push_back(ys.back());
    } else {
      elevation.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return elevation;
}

void Flow::keep_upright(double drift) {
  require_within("drift", drift, 1e-6, 2);
  require_that(!model_->forcing().body_force, "a rezoned mesh with a body force; allowed: none");
  upright_ = std::make_unique<const UprightColumns>(model_->mesh());
  drift_ = drift;
}

void Flow::rezone_where_due() {
  if (!upright_) return;
  const UprightColumns::Places places = upright_->places(state_.q);
  if (!(upright_->drift(state_.q, places) > drift_)) return;
  try {
    rezone(places);
    ++rezoning_.done;
  } catch (const mechanics::Infeasible&) {
    ++rezoning_.refused;
  }
}

void Flow::rezone(const UprightColumns::Places& places) {
  Remapped now = remap(*model_, state_.q, state_.u, places.x, places.y);
  const double before = energy();
  auto model = std::make_unique<Model>(std::move(now.mesh), model_->settings(), model_->forcing());
  const double stable = longest_stable_step(*model);
  mechanics::State state = model->state(now.velocity, state_.time);
  state.steps = state_.steps;
  begin(std::move(model), std::move(state), stable);
  rezoning_.lost += before - energy();
}

std::vector<Point> impulsive_start(const Mesh& mesh, const std::function<double(double x)>& potential) {
  // Without gravity the surface pressure is the only force, and a kick of length one its impulse.
  // Once, so directly: what it leaves of the rates of areas is round-off.
  Model model(mesh, {.gravity = 0, .solver = linear::SolverMethod::banded, .tolerance = 1e-13},
              {.surface_pressure = [&](double x, double) { return -potential(x); }});
  mechanics::State state = model.state();
  model.linearise({.begin = 0, .length = 0}, state.q);
  model.kick(1, state.u);
  mechanics::Start(model).project(state);
  std::vector<Point> velocities(mesh.nodes());
  for (std::size_t k = 0; k < mesh.nodes(); ++k) velocities[k] = {state.u[k], state.u[mesh.nodes() + k]};
  return velocities;
}

}  // namespace seiche::lagrangian_mesh_2d

template class seiche::lattice::Flow<seiche::lagrangian_mesh_2d::Model>;
