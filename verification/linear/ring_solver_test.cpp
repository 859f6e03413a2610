// Matrices of rings and their solvers, when the pattern changes.
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/linear/sparse_cholesky.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::ring_solver_test {

using linear::RingMatrix;
using linear::RingSolver;

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

/// The rings of a mesh of 217 nodes, with a positive definite block each.
struct Rings {
  DirichletCells cells;
  std::size_t unknowns;
  RingMatrix matrix;
  Eigen::MatrixXd dense;

  explicit Rings(unsigned long seed) {
    const free_lagrangian::Mesh mesh =
        free_lagrangian::jittered(free_lagrangian::free_patch(15, 12, {0, 0}, {1.25, 1}), 0.3, seed);
    unknowns = mesh.nodes();
    cells.connect(triangulate_polygon(mesh.places(), mesh.outline), static_cast<int>(unknowns));
    fill();
  }
  void fill() {
    matrix.set_rings(cells.begin(), cells.members(), unknowns);
    const auto entry = [&](std::size_t k, int p, int q) {
      const int n = cells.begin()[k + 1] - cells.begin()[k];
      return p == q ? 2.0 + 0.1 * static_cast<double>(k % 7) : -1.0 / n - 0.002 * p * q;
    };
    matrix.sum(entry);
    const auto size = static_cast<Eigen::Index>(unknowns);
    dense = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t k = 0; k < unknowns; ++k) {
      const int n = cells.begin()[k + 1] - cells.begin()[k];
      for (int p = 0; p < n; ++p) {
        for (int q = 0; q < n; ++q) {
          dense(cells.members()[index(cells.begin()[k] + p)], cells.members()[index(cells.begin()[k] + q)]) +=
              entry(k, std::max(p, q), std::min(p, q));
        }
      }
    }
  }
};

TEST_CASE("matrices of rings are the sums of their blocks, and are solved", "[linear]") {
  Check check(
      "ring_solver", "Systems whose pattern changes",
      "Rings of the nodes of a mesh with a positive definite block each. The sum and its products are compared with "
      "dense matrices, solutions with Eigen's. A second mesh has another pattern: it is analysed anew, and only then.");
  Rings first(1);
  Rings second(2);
  const std::size_t n = first.unknowns;
  Noise noise(4);
  Eigen::VectorXd x(static_cast<Eigen::Index>(n));
  for (double& value : x) value = noise();
  const Eigen::VectorXd b = first.dense * x;
  const Eigen::VectorXd y = first.matrix.lower().selfadjointView<Eigen::Lower>() * x;
  Worst off;
  for (std::size_t i = 0; i < n; ++i) off.add((y - b)[static_cast<Eigen::Index>(i)], static_cast<double>(i));
  const Roundoff of_row{
      .operations = 100, .scale = 10, .reason = "some fifty terms in a row, in two orders, of a sum of 10"};
  check.holds("The product A x agrees with the dense sum.", {off.value()}, of_row);
  constexpr double shift = 1e-8;  // of the diagonal, for the factors alone: refinement takes it out
  RingSolver solver;
  std::vector<double> solution(n, 0.0);
  solver.factor(first.matrix, 1);  // other values of the same pattern
  solver.factor(first.matrix, shift);
  const long once = solver.analyses();
  solver.solve({b.data(), n}, solution);
  Worst error;
  for (std::size_t i = 0; i < n; ++i) error.add(solution[i] - x[static_cast<Eigen::Index>(i)]);
  const Eigen::VectorXd other = second.dense * x;
  second.matrix = first.matrix;
  second.fill();
  solver.factor(second.matrix, shift);
  std::fill(solution.begin(), solution.end(), 0.0);
  solver.solve({other.data(), n}, solution);
  for (std::size_t i = 0; i < n; ++i) error.add(solution[i] - x[static_cast<Eigen::Index>(i)]);
  check.holds("Solutions before and after a change of the pattern.", {error.value()},
              Bound{1e-13, "condition number below 100 times rounding"});
  check.holds("The pattern is analysed if and only if it has changed.",
              {static_cast<double>(10 * once + solver.analyses())}, Bound{0, "one, then two", 12});
  Refusals refusals(check);
  refusals.refused({"unknown 2", "no ring"}, [] {
    RingMatrix matrix;
    const std::vector<int> begin{0, 2};
    const std::vector<int> member{0, 1};
    matrix.set_rings(begin, member, 3);
  });
}

}  // namespace seiche::verification::ring_solver_test
