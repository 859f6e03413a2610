/// A column of water at a wall over a dry bed, by free particles under Gauss's principle. Its width, gravity and
/// density are 1.
#pragma once

#include <cmath>
#include <string>

#include "seiche/models/gauss_particles/flow.hpp"

namespace seiche::validation {

struct GaussColumn {
  double aspect = 2;  ///< height over width, n^2
  long cells = 8;     ///< to the width
  long per_cell = 10;

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(cells); }
  [[nodiscard]] double tau() const { return 0.16 * spacing(); }
  [[nodiscard]] double unit() const { return std::sqrt(aspect); }  ///< T/t
  [[nodiscard]] double energy() const { return aspect * aspect / 2; }
  /// "8 cells to the width, 10 particles to a side".
  [[nodiscard]] std::string resolution() const;
  /// At rest. Markers go from the wall along the top and down the front.
  [[nodiscard]] gauss_particles::Flow start() const;
};

}  // namespace seiche::validation
