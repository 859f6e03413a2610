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
      first_(mesh),
      triangulation_(triangulated(mesh), mesh.places()),
      freedom_(freedoms(mesh)),
      force_(mesh.nodes()) {
  require_ranges(settings);
  std::vector<double> masses(mesh.nodes());
  dirichlet_areas(triangulation_.mesh(), mesh.places(), masses);
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    require_that(masses[k] > 0, "the cell of node {} at ({:g}, {:g}) has an area of {:g}; allowed: positive", k,
                 mesh.x[k], mesh.y[k], masses[k]);
    masses[k] *= settings.density;
  }
  set_masses(masses);
}

void CellWater::set_masses(std::span<const double> masses) {
  mass_.assign(masses.begin(), masses.end());
  mobility_.resize(mass_.size());
  for (std::size_t k = 0; k < mass_.size(); ++k) mobility_[k] = freedom_[k].over(mass_[k]);
}

void CellWater::linearise(Interval /*when*/, Input q) {
  measure(places(q));
  factor(mobility_);
  gravity_forces(places(q), outline(), weight(), force_);
}

void CellWater::advance(Input from, Input u, double h, Output to) const {
  next_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) next_[i] = from[i] + h * u[i];
  follow(places(next_));
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
  follow(places(q));
  dirichlet_areas(triangulation_.mesh(), triangulation_.nodes(), f);
  for (std::size_t k = 0; k < nodes(); ++k) f[k] -= mass_[k] / settings_.density;
}

std::vector<Mobility> freedoms(const Mesh& mesh) {
  std::vector<Mobility> free;
  for (const auto& [one, other] : mesh.held) {
    if (one == Held::by_none && other == Held::by_none) {
      free.push_back({1, 0, 1});
    } else if (one == Held::by_none || other == Held::by_none) {
      const Point along = mesh.walls[static_cast<std::size_t>(std::max(one, other))].direction;
      const double square = dot(along, along);
      free.push_back({along.x * along.x / square, along.x * along.y / square, along.y * along.y / square});
    } else {
      free.push_back({0, 0, 0});
    }
  }
  return free;
}

void CellWater::measure(Places at) {
  follow(at);
  if (connected_flips_ != triangulation_.flips()) {
    cells_.connect(triangulation_.mesh(), at.size());
    areas_.set_rings(cells_.begin(), cells_.members());
    row_.clear();
    for (std::size_t k = 0; k < nodes(); ++k) {
      const int neighbours = cells_.begin()[k + 1] - cells_.begin()[k] - 1;
      row_.push_back(1);
      row_.insert(row_.end(), static_cast<std::size_t>(neighbours), -1.0 / neighbours);
    }
    connected_flips_ = triangulation_.flips();
  }
  cells_.measure(triangulation_.mesh(), triangulation_.nodes());
}

void CellWater::factor(std::span<const Mobility> mobility) {
  const auto pivots = areas_.factor(cells_.gradients(), row_, settings_.stabilisation,
                                    [&](std::size_t k, Point force) { return mobility[k](force); });
  if (!pivots) return;
  throw mechanics::Infeasible(
      triangulation_.nodes()[0].x,
      "singular configuration: pressures without forces, as on lattices symmetric about their nodes "
      "(smallest pivot over largest {:.2g}; allowed: at least {:g}); stabilisation = 0; set stabilisation > "
      "0, or stagger the rows",
      *pivots, linear::RingSolver::smallest_pivot);
}

}  // namespace seiche::free_lagrangian
