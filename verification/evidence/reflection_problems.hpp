/// Exact surfaces of the Kadomtsev-Petviashvili equation on lattices, for the measures of a reflection.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "seiche/exact/kadomtsev_petviashvili.hpp"
#include "validation/instruments/surface_lattice.hpp"

namespace seiche::verification {

/// A wave of amplitude a that meets the wall with the parameter kappa, in water of depth 1.
inline exact::KadomtsevPetviashvili reflection(double a, double kappa) {
  return {a, std::atan(kappa * std::sqrt(3 * a))};
}

/// Its surface at time t on a lattice that reaches `height` away from the wall.
class SampledReflection {
 public:
  /// @param disorder  nodes are displaced by up to this part of the spacing, those of the wall along it
  /// @param shift     of the lattice along the wall
  SampledReflection(const exact::KadomtsevPetviashvili& waves, double t, double height, double spacing,
                    double disorder = 0, double shift = 0) {
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
  std::size_t columns_;
  std::size_t rows_;
  std::vector<double> x_, y_, z_;
};

}  // namespace seiche::verification
