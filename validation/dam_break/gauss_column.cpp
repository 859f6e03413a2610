#include "validation/dam_break/gauss_column.hpp"

#include <memory>

#include <fmt/format.h>

#include "seiche/models/gauss_particles/spline_space.hpp"

namespace seiche::validation {

using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

std::string GaussColumn::resolution() const {
  return fmt::format("{} cells per width, {} particles per side", cells, per_cell);
}

gauss_particles::Flow GaussColumn::start() const {
  const auto across = static_cast<std::size_t>(cells * per_cell);
  const std::size_t up = across * static_cast<std::size_t>(aspect);
  gauss_particles::Particles particles = gauss_particles::layer({.end = 1,
                                                                 .columns = across,
                                                                 .rows = up,
                                                                 .surface = [this](double) { return aspect; },
                                                                 .bottom = [](double) { return 0.0; },
                                                                 .end_corrected = false,
                                                                 .markers = across + 1,
                                                                 .marker_at_end = true});
  for (std::size_t k = 1; k <= up; ++k) {
    particles.add(1, aspect * static_cast<double>(up - k) / static_cast<double>(up), 0);
  }
  return gauss_particles::Flow(
      std::move(particles),
      std::make_unique<SplineSpace>(LatticePlan{.cell_x = spacing(), .left_wall = 0.0, .bottom = true},
                                    SplineSpace::Settings{.inner_fraction = 0.3}),
      {}, {.gravity = 1, .penalty = 0.01});
}

}  // namespace seiche::validation
