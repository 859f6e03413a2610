/// Pressures that keep the areas of Dirichlet cells: rates of the areas, reactions, and A = G W G^T with its
/// stabilisation.
///
/// G = dA_i/dr_k and W the mobilities of the nodes. With a stabilisation epsilon
///
/// @f[ \left(A + \epsilon \frac{\mathrm{tr} A}{N} L^T L\right) \mu = \dots, \qquad
///     L \mu = \mu_i - \text{mean of its neighbours} @f]
///
/// is solved instead of A: on lattices symmetric about their nodes there are pressures without forces, and A is
/// singular. The neighbours are those of the moment: the triangulation goes along with whatever places are asked about,
/// by flips.
#pragma once

#include <span>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::free_lagrangian {

// How a node answers a force: by 1/mass, along its wall alone, or not at all in a corner.

struct Mobility {
  double xx = 0;
  double xy = 0;
  double yy = 0;

  [[nodiscard]] Point operator()(Point force) const {
    return {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
  }
  [[nodiscard]] Mobility over(double mass) const { return {xx / mass, xy / mass, yy / mass}; }
};

/// Projections on what the walls of a mesh leave free, one per node: mobilities for unit masses.
std::vector<Mobility> freedoms(const Mesh& mesh);

class CellPressure {
 public:
  /// Throws std::invalid_argument (mesh.hpp, triangulation.hpp): a cell without area, a negative stabilisation.
  CellPressure(const Mesh& mesh, double stabilisation);

  /// Where the triangulation was last asked to be.
  [[nodiscard]] const MovingTriangulation& triangulation() const { return triangulation_; }
  /// Throws mechanics::Infeasible where the mesh tangles.
  void follow(Places at);
  [[nodiscard]] MeshQuality quality(Places at);
  /// Areas there, and nothing else.
  void areas(Places at, std::span<double> areas);

  /// Cells and gradients at these places. Throws mechanics::Infeasible where the mesh tangles.
  void measure(Places at);
  /// Of the last measure.
  [[nodiscard]] const DirichletCells& cells() const { return cells_; }

  /// A for these mobilities at the cells last measured. Throws mechanics::Infeasible where it is singular without
  /// stabilisation.
  void factor(std::span<const Mobility> mobility);
  /// w = G u, with u all velocities along x, then all along y.
  void rates(std::span<const double> u, std::span<double> w) const;
  /// u += W G^T mu.
  void react(std::span<const double> mu, std::span<double> u) const;
  void solve(std::span<const double> right_hand_side, std::span<double> mu) { solver_.solve(right_hand_side, mu); }
  /// mu.(epsilon tr A/N) L^T L mu, never negative: what the stabilisation keeps G u from.
  [[nodiscard]] double roughness(std::span<const double> mu) const;

  [[nodiscard]] const linear::RingSolver& solver() const { return solver_; }
  /// A with its stabilisation, of the last factor.
  [[nodiscard]] const linear::RingMatrix& matrix() const { return matrix_; }

 private:
  [[noreturn]] void throw_singular(double pivots) const;
  [[nodiscard]] std::size_t nodes() const { return triangulation_.nodes().x.size(); }

  double stabilisation_;
  MovingTriangulation triangulation_;
  long connected_flips_ = -1;  // of the triangulation, when the cells were connected
  DirichletCells cells_;
  std::vector<Point> response_;  // W dA_i/dr_k, entry by entry of the rings
  double stiffness_ = 0;         // epsilon tr A/N
  linear::RingMatrix matrix_;
  linear::RingSolver solver_;
};

/// Areas of the cells of a mesh. Throws std::invalid_argument naming a cell without area.
std::vector<double> first_areas(const Mesh& mesh, const Triangulation& triangulation);

}  // namespace seiche::free_lagrangian
