#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/QR>

#include "reports/evidence/grid_convergence.hpp"
#include "reports/evidence/verdict.hpp"
#include "verification/check.hpp"

namespace seiche::verification::observed_order_test {

using namespace evidence;

const std::vector<double> sizes{0.1, 0.05, 0.025, 0.0125, 0.00625};

std::vector<double> errors_of_order(double p) {
  std::vector<double> errors;
  for (const double h : sizes) errors.push_back(3 * std::pow(h, p));
  return errors;
}

TEST_CASE("an exact power law gives its order with no scatter", "[order]") {
  const ObservedOrder observed = observed_order(sizes, errors_of_order(2));
  CHECK(std::abs(observed.order - 2) < 1e-13);
  CHECK(observed.half_width < 1e-12);
  CHECK(judge(observed, Order{2, 0.1, "test"}).verdict == Verdict::pass);
}

TEST_CASE("an order far above theory fails as one far below does", "[order]") {
  const Order second{2, 0.1, "test"};
  CHECK(judge(observed_order(sizes, errors_of_order(3)), second).verdict == Verdict::fail);
  CHECK(judge(observed_order(sizes, errors_of_order(1)), second).verdict == Verdict::fail);
}

TEST_CASE("scatter wider than the tolerance is inconclusive", "[order]") {
  std::vector<double> errors = errors_of_order(2);
  errors[1] *= 2;
  errors[3] /= 2;
  CHECK(judge(observed_order(sizes, errors), Order{2, 0.1, "test"}).verdict == Verdict::inconclusive);
  // Scatter without a slope: the order is the expected one, and is not known.
  errors = errors_of_order(2);
  const std::vector<double> residuals{2, -1, -2, -1, 2};
  for (std::size_t k = 0; k < errors.size(); ++k) errors[k] *= std::exp(0.2 * residuals[k]);
  CHECK(judge(observed_order(sizes, errors), Order{2, 0.1, "test"}).verdict == Verdict::inconclusive);
}

TEST_CASE("points at the round-off floor are left out and named", "[order]") {
  std::vector<double> errors = errors_of_order(2);
  errors[4] = 1e-15;
  const ObservedOrder observed = observed_order(sizes, errors, 1e-14);
  CHECK(observed.sizes.size() == 4);
  CHECK(std::abs(observed.order - 2) < 1e-13);
  CHECK(observed.note.find("0.00625") != std::string::npos);
}

TEST_CASE("fewer than four usable points are inconclusive", "[order]") {
  std::vector<double> errors = errors_of_order(2);
  errors[3] = errors[4] = 0;
  CHECK(judge(observed_order(sizes, errors), Order{2, 0.1, "test"}).verdict == Verdict::inconclusive);
}

TEST_CASE("an error that is not a finite number is an error, sizes must be positive", "[order]") {
  for (const double broken : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      std::vector<double> errors = errors_of_order(2);
      errors[k] = broken;
      const ObservedOrder observed = observed_order(sizes, errors, 1e-14);
      CHECK(std::isnan(observed.order));
      CHECK(judge(observed, Order{2, 0.1, "test"}).verdict == Verdict::error);
    }
  }
  CHECK_THROWS_AS(observed_order({0.1, -0.1}, {1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(observed_order({0.1}, {1, 1}), std::invalid_argument);
}

TEST_CASE("the half-width of an observed order is Student's for a straight line plus the effect of the next order",
          "[order]") {
  // Residuals with neither mean nor slope over equidistant logarithms of the size, multiples of 0.01; the closed form
  // t(0.975, n - 2) sqrt(sum r^2/(n - 2)/sum (x - mean)^2) with quantiles of Student's distribution from a table.
  struct Sample {
    std::vector<double> residuals;
    double quantile, sum_of_squares, spread;
  };
  for (const auto& [residuals, quantile, sum_of_squares, spread] :
       {Sample{{1, -1, -1, 1}, 4.302653, 4, 5}, Sample{{2, -1, -2, -1, 2}, 3.182446, 14, 10},
        Sample{{5, -1, -4, -4, -1, 5}, 2.776445, 84, 17.5}}) {
    const auto n = static_cast<double>(residuals.size());
    std::vector<double> h, errors;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      h.push_back(std::exp(-static_cast<double>(k)));
      errors.push_back(std::exp(-1.7 * static_cast<double>(k) + 0.3 + 0.01 * residuals[k]));
    }
    const ObservedOrder observed = observed_order(h, errors);
    CHECK(std::abs(observed.order - 1.7) < 1e-12);
    const double expected = quantile * 0.01 * std::sqrt(sum_of_squares / (n - 2) / spread);
    Eigen::MatrixXd columns(h.size(), 3);
    Eigen::VectorXd log_error(h.size());
    for (Eigen::Index k = 0; k < columns.rows(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      columns.row(k) << 1, std::log(h[i]), h[i];
      log_error[k] = std::log(errors[i]);
    }
    const double moved = std::abs(columns.colPivHouseholderQr().solve(log_error)[1] - 1.7);
    CHECK(std::abs(observed.half_width / (expected + moved) - 1) < 2e-7);  // seven digits of the table
  }
}

TEST_CASE("the interval of an observed order holds the true one 95 times in 100 beside a next order", "[order]") {
  // The next order is up to a quarter of the error of the coarsest mesh. Where scatter and what it moves are alike, as
  // with scatter of 2 to 5 %, the share falls to 91 %.
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> next(-2.5, 2.5);
  for (const double scatter : {0.1, 0.001}) {
    std::normal_distribution<double> noise(0, scatter);
    constexpr int trials = 10000;
    int covered = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> errors = errors_of_order(2);
      const double c = next(random);
      for (std::size_t k = 0; k < errors.size(); ++k) errors[k] *= (1 + c * sizes[k]) * std::exp(noise(random));
      const ObservedOrder observed = observed_order(sizes, errors);
      if (std::abs(observed.order - 2) <= observed.half_width) ++covered;
    }
    // Four standard deviations of a share of 10000.
    CHECK(static_cast<double>(covered) / trials > 0.95 - 4 * std::sqrt(0.95 * 0.05 / trials));
  }
}

TEST_CASE("grid convergence recovers the limit and covers the error", "[grid-convergence]") {
  std::vector<double> values;
  for (const double h : sizes) values.push_back(1.5 + 4 * h * h);
  const GridConvergence study = grid_convergence(sizes, values, 2);
  CHECK(std::abs(study.extrapolated - 1.5) < 1e-6);
  CHECK(std::abs(study.order - 2) < 0.01);
  const double error = std::abs(values.back() - 1.5);
  CHECK(study.uncertainty >= error);
  CHECK(study.uncertainty < 1.3 * error);
}

TEST_CASE("grid convergence with three grids is the grid convergence index", "[grid-convergence]") {
  // Roache (1994): GCI = 1.25 |f2 - f1| / (r^p - 1) with refinement ratio r = 2 and p = 2.
  const GridConvergence study = grid_convergence({1, 2, 4}, {1.01, 1.04, 1.16}, 2);
  CHECK(std::abs(study.uncertainty - 1.25 * 0.03 / 3) < 1e-4);
}

TEST_CASE("an order that cannot be trusted widens the uncertainty", "[grid-convergence]") {
  const GridConvergence good = grid_convergence({1, 2, 4}, {1.01, 1.04, 1.16}, 2);
  const GridConvergence odd = grid_convergence({1, 2, 4}, {1.01, 1.04, 3.0}, 2);  // observed order 6
  CHECK(odd.uncertainty > 2 * good.uncertainty);
  CHECK_FALSE(odd.note.empty());
  // 1 + h^3 where h^2 is expected: the line through (1, 2), (4, 9), (16, 65) starts at -5 and leaves squares of 56/3.
  CHECK(std::abs(grid_convergence({1, 2, 4}, {2, 9, 65}, 2).uncertainty - (3 * 7 + 2 * std::sqrt(56.0 / 3))) < 1e-9);
  CHECK(grid_convergence({1, 2, 4}, {5, 5, 5}, 2).uncertainty == 0);
  CHECK(std::isnan(grid_convergence({1, 2, 4}, {5, std::numeric_limits<double>::quiet_NaN(), 5}, 2).uncertainty));
  CHECK_THROWS_AS(grid_convergence({1, 2}, {1, 1}, 2), std::invalid_argument);
  CHECK_THROWS_AS(grid_convergence({1, 1, 1}, {1, 1, 1}, 2), std::invalid_argument);
}

}  // namespace seiche::verification::observed_order_test
