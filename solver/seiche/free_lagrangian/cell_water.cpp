#include "seiche/free_lagrangian/cell_water.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/step_parts.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::free_lagrangian {

namespace {

double mean_square(double a, double b) {
  return (a * a + a * b + b * b) / 6;
}

Triangulation triangulated(const Mesh& mesh) {
  mesh.require_valid();
  return triangulate_polygon(mesh.places(), mesh.outline);
}

}  // namespace

double potential_energy(Places at, std::span<const int> outline, double weight) {
  CompensatedSum sum;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point a = at[outline[e]];
    const Point b = at[outline[e + 1 == outline.size() ? 0 : e + 1]];
    sum.add((a.x - b.x) * mean_square(a.y, b.y));
  }
  return weight * sum.value();
}

void gravity_forces(Places at, std::span<const int> outline, double weight, std::vector<Point>& force) {
  std::fill(force.begin(), force.end(), Point{});
  if (weight == 0) return;
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const int a = outline[e];
    const int b = outline[e + 1 == outline.size() ? 0 : e + 1];
    const Point ra = at[a];
    const Point rb = at[b];
    Point& fa = force[static_cast<std::size_t>(a)];
    Point& fb = force[static_cast<std::size_t>(b)];
    const double along = weight * mean_square(ra.y, rb.y);
    const double width = weight * (ra.x - rb.x) / 6;
    fa.x -= along;
    fb.x += along;
    fa.y -= width * (2 * ra.y + rb.y);
    fb.y -= width * (2 * rb.y + ra.y);
  }
}

CellWater::CellWater(const Mesh& mesh, Settings settings)
    : settings_(settings),
      first_x_(mesh.x),
      first_y_(mesh.y),
      outline_(mesh.outline),
      pressure_(mesh, settings.stabilisation),
      freedom_(freedoms(mesh)),
      force_(mesh.nodes()) {
  require_ranges(settings);
  std::vector<double> masses = first_areas(mesh, pressure_.triangulation().mesh());
  for (double& mass : masses) mass *= settings.density;
  set_masses(masses);
}

void CellWater::set_masses(std::span<const double> masses) {
  mass_.assign(masses.begin(), masses.end());
  mobility_.resize(mass_.size());
  for (std::size_t k = 0; k < mass_.size(); ++k) mobility_[k] = freedom_[k].over(mass_[k]);
}

mechanics::State CellWater::state(const VelocityAt& velocity, double time) const {
  const std::size_t n = nodes();
  mechanics::State state{.q = first_x_, .u = std::vector<double>(rates(), 0.0), .time = time};
  state.q.insert(state.q.end(), first_y_.begin(), first_y_.end());
  if (!velocity) return state;
  for (std::size_t k = 0; k < n; ++k) {
    const Point allowed = freedom_[k](velocity({first_x_[k], first_y_[k]}));
    state.u[k] = allowed.x;
    state.u[n + k] = allowed.y;
  }
  return state;
}

void CellWater::linearise(Interval /*when*/, Input q) {
  pressure_.measure(places(q));
  pressure_.factor(mobility_);
  gravity_forces(places(q), outline_, weight(), force_);
}

void CellWater::advance(Input from, Input u, double h, Output to) const {
  next_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) next_[i] = from[i] + h * u[i];
  pressure_.follow(places(next_));
  std::copy(next_.begin(), next_.end(), to.begin());
}

void CellWater::kick(double h, Output u) const {
  for (std::size_t k = 0; k < nodes(); ++k) {
    const Point acceleration = mobility_[k](force_[k]);
    u[k] += h * acceleration.x;
    u[nodes() + k] += h * acceleration.y;
  }
}

void CellWater::constraint_values(Input q, Output f) const {
  pressure_.areas(places(q), f);
  for (std::size_t k = 0; k < nodes(); ++k) f[k] -= mass_[k] / settings_.density;
}

std::vector<double> pressure_of_release(CellWater& water, const mechanics::State& rest) {
  mechanics::require_state(rest, water.coordinates(), water.rates());
  water.linearise({rest.time, 0}, rest.q);
  std::vector<double> acceleration(water.rates(), 0.0);
  std::vector<double> pressure(water.constraints(), 0.0);
  water.kick(1, acceleration);
  mechanics::Projection(water).project(acceleration, {}, pressure);
  return pressure;
}

