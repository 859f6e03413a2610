#include "validation/instruments/harmonic_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "seiche/require.hpp"

namespace seiche::validation {
namespace {

double first_guess(std::span<const double> samples, double tau) {
  double product = 0;
  double square = 0;
  for (std::size_t n = 1; n + 1 < samples.size(); ++n) {
    product += samples[n] * (samples[n - 1] + samples[n + 1]);
    square += samples[n] * samples[n];
  }
  return std::acos(std::clamp(0.5 * product / square, -1.0, 1.0)) / tau;
}

/// Columns 1, cos m Omega t, sin m Omega t, ... and last the derivative by Omega of their sum with these weights.
Eigen::MatrixXd columns_of(const Eigen::ArrayXd& times, double frequency, const std::vector<int>& harmonics,
                           const Eigen::VectorXd& weights) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(times.size(), weights.size() + 1);
  columns.col(0).setOnes();
  Eigen::Index j = 1;
  for (const int m : harmonics) {
    columns.col(j) = (m * frequency * times).cos();
    columns.col(j + 1) = (m * frequency * times).sin();
    columns.rightCols<1>().array() +=
        m * times * (weights[j + 1] * columns.col(j).array() - weights[j] * columns.col(j + 1).array());
    j += 2;
  }
  return columns;
}

}  // namespace

Oscillation fit_oscillation(std::span<const double> samples, double tau, const std::vector<int>& harmonics) {
  require_positive("tau", tau);
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index terms = 1 + 2 * static_cast<Eigen::Index>(harmonics.size());
  if (count < 2 * (terms + 1) || harmonics.empty() || harmonics.front() != 1) {
    throw std::invalid_argument(fmt::format("{} samples, {} harmonics; needed: {} samples, harmonics that begin with 1",
                                            count, harmonics.size(), 2 * (terms + 1)));
  }
  const Eigen::Map<const Eigen::VectorXd> values(samples.data(), count);
  // Times from the middle: the phases and the frequency are then nearly uncorrelated.
  const double half = 0.5 * tau * static_cast<double>(count - 1);
  const Eigen::ArrayXd times = Eigen::ArrayXd::LinSpaced(count, -half, half);
  double frequency = first_guess(samples, tau);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(terms);
  double previous = std::numeric_limits<double>::infinity();
  constexpr int most_iterations = 60;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::MatrixXd columns = columns_of(times, frequency, harmonics, weights);
    const Eigen::VectorXd rest = values - columns.leftCols(terms) * weights;
    // The first time the waves alone: without them the series does not depend on Omega.
    const Eigen::Index unknowns = iteration == 0 ? terms : terms + 1;
    const Eigen::MatrixXd used = columns.leftCols(unknowns);
    const Eigen::MatrixXd normal = used.transpose() * used;
    const Eigen::VectorXd change = normal.ldlt().solve(used.transpose() * rest);
    weights += change.head(terms);
    if (iteration == 0) continue;
    frequency += change[terms];
    const double size = std::abs(change[terms]) / frequency;
    if (size <= std::numeric_limits<double>::epsilon() || (size < 1e-10 && size >= previous)) {
      const double amplitude = std::hypot(weights[1], weights[2]);
      return {frequency, amplitude, rest.norm() / (std::sqrt(static_cast<double>(count)) * amplitude)};
    }
    previous = size;
  }
  throw std::runtime_error(
      fmt::format("no oscillation near the frequency {:.6g} in {} samples over a time of {:g}: the fit does not settle",
                  frequency, count, 2 * half));
}

}  // namespace seiche::validation
