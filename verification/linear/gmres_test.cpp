// Generalised minimal residuals against a direct solver, and against what minimising the residual means.
#include <cmath>
#include <random>

#include <Eigen/Dense>

#include "seiche/linear/gmres.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::gmres_test {

using linear::Gmres;

/// I + a random matrix of norm about a half, not symmetric: like an integral equation of the second kind.
Eigen::MatrixXd second_kind(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::MatrixXd a(n, n);
  for (double& entry : a.reshaped()) entry = 0.5 * unit(random) / std::sqrt(static_cast<double>(n));
  return a + Eigen::MatrixXd::Identity(n, n);
}

auto times(const Eigen::MatrixXd& a) {
  return [&a](const Eigen::VectorXd& x, Eigen::VectorXd& product) { product = a * x; };
}

/// Smallest |b - A x| of all x in span(b, A b, .., A^(k-1) b), by orthogonal columns of its image.
double least_residual(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, Eigen::Index k) {
  Eigen::MatrixXd image(b.size(), k);
  Eigen::VectorXd power = b;
  for (Eigen::Index j = 0; j < k; ++j) {
    power = (a * power).normalized();
    image.col(j) = power;
  }
  const Eigen::VectorXd part = image.colPivHouseholderQr().solve(b);
  return (b - image * part).norm();
}

TEST_CASE("GMRES solves systems of the second kind and stops at its tolerance", "[linear]") {
  verification::Check check(
      "gmres", "Generalised minimal residuals",
      "Random systems $x + K x = b$ of 40 unknowns, $K$ not symmetric and of norm below one. The residual that the "
      "recurrence promises is the one that is there; it is the least in the Krylov space; there is an iteration for "
      "each factor that the residual has to fall, and none more. One solver for all systems, as a wave uses it.");
  constexpr Eigen::Index n = 40;
  Gmres solver;
  Worst error, excess;
  Largest met, needless;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Eigen::MatrixXd a = second_kind(n, seed);
    const Eigen::VectorXd expected = second_kind(n, seed + 10).col(0) * 3;
    const Eigen::VectorXd b = a * expected;
    Eigen::VectorXd x;
    solver.solve(times(a), b, x, 1e-15);
    error.add((x - expected).lpNorm<Eigen::Infinity>());
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const int iterations = solver.solve(times(a), b, x, tolerance);
      const double residual = (b - a * x).norm();
      met.add(residual / (tolerance * b.norm()));
      excess.add(residual - least_residual(a, b, iterations));
      // With one iteration less the best residual is still too large.
      needless.add(tolerance * b.norm() / least_residual(a, b, iterations - 1));
    }
  }
  check.holds("The solution of a system of 40 unknowns.", {error.value()},
              evidence::Roundoff{2 * n * n, 3, "forty products of forty terms; condition below 3"});
  check.holds("The residual of the solution is at most the tolerance requested.", {met.value()},
              evidence::Bound{1 + 1e-9,
                              "the recurrence's residual is at most the goal; it rounds to 1e-16 of a residual that is "
                              "1e-6 of the beginning, and no more than 1e-9"});
  check.holds(
      "The residual is the smallest over the Krylov space.", {excess.value()},
      evidence::Roundoff{2 * n * n, 3 * 10,
                         "residuals of a right-hand side of norm 3, by two orthogonalisations of vectors of 40"});
  check.holds("An iteration less would not have met the goal.", {needless.value()},
              evidence::Bound{1, "iterations end with the first residual below the goal"});
}

TEST_CASE("GMRES ends after the allowed number of iterations with its best solution", "[linear]") {
  const Eigen::MatrixXd a = second_kind(30, 3);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(30);
  Eigen::VectorXd x;
  CHECK(Gmres().solve(times(a), b, x, 1e-14, 4) == 4);
  CHECK(std::abs((b - a * x).norm() - least_residual(a, b, 4)) < 1e-13);
}

TEST_CASE("GMRES of a right-hand side of zeros is zero without an iteration", "[linear]") {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(5, 5);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(5);
  CHECK(Gmres().solve(times(one), Eigen::VectorXd::Zero(5), x, 1e-10) == 0);
  CHECK(x.norm() == 0);
}

}  // namespace seiche::verification::gmres_test
