/// A wave's surface between its nodes: the even function elevation(s) and the odd function x(s), symmetric about the
/// crest s = 0, from the sinc series on a line or the trigonometric series on a period.
///
/// Folding the nodes s_j and -s_j leaves one reciprocal per pair for all functions. The odd function is stored without
/// the part that does not decay (or is not periodic), which the caller adds.
///
/// References: Stenger, Numerical Methods Based on Sinc and Analytic Functions (1993); Berrut & Trefethen, Barycentric
/// Lagrange interpolation, SIAM Rev. 46 (2004) 501.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace seiche::exact {

struct SurfaceSample {
  double elevation = 0;     ///< even in s
  double displacement = 0;  ///< odd in s
  double stretch = 0;       ///< even in s: the derivative by which x(s) is inverted
};

/// On the nodes s_j = j spacing, j = 0..N, of functions that vanish beyond them.
class SincInterpolation {
 public:
  SincInterpolation() = default;
  SincInterpolation(double spacing, const Eigen::VectorXd& elevation, const Eigen::VectorXd& displacement,
                    const Eigen::VectorXd& stretch)
      : spacing_(spacing) {
    const Eigen::Index count = elevation.size();
    for (Eigen::Index j = 0; j < count; ++j) {
      const double sign = j % 2 == 0 ? 1 : -1;
      const double fold = j == 0 ? 0.5 : 1;
      elevation_.push_back(sign * fold * elevation[j]);
      displacement_.push_back(sign * static_cast<double>(j) * displacement[j]);
      stretch_.push_back(sign * fold * stretch[j]);
      position_.push_back(static_cast<double>(j));
    }
  }

  /// @param s  in [0, N spacing]
  [[nodiscard]] SurfaceSample at(double s) const {
    const double t = s / spacing_;
    const double nearest = std::round(t);
    const double offset = t - nearest;
    const double sign = std::fmod(nearest, 2) == 0 ? 1 : -1;
    if (std::abs(offset) < 1e-290) {
      const auto j = static_cast<std::size_t>(nearest);
      const double fold = sign * (j == 0 ? 2 : 1);
      return {fold * elevation_[j], j == 0 ? 0 : sign * displacement_[j] / nearest, fold * stretch_[j]};
    }
    double elevation = 0;
    double displacement = 0;
    double stretch = 0;
#pragma omp simd reduction(+ : elevation, displacement, stretch)
    for (std::size_t j = 0; j < position_.size(); ++j) {
      const double kernel = 1 / ((t - position_[j]) * (t + position_[j]));
      elevation += elevation_[j] * kernel;
      displacement += displacement_[j] * kernel;
      stretch += stretch_[j] * kernel;
    }
    const double factor = 2 * sign * std::sin(std::numbers::pi * offset) / std::numbers::pi;
    return {factor * t * elevation, factor * displacement, factor * t * stretch};
  }

 private:
  double spacing_ = 1;
  std::vector<double> elevation_, displacement_, stretch_, position_;
};

/// On the nodes s_j = pi j/N, j = 0..N, of 2 pi periodic functions: Lagrange's formula in the variable sin^2(s/2).
class TrigonometricInterpolation {
 public:
  TrigonometricInterpolation() = default;
  TrigonometricInterpolation(const Eigen::VectorXd& elevation, const Eigen::VectorXd& displacement,
                             const Eigen::VectorXd& stretch) {
    const Eigen::Index intervals = elevation.size() - 1;
    for (Eigen::Index j = 0; j <= intervals; ++j) {
      const double s = std::numbers::pi * static_cast<double>(j) / static_cast<double>(intervals);
      const double half = std::sin(0.5 * s);
      const double weight = (j % 2 == 0 ? 1 : -1) * (j == 0 || j == intervals ? 0.5 : 1.0);
      position_.push_back(half * half);
      weight_.push_back(weight);
      elevation_.push_back(weight * elevation[j]);
      displacement_.push_back(j == 0 || j == intervals ? 0 : weight * displacement[j] * std::sin(s));
      stretch_.push_back(weight * stretch[j]);
    }
  }

  /// @param s  in [0, pi]
  [[nodiscard]] SurfaceSample at(double s) const {
    const double half = std::sin(0.5 * s);
    const double position = half * half;
    double elevation = 0;
    double displacement = 0;
    double stretch = 0;
    double total = 0;
#pragma omp simd reduction(+ : elevation, displacement, stretch, total)
    for (std::size_t j = 0; j < position_.size(); ++j) {
      const double kernel = 1 / (position_[j] - position);
      total += weight_[j] * kernel;
      elevation += elevation_[j] * kernel;
      displacement += displacement_[j] * kernel;
      stretch += stretch_[j] * kernel;
    }
    if (!std::isfinite(total)) return at_node(position);
    const double sine = std::sin(s);
    return {elevation / total, sine > 0 ? displacement / (total * sine) : 0, stretch / total};
  }

 private:
  [[nodiscard]] SurfaceSample at_node(double position) const {
    std::size_t j = 0;
    while (position_[j] != position) ++j;
    const double sine = 2 * std::sqrt(position * (1 - position));
    return {elevation_[j] / weight_[j], sine > 0 ? displacement_[j] / (weight_[j] * sine) : 0,
            stretch_[j] / weight_[j]};
  }

  std::vector<double> position_, weight_, elevation_, displacement_, stretch_;
};

}  // namespace seiche::exact
