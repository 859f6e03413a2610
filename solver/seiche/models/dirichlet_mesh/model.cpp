#include "seiche/models/dirichlet_mesh/model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/polygon_triangulation.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/projection.hpp"
#include "seiche/require.hpp"

namespace seiche::dirichlet_mesh {

namespace {

// Of the mean diagonal, for the factor alone: without a free surface a constant pressure has no force either.
constexpr double shift = 1e-12;
constexpr double smallest_pivot = 1e-10;  // over the largest: below, A is singular

Triangulation triangulated(const Mesh& mesh) {
  mesh.require_valid();
  return triangulate_polygon(mesh.places(), mesh.outline);
}

/// The sum of (y_a^2 + y_a y_b + y_b^2)/6 over an edge, and twice its derivatives, come up everywhere.
double mean_square(double a, double b) {
  return (a * a + a * b + b * b) / 6;
}

}  // namespace

Model::Model(const Mesh& mesh, Settings settings)
    : settings_(settings),
      first_x_(mesh.x),
      first_y_(mesh.y),
      outline_(mesh.outline),
      triangulation_(triangulated(mesh), mesh.places()),
      area_(mesh.nodes()),
      force_(mesh.nodes()),
      solver_(mesh.nodes(), settings.solver, settings.tolerance) {
  require_not_negative("gravity", settings.gravity);
  require_positive("density", settings.density);
  require_not_negative("stabilisation", settings.stabilisation);
  if (solver_.method() == linear::RingMethod::iterative && settings.stabilisation == 0) {
    throw std::invalid_argument(
        "stabilisation = 0; allowed with the iterative solver: positive, for it cannot tell that a mesh is singular");
  }
  dirichlet_areas(triangulation_.mesh(), mesh.places(), area_);
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    if (!(area_[k] > 0)) {
      throw std::invalid_argument(
          fmt::format("the cell of node {} at ({:g}, {:g}) has an area of {:g}; allowed: positive", k, mesh.x[k],
                      mesh.y[k], area_[k]));
    }
    const double mass = settings.density * area_[k];
    mass_.push_back(mass);
    const auto [one, other] = mesh.held[k];
    if (one == Held::by_none && other == Held::by_none) {
      inertia_.push_back({1 / mass, 0, 1 / mass});
    } else if (one == Held::by_none || other == Held::by_none) {
      const Point along = mesh.walls[static_cast<std::size_t>(std::max(one, other))].direction;
      const double square = (along.x * along.x + along.y * along.y) * mass;
      inertia_.push_back({along.x * along.x / square, along.x * along.y / square, along.y * along.y / square});
    } else {
      inertia_.push_back({0, 0, 0});
    }
  }
}

mechanics::State Model::state(const VelocityAt& velocity, double time) const {
  const std::size_t n = nodes();
  mechanics::State state{.q = first_x_, .u = std::vector<double>(rates(), 0.0), .time = time};
  state.q.insert(state.q.end(), first_y_.begin(), first_y_.end());
  if (!velocity) return state;
  for (std::size_t k = 0; k < n; ++k) {
    const Point u = velocity({first_x_[k], first_y_[k]});
    // m W takes out what the walls forbid.
    const Point allowed = inertia_[k]({mass_[k] * u.x, mass_[k] * u.y});
    state.u[k] = allowed.x;
    state.u[n + k] = allowed.y;
  }
  return state;
}

void Model::follow(Input q) const {
  try {
    triangulation_.move_to(places(q));
  } catch (const MeshTangled& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
}

void Model::linearise(Interval /*when*/, Input q) {
  follow(q);
  if (connected_flips_ != triangulation_.flips()) {
    cells_.connect(triangulation_.mesh(), static_cast<int>(nodes()));
    matrix_.set_rings(cells_.begin(), cells_.members(), nodes());
    connected_flips_ = triangulation_.flips();
  }
  cells_.measure(triangulation_.mesh(), triangulation_.nodes());
  assemble_and_factor();
  gather_forces(triangulation_.nodes());
}

void Model::assemble_and_factor() {
  const auto begin = cells_.begin();
  const auto gradient = cells_.gradients();
  response_.resize(gradient.size());
  double trace = 0;
  for (std::size_t k = 0; k < nodes(); ++k) {
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      response_[e] = inertia_[k](gradient[e]);
      trace += gradient[e].x * response_[e].x + gradient[e].y * response_[e].y;
    }
  }
  const double mean = trace / static_cast<double>(nodes());
  stiffness_ = settings_.stabilisation * mean;
  matrix_.sum([&](std::size_t k, int p, int q) {
    const auto first = static_cast<std::size_t>(begin[k]);
    const Point& one = gradient[first + static_cast<std::size_t>(p)];
    const Point& other = response_[first + static_cast<std::size_t>(q)];
    const double neighbours = begin[k + 1] - begin[k] - 1;
    // Row k of L: 1 for the node itself, minus their mean for its neighbours.
    const double smooth = p == 0 ? 1 : q == 0 ? -1 / neighbours : 1 / (neighbours * neighbours);
    return one.x * other.x + one.y * other.y + stiffness_ * smooth;
  });
  const bool may_be_singular = settings_.stabilisation == 0;
  try {
    // With a shift a singular matrix would look regular: its smallest pivot grows with the number of nodes.
    solver_.factor(matrix_, may_be_singular ? 0 : shift * mean);
  } catch (const linear::NotPositiveDefinite&) {
    if (may_be_singular) throw_singular(0);
    throw;
  }
  if (may_be_singular && !(solver_.pivot_ratio() >= smallest_pivot)) throw_singular(solver_.pivot_ratio());
}