std::vector<Mobility> freedoms(const Mesh& mesh) {
  std::vector<Mobility> free;
  for (const auto& [one, other] : mesh.held) {
    if (one == Held::by_none && other == Held::by_none) {
      free.push_back({1, 0, 1});
    } else if (one == Held::by_none || other == Held::by_none) {
      const Point along = mesh.walls[static_cast<std::size_t>(std::max(one, other))].direction;
      const double square = along.x * along.x + along.y * along.y;
      free.push_back({along.x * along.x / square, along.x * along.y / square, along.y * along.y / square});
    } else {
      free.push_back({0, 0, 0});
    }
  }
  return free;
}

std::vector<double> first_areas(const Mesh& mesh, const Triangulation& triangulation) {
  std::vector<double> areas(mesh.nodes());
  dirichlet_areas(triangulation, mesh.places(), areas);
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    require_that(areas[k] > 0, "the cell of node {} at ({:g}, {:g}) has an area of {:g}; allowed: positive", k,
                 mesh.x[k], mesh.y[k], areas[k]);
  }
  return areas;
}

CellPressure::CellPressure(const Mesh& mesh, double stabilisation)
    : stabilisation_(stabilisation), triangulation_(triangulated(mesh), mesh.places()) {}

MeshQuality CellPressure::quality(Places at) {
  follow(at);
  return quality_of(triangulation_.mesh(), triangulation_.nodes());
}

void CellPressure::areas(Places at, std::span<double> areas) {
  follow(at);
  dirichlet_areas(triangulation_.mesh(), triangulation_.nodes(), areas);
}

void CellPressure::measure(Places at) {
  follow(at);
  if (connected_flips_ != triangulation_.flips()) {
    cells_.connect(triangulation_.mesh(), at.size());
    matrix_.set_rings(cells_.begin(), cells_.members(), nodes());
    connected_flips_ = triangulation_.flips();
  }
  cells_.measure(triangulation_.mesh(), triangulation_.nodes());
}

void CellPressure::factor(std::span<const Mobility> mobility) {
  const auto begin = cells_.begin();
  const auto gradient = cells_.gradients();
  response_.resize(gradient.size());
  double trace = 0;
  for (std::size_t k = 0; k < nodes(); ++k) {
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      response_[e] = mobility[k](gradient[e]);
      trace += dot(gradient[e], response_[e]);
    }
  }
  const double mean = trace / static_cast<double>(nodes());
  stiffness_ = stabilisation_ * mean;
  matrix_.sum([&](std::size_t k, int p, int q) {
    const auto first = static_cast<std::size_t>(begin[k]);
    const Point& one = gradient[first + static_cast<std::size_t>(p)];
    const Point& other = response_[first + static_cast<std::size_t>(q)];
    const double neighbours = begin[k + 1] - begin[k] - 1;
    // Row k of L: 1 for the node itself, minus their mean for its neighbours.
    const double smooth = p == 0 ? 1 : q == 0 ? -1 / neighbours : 1 / (neighbours * neighbours);
    return dot(one, other) + stiffness_ * smooth;
  });
  const auto pivots = solver_.factor_or_singular(matrix_, mean, stabilisation_ != 0);
  if (!pivots) return;
  throw mechanics::Infeasible(
      triangulation_.nodes()[0].x,
      "singular configuration: pressures without forces, as on lattices symmetric about their nodes "
      "(smallest pivot over largest {:.2g}; allowed: at least {:g}); stabilisation = 0; set stabilisation > "
      "0, or stagger the rows",
      *pivots, linear::RingSolver::smallest_pivot);
}

void CellPressure::rates(std::span<const double> u, std::span<double> w) const {
  std::fill(w.begin(), w.end(), 0.0);
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  const auto gradient = cells_.gradients();
  for (std::size_t k = 0; k < nodes(); ++k) {
    const Point velocity{u[k], u[nodes() + k]};
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      w[static_cast<std::size_t>(member[e])] += dot(gradient[e], velocity);
    }
  }
}

void CellPressure::react(std::span<const double> mu, std::span<double> u) const {
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  for (std::size_t k = 0; k < nodes(); ++k) {
    Point change;
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      change += mu[static_cast<std::size_t>(member[e])] * response_[e];
    }
    u[k] += change.x;
    u[nodes() + k] += change.y;
  }
}

double CellPressure::roughness(std::span<const double> mu) const {
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  CompensatedSum sum;
  for (std::size_t k = 0; k < nodes(); ++k) {
    const int neighbours = begin[k + 1] - begin[k] - 1;
    double mean = 0;
    for (auto e = static_cast<std::size_t>(begin[k]) + 1; e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      mean += mu[static_cast<std::size_t>(member[e])];
    }
    const double rough = mu[k] - mean / neighbours;
    sum.add(rough * rough);
  }
  return stiffness_ * sum.value();
}

}  // namespace seiche::free_lagrangian
