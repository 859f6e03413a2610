#include "seiche/exact/lagrangian_mesh_dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/frank_dispersion.hpp"
#include "seiche/exact/layer_response.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<LagrangianMeshDispersion>);

namespace {

/// (2 + cos k h1)/3.
double potential_factor(double phase) {
  return (2 + std::cos(phase)) / 3;
}

}  // namespace

LagrangianMeshDispersion::LagrangianMeshDispersion(double gravity, double depth, double column_width, std::size_t rows,
                                                   SurfaceInertia inertia)
    : gravity_(gravity), depth_(depth), column_width_(column_width), rows_(rows) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("column_width", column_width);
  require_at_least("rows", static_cast<long>(rows), 1);
  inertia_ = 0.5 - (inertia == SurfaceInertia::tuned ? 1 / (6 * static_cast<double>(rows)) : 0.0);
}

void LagrangianMeshDispersion::require_resolved(double wavenumber) const {
  require_positive("wavenumber", wavenumber);
  require_within("wavenumber", wavenumber, 0, std::numbers::pi / column_width_ * (1 + 1e-15));
}

double LagrangianMeshDispersion::response_of_rows(double wavenumber) const {
  const double half_phase = 0.5 * wavenumber * column_width_;
  const double sine = row_height() * std::sin(half_phase);
  const double cosine = column_width_ * std::abs(std::cos(half_phase));  // beyond pi by a rounding it is negative
  return layer_response(sine, cosine, rows_, inertia_);
}

double LagrangianMeshDispersion::frequency(double wavenumber) const {
  require_resolved(wavenumber);
  return std::sqrt(2 * gravity_ / row_height() * potential_factor(wavenumber * column_width_) *
                   response_of_rows(wavenumber));
}

double LagrangianMeshDispersion::phase_speed(double wavenumber) const {
  return frequency(wavenumber) / wavenumber;
}

double LagrangianMeshDispersion::surface_response(double wavenumber) const {
  require_resolved(wavenumber);
  return 2 * inertia_ * response_of_rows(wavenumber);
}

double LagrangianMeshDispersion::largest_frequency() const {
  constexpr int samples = 2000;
  Largest largest;
  for (int i = 1; i <= samples; ++i) {
    largest.add(frequency(std::numbers::pi / column_width_ * i / samples));
  }
  return largest.value();
}

Provenance LagrangianMeshDispersion::provenance() {
  return {"Frank, Discrete models of incompressible fluid (1994), ch. 2; closed form derived from the linearised rows",
          "omega^2 = (2g/h2) ((2 + cos k h1)/3) T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n), "
          "T = (h2/h1) tan(k h1/2), t_n = tanh(2 n artanh T), h2 = H/n, b = 1/2 or 1/2 - 1/(6n)"};
}

double LagrangianMeshDispersion::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

double LagrangianMeshDispersion::by_recurrence(double wavenumber) const {
  const double half_phase = 0.5 * wavenumber * column_width_;
  return std::sqrt(2 * gravity_ / row_height() * potential_factor(wavenumber * column_width_) *
                   layer_response_by_rows(row_height() * std::sin(half_phase),
                                          column_width_ * std::abs(std::cos(half_phase)), rows_, inertia_));
}

SelfTest LagrangianMeshDispersion::self_test() const {
  const double shortest = std::numbers::pi / column_width_;
  const auto inertia = inertia_ < 0.5 ? SurfaceInertia::tuned : SurfaceInertia::nodal;
  const LagrangianMeshDispersion one_row(gravity_, depth_, column_width_, 1, inertia);
  const FrankDispersion markers(gravity_, depth_, column_width_,
                                {.alpha = one_row.inertia_, .beta = 1.0 / 3, .gamma = 0});
  Worst rows_defect;
  Worst markers_defect;
  constexpr int waves = 16;
  for (int i = 1; i < waves; ++i) {
    const double part = static_cast<double>(i) / waves;
    rows_defect.add(by_recurrence(part * shortest) / frequency(part * shortest) - 1);
    markers_defect.add(one_row.frequency(part * shortest) / markers.frequency(part * shortest) - 1);
  }
  const double shortest_frequency = std::sqrt(gravity_ / (3 * inertia_ * row_height()));
  const double longest = 1e-9 / std::max(depth_, column_width_);
  return {{"frequency from the rows one by one", rows_defect.value(),
           std::numeric_limits<double>::epsilon() * (20 + 1.5 * static_cast<double>(rows_)),
           "half an ulp for each of 20 roundings in either formula; 6 more per row, under the root"},
          {"one row: formula (13) with alpha = b", markers_defect.value(), 2e-14,
           "90 ulp: 40 roundings, the shortest of the waves makes a rounding of the phase ten of the tangent"},
          {"shortest wave: omega^2 = g/(3 b h2)", std::abs(frequency(shortest) / shortest_frequency - 1),
           4e-15 + std::pow(std::numeric_limits<double>::epsilon() * column_width_ / row_height(), 2),
           "18 ulp for as many roundings; the law is stationary there in 1/T, which is 0 to a rounding of pi h1/h2"},
          {"long waves: omega = k sqrt(g H)", std::abs(phase_speed(longest) / std::sqrt(gravity_ * depth_) - 1), 4e-15,
           "18 ulp for as many roundings; the next term of the law is 1e-18"}};
}

}  // namespace seiche::exact
