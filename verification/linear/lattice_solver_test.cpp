// Conjugate gradients preconditioned by the undeformed lattice, on pressure matrices of quadrilateral meshes.
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <unsupported/Eigen/KroneckerProduct>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/cosine_lattice.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/linear/mesh_matrix.hpp"

namespace seiche::verification::lattice_solver_test {

using namespace linear;

LatticeArray random_array(std::size_t columns, std::size_t rows) {
  LatticeArray result(columns, rows);
  std::ranges::copy(random_vector(columns * rows), result.data());
  return result;
}

/// Largest entry of P b - A^-1 b, relative to the largest of A^-1 b, b random.
double inverse_error(CosineLattice& lattice, const Eigen::MatrixXd& a) {
  const auto b = random_array(static_cast<std::size_t>(a.rows()), 1);
  const Eigen::VectorXd expected = a.llt().solve(as_vector(b.values()));
  std::vector<double> x(b.values().begin(), b.values().end());
  lattice.solve(x, x);
  return worst(as_vector(x) - expected) / worst(expected);
}

double mesh_error(std::size_t columns, double h1, const std::vector<double>& row_heights) {
  CosineLattice lattice({columns, 1, row_heights.size()}, hexahedral_lattice(h1, 1, row_heights));
  return inverse_error(lattice, dense(mesh_matrix(columns, h1, row_heights, 0)));
}

/// Second difference with reflecting ends.
Eigen::MatrixXd second_difference(std::size_t size) {
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    result.block<2, 2>(i, i) += Eigen::Matrix2d{{1.0, -1.0}, {-1.0, 1.0}};
  }
  return result;
}

/// I + second differences in three directions, with factors 1, 2 and 3: dense against cosines.
double box_error(CosineLattice::Shape shape) {
  const Eigen::MatrixXd dx = second_difference(shape.nx);
  const Eigen::MatrixXd dz = second_difference(shape.nz);
  const Eigen::MatrixXd dy = second_difference(shape.layers);
  const auto of_all = [](const Eigen::MatrixXd& y, const Eigen::MatrixXd& z, const Eigen::MatrixXd& x) {
    const Eigen::MatrixXd plane = Eigen::kroneckerProduct(z, x);
    return Eigen::MatrixXd(Eigen::kroneckerProduct(y, plane));
  };
  const auto one = [](const Eigen::MatrixXd& d) { return Eigen::MatrixXd::Identity(d.rows(), d.rows()); };
  const Eigen::MatrixXd a = of_all(one(dy), one(dz), one(dx)) + of_all(one(dy), one(dz), dx) +
                            2 * of_all(one(dy), dz, one(dx)) + 3 * of_all(dy, one(dz), one(dx));
  CosineLattice lattice(shape, [&](double theta, double psi, std::span<double> diagonal, std::span<double> off) {
    for (std::size_t j = 0; j < diagonal.size(); ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      diagonal[j] = 1 + 2 * (1 - std::cos(theta)) + 4 * (1 - std::cos(psi)) + 3 * dy(k, k);
    }
    std::ranges::fill(off, -3.0);
  });
  return inverse_error(lattice, a);
}

/// A mesh four depths long, its matrix and its preconditioner.
struct Problem {
  StencilMatrix a;
  CosineLattice lattice;
  ConjugateGradients<> solver;
  Problem(std::size_t columns, std::size_t rows, double amplitude)
      : a(mesh_matrix(columns, rows, 4.0 / static_cast<double>(columns), 1.0 / static_cast<double>(rows), amplitude)),
        lattice({columns, 1, rows}, hexahedral_lattice(4.0 / static_cast<double>(columns), 1,
                                                       std::vector<double>(rows, 1.0 / static_cast<double>(rows)))) {}

  ConjugateGradients<>::Result solve(const LatticeArray& b, LatticeArray& x, ConjugateGradients<>::Goal goal) {
    return solver.solve([&](const LatticeArray& p, LatticeArray& q) { return a.multiply_and_dot(p, q); },
                        [&](auto r, auto z, double magnitude) { lattice.solve(r, z, magnitude); }, b, x, goal);
  }
  int iterations(double tolerance) {
    LatticeArray x(a.columns(), a.rows());
    return solve(random_array(a.columns(), a.rows()), x, {tolerance}).iterations;
  }
};

