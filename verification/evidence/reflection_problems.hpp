/// Exact surfaces of the Kadomtsev-Petviashvili equation on lattices, for the measures of a reflection.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "validation/instruments/plan/surface_lattice.hpp"

namespace seiche::verification {

/// A solitary wave that meets the wall y = 0 with the parameter kappa = tan(psi)/S, S = sqrt(3 a), in water of depth 1
/// and celerity 1:
///
///     eta = (4/3) (ln tau)_XX,  tau = sum C_ij e_i e_j,  e_j = exp(k_j X + k_j^2 y - k_j^3 T),  X = x - t, T = 2 t/3,
///
/// with K = S (1 + kappa)/2 and q = S (1 - kappa)/2. Below kappa = 1 a stem of (1 + kappa)^2 a grows at the wall. The
/// second derivative is the variance of k_i + k_j under the weights C_ij e_i e_j/tau.
///
/// Source: Kodama and Yeh, The KP theory and Mach reflection, J. Fluid Mech. 800 (2016) 766.
class ExactReflection {
 public:
  /// Far from the others: x = offset + lean y + speed t.
  struct Crest {
    double amplitude, lean, speed, offset;

    [[nodiscard]] double at(double y, double t) const { return offset + lean * y + speed * t; }
    [[nodiscard]] double angle() const { return std::atan(std::abs(lean)); }
  };

  ExactReflection(double a, double kappa)
      : stem_(kappa < 1), outer_(0.5 * (1 + kappa) * std::sqrt(3 * a)), inner_(0.5 * (1 - kappa) * std::sqrt(3 * a)) {
    const double K = outer_, q = inner_;
    const double coupling = stem_ ? 1 - kappa * kappa : std::sqrt(1 - 1 / (kappa * kappa));
    const double shift = stem_ ? 0 : std::log(coupling) / std::sqrt(3 * a);
    if (stem_) {
      terms_ = {product(-K, q), product(-K, K), product(q, K), product(-q, q), product(-q, K, 1 / coupling)};
    } else {
      terms_ = {product(-K, -q), product(q, K), product(-K, K, coupling), product(q, -q, coupling)};
    }
    incident_ = crest(-K, q, shift);
    reflected_ = crest(std::abs(q), K, -shift);
    wall_ = crest(-K, stem_ ? K : q, 0);
    wall_.lean = 0;
  }

  [[nodiscard]] double elevation(double x, double y, double t) const {
    std::vector<double> weights;
    for (const Term& e : terms_) weights.push_back(e.in_x * (x - t) + e.in_y * y + e.in_t * t / 1.5);
    const double largest = *std::max_element(weights.begin(), weights.end());
    double tau = 0, mean = 0;
    for (std::size_t m = 0; m < terms_.size(); ++m) {
      weights[m] = terms_[m].constant * std::exp(weights[m] - largest);
      tau += weights[m];
      mean += weights[m] * terms_[m].in_x;
    }
    mean /= tau;
    double variance = 0;
    for (std::size_t m = 0; m < terms_.size(); ++m) {
      variance += weights[m] / tau * (terms_[m].in_x - mean) * (terms_[m].in_x - mean);
    }
    return 4 * variance / 3;
  }

  [[nodiscard]] bool has_stem() const { return stem_; }
  [[nodiscard]] const Crest& incident() const { return incident_; }
  [[nodiscard]] const Crest& reflected() const { return reflected_; }
  [[nodiscard]] const Crest& wall() const { return wall_; }
  /// How fast the stem's end leaves the wall.
  [[nodiscard]] double stem_growth() const { return inner_ / 1.5; }
  /// Rate at which the stem reaches its height.
  [[nodiscard]] double settling_rate() const { return inner_ * (outer_ * outer_ - inner_ * inner_) / 1.5; }

 private:
  struct Term {
    double in_x, in_y, in_t, constant;
  };

  static Term product(double k_i, double k_j, double constant = 1) {
    return {k_i + k_j, k_i * k_i + k_j * k_j, -(k_i * k_i * k_i + k_j * k_j * k_j), constant};
  }
  static Crest crest(double k_i, double k_j, double shift) {
    return {(k_j - k_i) * (k_j - k_i) / 3, -(k_i + k_j), 1 + (k_i * k_i + k_i * k_j + k_j * k_j) / 1.5, shift};
  }

  bool stem_;
  double outer_, inner_;  // K, q
  std::vector<Term> terms_;
  Crest incident_, reflected_, wall_;
};

/// Its surface at time t on a lattice that reaches `height` away from the wall.
class SampledReflection {
 public:
  /// @param disorder  nodes are displaced by up to this part of the spacing, those of the wall along it
  /// @param shift     of the lattice along the wall
  SampledReflection(const ExactReflection& waves, double t, double height, double spacing, double disorder = 0,
                    double shift = 0) {
    // Behind the wall's crest there is room for the reflected one; no crest falls on a node.
    const double margin = 40.3;
    const double begin = waves.wall().at(0, t) - margin + shift;
    columns_ = static_cast<std::size_t>((waves.incident().at(height, t) + 0.4 * margin - begin) / spacing);
    rows_ = static_cast<std::size_t>(height / spacing);
    std::mt19937 random(20100621);
    std::uniform_real_distribution<double> displacement(-disorder * spacing, disorder * spacing);
    for (std::size_t j = 0; j <= rows_; ++j) {
      for (std::size_t i = 0; i <= columns_; ++i) {
        x_.push_back(begin + spacing * static_cast<double>(i) + displacement(random));
        y_.push_back(spacing * static_cast<double>(j) + (j > 0 ? displacement(random) : 0));
        z_.push_back(waves.elevation(x_.back(), y_.back(), t));
      }
    }
  }

  [[nodiscard]] validation::SurfaceLattice lattice() const { return {columns_, rows_, x_, y_, z_}; }

 private:
  std::size_t columns_, rows_;
  std::vector<double> x_, y_, z_;
};

}  // namespace seiche::verification
