#include "seiche/free_lagrangian/cell_pressure.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::free_lagrangian {

namespace {

// Of the mean diagonal, for the factor alone: without a free surface a constant pressure has no force either.
constexpr double shift = 1e-12;
constexpr double smallest_pivot = 1e-10;  // over the largest: below, A is singular

Triangulation triangulated(const Mesh& mesh) {
  mesh.require_valid();
  return triangulate_polygon(mesh.places(), mesh.outline);
}

}  // namespace

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
    : stabilisation_(stabilisation), triangulation_(triangulated(mesh), mesh.places()) {
  require_not_negative("stabilisation", stabilisation);
}

void CellPressure::follow(Places at) {
  try {
    triangulation_.move_to(at);
  } catch (const MeshTangled& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
}

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
  const bool may_be_singular = stabilisation_ == 0;
  try {
    // With a shift a singular matrix would look regular: its smallest pivot grows with the number of nodes.
    solver_.factor(matrix_, may_be_singular ? 0 : shift * mean);
  } catch (const linear::NotPositiveDefinite&) {
    if (may_be_singular) throw_singular(0);
    throw;
  }
  if (may_be_singular && !(solver_.pivot_ratio() >= smallest_pivot)) throw_singular(solver_.pivot_ratio());
}

void CellPressure::throw_singular(double pivots) const {
  throw mechanics::Infeasible(
      fmt::format(
          "singular configuration: pressures without forces, as on lattices symmetric about their nodes "
          "(smallest pivot over largest {:.2g}; allowed: at least {:g}); stabilisation = 0; set stabilisation > "
          "0, or stagger the rows",
          pivots, smallest_pivot),
      triangulation_.nodes()[0].x);
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