TEST_CASE("the cosine transform inverts undeformed meshes to single precision", "[linear]") {
  Check check("cosine_lattice", "Cosine transforms invert the undeformed mesh",
              "The pressure matrix of an undeformed mesh, and a box of second differences in three directions, for "
              "random right-hand sides, against Eigen's dense Cholesky in double precision.");
  Largest mesh, box;
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 5}, {64, 8}, {101, 17}, {15, 64}}) {
    mesh.add(
        mesh_error(static_cast<std::size_t>(columns), 0.3, std::vector<double>(static_cast<std::size_t>(rows), 0.2)));
  }
  for (const CosineLattice::Shape shape :
       {CosineLattice::Shape{6, 5, 4}, {5, 6, 3}, {17, 3, 7}, {1, 8, 2}, {33, 2, 5}, {3, 33, 5}, {2, 1, 40}}) {
    box.add(box_error(shape));
  }
  all_hold(check,
           Bound{1e-5,
                 "single precision, 6e-8, times some tens of roundings in the transforms and in the elimination over "
                 "the layers"},
           {{"The cosine solver solves the pressure of a mesh of equal rows.", mesh.value()},
            {"Mesh whose rows differ in height.",
             worst(std::array{mesh_error(12, 0.3, {0.4, 0.1, 0.2, 0.15, 0.3, 0.25}), mesh_error(7, 0.1, {0.1, 0.3})})},
            {"The cosine solver solves the pressure of layers in a box.", box.value()},
            {"The cosine solver solves the pressure of one layer in a box.",
             worst(std::array{box_error({20, 31, 1}), box_error({31, 20, 1})})}});
}

TEST_CASE("conjugate gradients agree with dense elimination", "[linear]") {
  Check check("lattice_conjugate_gradients", "Conjugate gradients on deformed meshes against dense Cholesky",
              "Pressure matrices of deformed meshes, random right-hand sides, against Eigen's dense Cholesky. The "
              "error is at most the residual times the norm of the inverse, 1/(smallest eigenvalue).");
  for (const double tolerance : {1e-6, 1e-10, 1e-13}) {
    Largest worst, true_residual;
    for (const auto& [columns, rows] : {std::pair{40, 20}, {33, 7}, {1, 12}, {50, 1}, {7, 30}}) {
      Problem problem(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), 0.1);
      const auto b = random_array(problem.a.columns(), problem.a.rows());
      const Eigen::MatrixXd a = dense(problem.a);
      const Eigen::VectorXd expected = a.llt().solve(as_vector(b.values()));
      const double smallest = a.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
      auto x = random_array(problem.a.columns(), problem.a.rows());
      problem.solve(b, x, {tolerance});
      const auto found = as_vector(x.values());
      const double b_norm = as_vector(b.values()).norm();
      worst.add((found - expected).norm() * smallest / b_norm);
      true_residual.add((as_vector(b.values()) - a * found).norm() / b_norm);
    }
    // Roundings of the elimination and of the recurrence of the residual, at the size of |A| |x|.
    const double roundoff = 2e-14;
    all_hold(
        check, Bound{tolerance + roundoff, "the tolerance, and 2e-14 for rounding errors of |A| |x|"},
        {{fmt::format("The error of solutions to a relative residual of {:.0e} is within the bound of the residual.",
                      tolerance),
          worst.value()},
         {fmt::format("The true residual is {:.0e} when its recurrence gives this value.", tolerance),
          true_residual.value()}});
  }
}

TEST_CASE("iterations depend on the deformation, not on the size", "[linear]") {
  Check check("lattice_iterations", "Iterations of the pressure solver",
              "A mesh 4 h long, deformed along half cosines, random right-hand side, no initial guess. On equal "
              "deformations the undeformed matrix and the deformed one differ by factors that do not depend on the "
              "mesh width, so that the number of iterations does not either.");
  const std::vector<double> amplitudes = {0, 0.0125, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2};
  const std::vector<std::size_t> rows = {16, 64, 256};
  std::vector<std::vector<double>> found;
  for (const std::size_t r : rows) {
    found.emplace_back();
    for (const double amplitude : amplitudes) {
      found.back().push_back(Problem(4 * r, r, amplitude).iterations(1e-10));
    }
  }
  auto& panel = check
                    .figure("iterations", "Iterations to a relative residual of 1e-10",
                            "Number of iterations against the amplitude of the deformation, relative to the depth, for "
                            "three meshes of square cells.")
                    .panel({.x = "amplitude / depth", .y = "iterations", .y_min = 0});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    panel.points(fmt::format("{} x {} cells", 4 * rows[i], rows[i]), amplitudes, found[i],
                 i + 1 == rows.size() ? evidence::Role::computed : evidence::Role::peer);
  }
  const std::size_t chosen = 3;
  const auto on_meshes = [&](std::size_t k) { return std::array{found[0][k], found[1][k], found[2][k]}; };
  Largest spread;
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    if (amplitudes[k] <= 0.1) spread.add(largest(on_meshes(k)) - smallest(on_meshes(k)));
  }
  check.holds("The residual on the undeformed mesh falls by single precision per iteration.", {largest(on_meshes(0))},
              Bound{3, "1e-10 is two factors of 1e-5, and one iteration for the variation of the factors"});
  check.holds("The number of iterations to 1e-10 at a/h = 0.05 is at most 14.", {largest(on_meshes(chosen))},
              Bound{14, "the budget of a time step of a million cells"});
  check.holds("The number of iterations to 1e-13 at a/h = 0.05 is at most 20.",
              {static_cast<double>(Problem(1024, 256, 0.05).iterations(1e-13))},
              Bound{20, "the budget of a time step of a million cells"});
  check.holds("The number of iterations does not depend on the size, up to an amplitude of 0.1 h.", {spread.value()},
              Bound{3, "the coarsest mesh holds fewer of the eigenvalues that lie between the same bounds"});
}

