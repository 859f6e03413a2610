// Direct solvers of nine-point systems against dense Cholesky factorisation.
#include "seiche/linear/nine_point_cholesky.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/linear/mesh_matrix.hpp"

namespace seiche::verification::nine_point_cholesky_test {

using namespace linear;

struct Shape {
  std::size_t columns, rows;
};
constexpr double cell_width = 0.25;

StencilMatrix matrix_of(Shape s, double amplitude) {
  return mesh_matrix(s.columns, s.rows, cell_width, 1 / static_cast<double>(s.rows), amplitude);
}

Eigen::VectorXd solution(const StencilMatrix& a, const Eigen::VectorXd& b) {
  NinePointCholesky solver(a.columns(), a.rows());
  solver.factor(a);
  Eigen::VectorXd x = b;
  solver.solve({x.data(), a.size()}, {x.data(), a.size()});
  return x;
}

/// |b - A x| / (|A| |x| + |b|), largest entry of each.
double backward_error(const Eigen::MatrixXd& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const double scale = worst(a.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs());
  return worst(b - a * x) / scale;
}

TEST_CASE("direct solvers of nine-point systems solve them to round-off", "[linear]") {
  Check check("nine_point_cholesky", "Direct solvers of nine-point systems",
              "Pressure matrices of deformed quadrilateral meshes, from one cell to 33 x 40, with a random right-hand "
              "side: block elimination inside the band, from both ends, against Eigen's dense LLT. Residuals are "
              "relative to $|A||x| + |b|$, which elimination of a positive definite matrix reaches whatever its "
              "condition; solutions differ by up to the condition number times that.");
  Worst residual, difference;  // from the dense solution, over the condition number
  const std::vector<Shape> shapes{{1, 1},  {2, 1},  {1, 3},  {2, 2},  {3, 3},  {5, 3},  {3, 7},   {8, 8},  {9, 8},
                                  {60, 1}, {1, 60}, {2, 61}, {40, 8}, {7, 50}, {50, 9}, {24, 17}, {33, 40}};
  for (const Shape shape : shapes) {
    for (const double amplitude : {0.0, 0.05, 0.2}) {
      if (amplitude != 0.2 && shape.columns * shape.rows > 1000) continue;  // a dense elimination takes a second
      const StencilMatrix a = matrix_of(shape, amplitude);
      const Eigen::MatrixXd full = dense(a);
      const Eigen::VectorXd b = random_vector(a.size());
      const Eigen::LLT<Eigen::MatrixXd> cholesky(full);
      const Eigen::VectorXd expected = cholesky.solve(b);
      const Eigen::VectorXd x = solution(a, b);
      residual.add(backward_error(full, x, b));
      difference.add((x - expected).norm() / expected.norm() * cholesky.rcond());
    }
  }
  const double round_off = std::numeric_limits<double>::epsilon() / 2;
  check.holds("Block elimination inside the band leaves a residual of round-off.", {residual.value()},
              Bound{100 * round_off,
                    "one rounding per number in a row of the factor and of its transpose, at most 41 each, and per "
                    "coefficient of the matrix, nine"});
  check.holds("Block elimination inside the band agrees with dense elimination.", {difference.value()},
              Bound{200 * round_off, "the residuals' bound, for each of the two solutions"});
}

TEST_CASE("solutions of nine-point systems too large for dense elimination leave a residual of round-off", "[linear]") {
  for (const Shape shape : {Shape{240, 8}, {16, 300}, {64, 64}, {200, 100}}) {
    StencilMatrix a = matrix_of(shape, 0.05);
    const Eigen::VectorXd b = random_vector(a.size());
    const Eigen::VectorXd x = solution(a, b);
    const auto product = [&](const Eigen::VectorXd& factor) {
      LatticeArray in(shape.columns, shape.rows), out(shape.columns, shape.rows);
      std::ranges::copy(factor, in.data());
      a.multiply_and_dot(in, out);
      return Eigen::VectorXd(as_vector(out.values()));
    };
    const double residual = worst(product(x) - b);
    for (const std::size_t part : {a.right, a.up, a.up_right, a.up_left}) {
      for (std::size_t c = 0; c < a.size(); ++c) a[part][c] = std::abs(a[part][c]);
    }
    // A factor's row has up to 102 numbers, and so has its transpose's.
    const double round_off = std::numeric_limits<double>::epsilon() / 2;
    CHECK(residual <= 220 * round_off * worst(product(x.cwiseAbs())));
  }
}

TEST_CASE("a nine-point matrix that is not positive definite is rejected with its cell", "[linear]") {
  for (const Shape shape : {Shape{1, 1}, {4, 3}, {30, 9}, {9, 30}, {40, 3}}) {
    NinePointCholesky solver(shape.columns, shape.rows);
    StencilMatrix a = matrix_of(shape, 0.1);
    for (std::size_t cell = 0; cell < a.size(); ++cell) {
      const double good = std::exchange(a[a.own][cell], -1000.0);
      for (const double bad : {-1000.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        a[a.own][cell] = bad;
        try {
          solver.factor(a);
          FAIL("accepted");
        } catch (const NotPositiveDefinite& error) {
          CHECK(error.row() == cell);
        }
      }
      a[a.own][cell] = good;
    }
    // A failure leaves nothing behind.
    const Eigen::VectorXd b = random_vector(a.size());
    solver.factor(a);
    Eigen::VectorXd x(b.size());
    solver.solve({b.data(), a.size()}, {x.data(), a.size()});
    CHECK(x == solution(a, b));
    CHECK_THROWS_AS(solver.factor(StencilMatrix(shape.columns + 1, shape.rows)), std::invalid_argument);
  }
  CHECK_THROWS_AS(NinePointCholesky(0, 3), std::invalid_argument);
  CHECK_THROWS_AS(NinePointCholesky(3, 0), std::invalid_argument);
}

TEST_CASE("sparse Cholesky rejects matrices that are not lower triangles and wrong numbers of values", "[linear]") {
  Eigen::SparseMatrix<double> a(3, 3);
  for (int i = 0; i < 3; ++i) a.insert(i, i) = 1;
  a.makeCompressed();
  SparseCholesky solver(a);
  CHECK_THROWS_AS(solver.factor(std::vector<double>(2, 1.0)), std::invalid_argument);
  std::vector<double> x = {4, 8, 12};
  solver.factor(std::vector<double>(3, 4.0));
  solver.solve(x, x);
  CHECK(x == std::vector<double>{1, 2, 3});
  a.insert(0, 1) = 1;
  a.makeCompressed();
  CHECK_THROWS_AS(SparseCholesky(a), std::invalid_argument);
  CHECK_THROWS_AS(SparseCholesky(Eigen::SparseMatrix<double>(2, 3)), std::invalid_argument);
  CHECK_THROWS_AS(SparseCholesky(Eigen::SparseMatrix<double>(2, 2)), std::invalid_argument);
}

}  // namespace seiche::verification::nine_point_cholesky_test
