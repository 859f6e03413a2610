/// The run-ups on plane slopes that the two-dimensional Lagrangian mesh is judged by, and its own, on a sequence of
/// meshes.
///
/// Units: depth and gravity are 1.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "seiche/samples.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::slope_run_ups {

struct MeshSize {
  double spacing;
  long rows;
  double tau;
};
constexpr std::array<MeshSize, 4> meshes{{{1, 2, 0.05}, {0.5, 4, 0.05}, {0.25, 8, 0.025}, {0.125, 16, 0.0125}}};
constexpr std::size_t compared = 3;  // meshes of all tiers

/// A row of the comparison, with what is known of it.
struct Row {
  double cot_slope = 0;
  double amplitude = 0;
  double thesis = std::numeric_limits<double>::quiet_NaN();
  double exact = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] double formula() const;  ///< of Hall and Watts
};

/// Of the tables that the case declares.
std::vector<Row> rows_of(const Values& values);

struct Climbed : Row {
  std::vector<double> runup;        ///< on the meshes
  std::optional<double> fold_time;  ///< first fold on the finest mesh with one before the largest run-up
  std::vector<double> sliding;      ///< run-up with a toe that slides, on the meshes
  Count sliding_folds;              ///< of them those with a fold before it
  Worst sliding_energy;             ///< largest change over the wave's energy

  /// To zero spacing, first order; from the two finest meshes but `coarser`.
  [[nodiscard]] double extrapolated(std::size_t coarser = 0) const;
  /// What the sliding toe changes on the finest mesh, over what the last halving of the cells changes with either toe.
  [[nodiscard]] double toe_matters() const;
  /// Of the finest mesh's run-up; infinite where the meshes do not tell.
  [[nodiscard]] double mesh_uncertainty() const;
  /// Of the difference from the exact run-up, from the last halving.
  [[nodiscard]] double order_of_error() const;
  /// From the last two halvings.
  [[nodiscard]] double order() const;
};

/// Climbs the slope on as many of the meshes, with a toe that stays and with one that slides.
Climbed climb_row(const Row& row, std::size_t levels);

}  // namespace seiche::validation::slope_run_ups
