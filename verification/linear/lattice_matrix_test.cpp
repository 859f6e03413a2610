// Matrices of lattices beside the dense matrices that they stand for.
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/linear/mesh_matrix.hpp"

namespace lattice_matrix_test {

using namespace seiche::linear;
using seiche::Worst;
using seiche::worst;
using namespace seiche::verification;

struct Shape {
  std::size_t columns, rows, layers;
  [[nodiscard]] std::size_t size() const { return columns * rows * layers; }
};

/// What lies between two cells.
struct Offset {
  int di, dj, dl;
  [[nodiscard]] bool neighbours() const { return std::abs(di) <= 1 && std::abs(dj) <= 1 && std::abs(dl) <= 1; }
};

Offset between(const Shape& shape, std::size_t from, std::size_t to) {
  const auto less = [](std::size_t a, std::size_t b) { return static_cast<int>(a) - static_cast<int>(b); };
  return {less(to % shape.columns, from % shape.columns),
          less(to / shape.columns % shape.rows, from / shape.columns % shape.rows),
          less(to / shape.columns / shape.rows, from / shape.columns / shape.rows)};
}

/// Random couplings of all neighbours, of either sign, on a diagonal that exceeds their sum by one.
Eigen::MatrixXd random_matrix(const Shape& shape, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto size = static_cast<Eigen::Index>(shape.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t p = 0; p < shape.size(); ++p) {
    for (std::size_t q = p + 1; q < shape.size(); ++q) {
      if (!between(shape, p, q).neighbours()) continue;
      const auto i = static_cast<Eigen::Index>(p), j = static_cast<Eigen::Index>(q);
      a(i, j) = a(j, i) = unit(random);
    }
  }
  a.diagonal() = a.cwiseAbs().rowwise().sum().array() + 1;
  return a;
}

/// action(cell, later neighbour or the cell itself, offset, value) for all couplings.
template <class Action>
void for_each_coupling(const Shape& shape, const Eigen::MatrixXd& a, const Action& action) {
  for (std::size_t p = 0; p < shape.size(); ++p) {
    for (std::size_t q = p; q < shape.size(); ++q) {
      const Offset offset = between(shape, p, q);
      if (offset.neighbours()) action(p, q, offset, a(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)));
    }
  }
}

StencilMatrix stencil(const Shape& shape, const Eigen::MatrixXd& dense) {
  StencilMatrix a(shape.columns, shape.rows, shape.layers);
  for_each_coupling(shape, dense, [&](std::size_t p, std::size_t q, Offset to, double value) {
    a[p == q ? a.own : 1 + later_neighbour(to.di, to.dj, to.dl)][p] = value;
  });
  return a;
}

/// Largest errors of the product, of x.Ax and of single coefficients.
struct Errors {
  Worst product, form, coefficient;

  void add(const Shape& shape, const Eigen::MatrixXd& dense) {
    StencilMatrix matrix = stencil(shape, dense);
    LatticeArray x(shape.columns, shape.rows * shape.layers);
    LatticeArray y = x;
    const Eigen::VectorXd values = random_vector(shape.size());
    std::ranges::copy(values, x.data());
    const double dot = matrix.multiply_and_dot(x, y);
    const Eigen::VectorXd expected = dense * values;
    const double scale = worst(dense.cwiseAbs() * values.cwiseAbs());
    product.add(worst(Eigen::Map<const Eigen::VectorXd>(y.data(), values.size()) - expected) / scale);
    form.add((dot - values.dot(expected)) / (scale * static_cast<double>(shape.size())));
    for_each_coupling(shape, dense, [&](std::size_t p, std::size_t q, Offset, double value) {
      coefficient.add(matrix.coefficient(p, q) - value);
      coefficient.add(matrix.coefficient(q, p) - value);
    });
  }
};

TEST_CASE("matrices of meshes equal their dense matrices", "[linear]") {
  Check check("lattice_matrices", "Matrices of meshes against dense ones",
              "Random couplings of all neighbours, filled in by their position in the mesh: products, scalar products "
              "and single coefficients against a dense matrix.");
  for (const std::size_t neighbours : {9U, 27U}) {
    Errors errors;
    const auto shapes = neighbours == 9
                            ? std::vector<Shape>{{1, 1, 1}, {5, 1, 1}, {1, 6, 1}, {2, 2, 1}, {7, 5, 1}, {12, 17, 1}}
                            : std::vector<Shape>{{1, 1, 1}, {3, 1, 4}, {1, 4, 3}, {2, 2, 2}, {6, 5, 1}, {5, 4, 6}};
    for (const Shape& shape : shapes) errors.add(shape, random_matrix(shape, 1));
    const double operations = 2 * static_cast<double>(neighbours);
    for (const auto& [what, error, limit] :
         {std::tuple{"Products", errors.product, Roundoff{operations, 1, "a product and a sum for each neighbour"}},
          {"Scalar products x.Ax", errors.form, Roundoff{operations, 1, "errors of rows are independent"}},
          {"Coefficients addressed by their two cells", errors.coefficient, Roundoff{0, 1, "the same number"}}}) {
      check.holds(fmt::format("{} of {}-point matrices equal the dense results.", what, neighbours), {error.value()},
                  limit);
    }
  }
}

TEST_CASE("conjugate gradients converge in as many iterations as there are distinct eigenvalues", "[linear]") {
  Check check("gradients_eigenvalues", "Conjugate gradients on few eigenvalues",
              "A diagonal matrix of 9000 unknowns with the eigenvalues 1 to 5: five iterations are enough where "
              "directions are conjugate, and where every unknown takes part in every sum.");
  constexpr std::size_t size = 9000;
  LatticeArray b(size, 1);
  for (std::size_t i = 0; i < size; ++i) b.data()[i] = 1 + static_cast<double>(i % 7);
  const auto eigenvalue = [](std::size_t i) { return static_cast<double>(1 + i % 5); };
  LatticeArray x(size, 1);
  ConjugateGradients<> gradients;
  const auto multiply = [&](const LatticeArray& p, LatticeArray& q) {
    double dot = 0;
    for (std::size_t i = 0; i < size; ++i) {
      q.data()[i] = eigenvalue(i) * p.data()[i];
      dot += p.data()[i] * q.data()[i];
    }
    return dot;
  };
  const auto copy = [](std::span<const double> r, std::span<double> z, double) { std::ranges::copy(r, z.begin()); };
  int iterations = 0;
  try {
    iterations = gradients.solve(multiply, copy, b, x, {1e-12, 100}).iterations;
  } catch (const NotConverged&) {
    iterations = 100;
  }
  check.holds("The number of iterations for five distinct eigenvalues is five.", {static_cast<double>(iterations)},
              Bound{0, "one for each eigenvalue, of a condition of five", 5});
  Worst error;
  for (std::size_t i = 0; i < size; ++i) error.add(x.data()[i] * eigenvalue(i) / b.data()[i] - 1);
  check.holds("Every unknown is the right-hand side over its eigenvalue.", {error.value()},
              Bound{1e-12 * 7 * std::sqrt(9000.0),
                    "the tolerance times the norm of the right-hand side, over its smallest entry"});
}

}  // namespace lattice_matrix_test
