// Matrices of rings and their solvers, when the pattern changes.
#include <array>
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
  const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(n), [&] { return noise(); });
  const Eigen::VectorXd b = first.dense * x;
  const Eigen::VectorXd y = first.matrix.lower().selfadjointView<Eigen::Lower>() * x;
  check.holds("The product A x agrees with the dense sum.", {worst(y - b)},
              Roundoff{100, 10, "some fifty terms in a row, in two orders, of a sum of 10"});
  constexpr double shift = 1e-8;  // of the diagonal, for the factors alone: refinement takes it out
  RingSolver solver;
  const auto error = [&](const Rings& rings, const Eigen::VectorXd& right_hand_side) {
    solver.factor(rings.matrix, shift);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(x.size());
    solver.solve({right_hand_side.data(), n}, {solution.data(), n});
    return worst(solution - x);
  };
  solver.factor(first.matrix, 1);  // other values of the same pattern
  const double before = error(first, b);
  const long once = solver.analyses();
  const Eigen::VectorXd other = second.dense * x;
  second.matrix = first.matrix;
  second.fill();
  check.holds("Solutions before and after a change of the pattern.", {worst(std::array{before, error(second, other)})},
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