void Model::throw_singular(double pivots) const {
  throw mechanics::Infeasible(
      fmt::format(
          "singular configuration: pressures without forces, as on lattices symmetric about their nodes "
          "(smallest pivot over largest {:.2g}; allowed: at least {:g}); stabilisation = 0; set stabilisation > "
          "0, or stagger the rows",
          pivots, smallest_pivot),
      first_x_[0]);
}

void Model::gather_forces(Places at) {
  std::fill(force_.begin(), force_.end(), Point{});
  const double weight = settings_.density * settings_.gravity;
  if (weight == 0) return;
  for (std::size_t e = 0; e < outline_.size(); ++e) {
    const int a = outline_[e];
    const int b = outline_[e + 1 == outline_.size() ? 0 : e + 1];
    const Point ra = at[a];
    const Point rb = at[b];
    Point& fa = force_[static_cast<std::size_t>(a)];
    Point& fb = force_[static_cast<std::size_t>(b)];
    const double along = weight * mean_square(ra.y, rb.y);
    const double width = weight * (ra.x - rb.x) / 6;
    fa.x -= along;
    fb.x += along;
    fa.y -= width * (2 * ra.y + rb.y);
    fb.y -= width * (2 * rb.y + ra.y);
  }
}

void Model::advance(Input from, Input u, double h, Output to) const {
  next_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) next_[i] = from[i] + h * u[i];
  follow(next_);
  std::copy(next_.begin(), next_.end(), to.begin());
}

void Model::kick(double h, Output u) const {
  for (std::size_t k = 0; k < nodes(); ++k) {
    const Point acceleration = inertia_[k](force_[k]);
    u[k] += h * acceleration.x;
    u[nodes() + k] += h * acceleration.y;
  }
}

void Model::constraint_rates(Input u, Output w) const {
  std::fill(w.begin(), w.end(), 0.0);
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  const auto gradient = cells_.gradients();
  for (std::size_t k = 0; k < nodes(); ++k) {
    const double ux = u[k];
    const double uy = u[nodes() + k];
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      w[static_cast<std::size_t>(member[e])] += gradient[e].x * ux + gradient[e].y * uy;
    }
  }
}

void Model::react(Input mu, Output u) const {
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  for (std::size_t k = 0; k < nodes(); ++k) {
    Point change;
    for (auto e = static_cast<std::size_t>(begin[k]); e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      const double impulse = mu[static_cast<std::size_t>(member[e])];
      change.x += impulse * response_[e].x;
      change.y += impulse * response_[e].y;
    }
    u[k] += change.x;
    u[nodes() + k] += change.y;
  }
}

void Model::solve(Input right_hand_side, Output mu) {
  solver_.solve(right_hand_side, mu);
}

void Model::constraint_values(Input q, Output f) const {
  follow(q);
  dirichlet_areas(triangulation_.mesh(), triangulation_.nodes(), f);
  for (std::size_t k = 0; k < nodes(); ++k) f[k] -= area_[k];
}

double Model::mass() const {
  CompensatedSum sum;
  for (const double m : mass_) sum.add(m);
  return sum.value();
}

std::array<double, 2> Model::momentum(Input /*q*/, Input u) const {
  CompensatedSum x;
  CompensatedSum y;
  for (std::size_t k = 0; k < nodes(); ++k) {
    x.add(mass_[k] * u[k]);
    y.add(mass_[k] * u[nodes() + k]);
  }
  return {x.value(), y.value()};
}

std::array<double, 1> Model::angular_momentum(Input q, Input u) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < nodes(); ++k) {
    sum.add(mass_[k] * (q[k] * u[nodes() + k] - q[nodes() + k] * u[k]));
  }
  return {sum.value()};
}

double Model::kinetic_energy(Input /*q*/, Input u) const {
  CompensatedSum sum;
  for (std::size_t k = 0; k < nodes(); ++k) {
    sum.add(0.5 * mass_[k] * (u[k] * u[k] + u[nodes() + k] * u[nodes() + k]));
  }
  return sum.value();
}

double Model::potential_energy(Input q) const {
  const Places at = places(q);
  CompensatedSum sum;
  for (std::size_t e = 0; e < outline_.size(); ++e) {
    const Point a = at[outline_[e]];
    const Point b = at[outline_[e + 1 == outline_.size() ? 0 : e + 1]];
    sum.add((a.x - b.x) * mean_square(a.y, b.y));
  }
  return settings_.density * settings_.gravity * sum.value();
}

double Model::stabilisation_loss(Input impulses) const {
  const auto begin = cells_.begin();
  const auto member = cells_.members();
  CompensatedSum sum;
  for (std::size_t k = 0; k < nodes(); ++k) {
    const int neighbours = begin[k + 1] - begin[k] - 1;
    double mean = 0;
    for (auto e = static_cast<std::size_t>(begin[k]) + 1; e < static_cast<std::size_t>(begin[k + 1]); ++e) {
      mean += impulses[static_cast<std::size_t>(member[e])];
    }
    const double rough = impulses[k] - mean / neighbours;
    sum.add(rough * rough);
  }
  return 2 * stiffness_ * sum.value();
}

MeshQuality Model::quality(Input q) const {
  follow(q);
  return quality_of(triangulation_.mesh(), triangulation_.nodes());
}

std::vector<double> pressure_of_release(Model& model, const mechanics::State& rest) {
  mechanics::require_state(rest, model.coordinates(), model.rates());
  model.linearise({rest.time, 0}, rest.q);
  std::vector<double> acceleration(model.rates(), 0.0);
  std::vector<double> pressure(model.constraints(), 0.0);
  model.kick(1, acceleration);
  mechanics::Projection(model).project(acceleration, {}, pressure);
  return pressure;
}

}  // namespace seiche::dirichlet_mesh