TEST_CASE("the pressure solver gives the same bytes with any number of threads", "[linear]") {
  const int threads = omp_get_max_threads();
  const auto same_bytes = [](const auto& solution) {
    omp_set_num_threads(1);
    const std::vector<double> one = solution();
    for (const int count : {2, 3}) {
      omp_set_num_threads(count);
      const std::vector<double> several = solution();
      CHECK(std::memcmp(one.data(), several.data(), one.size() * sizeof(double)) == 0);
    }
  };
  // Odd numbers of rows, and enough unknowns for threads to be used.
  same_bytes([] {
    Problem problem(1024, 129, 0.05);
    auto x = random_array(1024, 129);
    problem.solve(random_array(1024, 129), x, {1e-10});
    return std::vector<double>(x.values().begin(), x.values().end());
  });
  same_bytes([] {
    CosineLattice lattice({131, 205, 5},
                          [](double theta, double psi, std::span<double> diagonal, std::span<double> off) {
                            std::ranges::fill(diagonal, 3 + theta + psi);
                            std::ranges::fill(off, -1.0);
                          });
    const auto b = random_array(std::size_t{131} * 205, 5);
    std::vector<double> x(b.size());
    lattice.solve(b.values(), x);
    return x;
  });
  omp_set_num_threads(threads);
}

TEST_CASE("conjugate gradients at the edges of their range", "[linear]") {
  Problem problem(24, 9, 0.05);
  const auto b = random_array(24, 9);
  LatticeArray x(24, 9);
  const auto from_zero = problem.solve(b, x, {1e-10});
  CHECK(from_zero.relative_residual <= 1e-10);
  CHECK(problem.solve(b, x, {1e-9}).iterations == 0);
  SECTION("a zero right-hand side has the zero solution") {
    CHECK(problem.solve(LatticeArray(24, 9), x, {1e-10}).iterations == 0);
    CHECK(std::ranges::all_of(x.values(), [](double value) { return value == 0; }));
  }
  SECTION("the scale of the right-hand side does not matter") {
    for (const double scale : {1e-100, 1e100}) {
      LatticeArray scaled = b;
      for (double& value : scaled.values()) value *= scale;
      LatticeArray y(24, 9);
      CHECK(problem.solve(scaled, y, {1e-10}).iterations == from_zero.iterations);
    }
  }
  SECTION("failure to converge is reported") {
    LatticeArray y(24, 9);
    CHECK_THROWS_AS(problem.solve(b, y, {1e-10, 3}), NotConverged);
    for (std::size_t c = 0; c < problem.a.size(); ++c) problem.a[problem.a.own][c] *= -1;
    CHECK_THROWS_AS(problem.solve(b, y, {1e-10}), NotPositiveDirection);
    problem.a[problem.a.own][7] = std::nan("");
    CHECK_THROWS_AS(problem.solve(b, y, {1e-10}), std::runtime_error);
  }
}

TEST_CASE("singular meshes are rejected", "[linear]") {
  const auto made = [](CosineLattice::Shape shape, double value) {
    return CosineLattice(shape, [value](double, double, std::span<double> diagonal, std::span<double> off) {
      std::ranges::fill(diagonal, value);
      std::ranges::fill(off, -1.0);
    });
  };
  CHECK_NOTHROW(made({3, 2, 4}, 2));
  for (const double value : {1.0, std::nan("")}) CHECK_THROWS_AS(made({3, 2, 4}, value), NotPositiveDefinite);
  for (const CosineLattice::Shape shape : {CosineLattice::Shape{0, 2, 4}, {3, 0, 4}, {3, 2, 0}}) {
    CHECK_THROWS_AS(made(shape, 2), std::invalid_argument);
  }
  CHECK_THROWS_AS(hexahedral_lattice(0, 1, {1.0}), std::invalid_argument);
  CHECK_THROWS_AS(hexahedral_lattice(1, 1, {}), std::invalid_argument);
  CHECK_THROWS_AS(hexahedral_lattice(1, 1, {1.0, -1.0}), std::invalid_argument);
  CHECK_THROWS_AS(hexahedral_lattice(1, 1, {1.0}, 0), std::invalid_argument);
}

}  // namespace seiche::verification::lattice_solver_test
