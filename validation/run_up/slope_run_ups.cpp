#include "validation/run_up/slope_run_ups.hpp"

#include <algorithm>
#include <cmath>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/solitary_runup.hpp"
#include "validation/run_up/mesh_slope_climb.hpp"

namespace seiche::validation::slope_run_ups {
namespace {

/// The number of a table at a slope and an amplitude; NaN where there is none.
double entry(const io::Table& table, const std::string& column, const Row& row) {
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.column("cot_slope")[k] == row.cot_slope && table.column("A")[k] == row.amplitude) {
      return table.column(column)[k];
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Before the largest run-up.
bool folds(const MeshSlopeRun& run) {
  return run.fold && run.fold->time < run.time;
}

MeshSlopeClimb with_sliding_toe(MeshSlopeClimb climb) {
  climb.rounding = 1;
  climb.hourglass = 0.1;
  climb.scheme.stepping = mechanics::Stepping::conservative;
  return climb;
}

}  // namespace

double Row::formula() const {
  return exact::HallWatts(1, 1 / cot_slope).runup(amplitude);
}

std::vector<Row> rows_of(const Values& values) {
  const io::Table thesis = values.table("frank_1994_runup");
  const io::Table exact = values.table("slope_runup_exact");
  std::vector<Row> rows;
  for (std::size_t k = 0; k < exact.rows(); ++k) {
    Row& row = rows.emplace_back(Row{
        .cot_slope = exact.column("cot_slope")[k], .amplitude = exact.column("A")[k], .exact = exact.column("R")[k]});
    row.thesis = entry(thesis, "R_calc", row);
  }
  return rows;
}

double Climbed::extrapolated(std::size_t coarser) const {
  const std::size_t n = runup.size() - coarser;
  return 2 * runup[n - 1] - runup[n - 2];
}

double Climbed::toe_matters() const {
  const std::size_t n = runup.size();
  const double left = std::abs(runup[n - 1] - runup[n - 2]) + std::abs(sliding[n - 1] - sliding[n - 2]);
  return (sliding[n - 1] - runup[n - 1]) / left;
}

double Climbed::mesh_uncertainty() const {
  std::vector<double> spacings;
  for (std::size_t m = 0; m < runup.size(); ++m) spacings.push_back(meshes[m].spacing);
  return evidence::grid_convergence(spacings, runup, 1).uncertainty;
}

double Climbed::order_of_error() const {
  return std::log2(std::abs(runup[runup.size() - 2] - exact) / std::abs(runup.back() - exact));
}

double Climbed::order() const {
  const std::size_t n = runup.size();
  return std::log2((runup[n - 2] - runup[n - 3]) / (runup[n - 1] - runup[n - 2]));
}

Climbed climb_row(const Row& row, std::size_t levels) {
  const exact::SolitaryWave wave(row.amplitude);
  Climbed climbed{row, {}, {}, {}, {}, {}};
  for (std::size_t level = 0; level < levels; ++level) {
    const MeshSize& mesh = meshes[level];
    const MeshSlopeClimb climb{
        .wave = wave, .tan_slope = 1 / row.cot_slope, .spacing = mesh.spacing, .rows = mesh.rows, .tau = mesh.tau};
    const MeshSlopeRun result = climb_slope(climb);
    climbed.runup.push_back(result.runup);
    if (folds(result)) climbed.fold_time = result.fold->time;
    const MeshSlopeRun sliding = climb_slope(with_sliding_toe(climb));
    climbed.sliding.push_back(sliding.runup);
    climbed.sliding_folds.add(sliding.runup, [&](double) { return folds(sliding); });
    climbed.sliding_energy.add(sliding.energy_defect.value());
  }
  return climbed;
}

}  // namespace seiche::validation::slope_run_ups
