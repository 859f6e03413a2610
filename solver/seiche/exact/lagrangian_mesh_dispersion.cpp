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
  const double cosine = column_width_ * std::cos(half_phase);
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

/// The frequency without the closed form: multipliers L_j row by row from the bottom, whose differences d_j obey
/// d_{j+1} = d_j + 4 T^2/(1 - T^2) L_j, then the constraint of the top row, X = 4 T^2 + (1 - T^2) d/L at the top, and
/// the motion of the surface, omega^2 = (g/h2) ((2 + cos k h1)/3) X/(1 + b X).
double LagrangianMeshDispersion::by_recurrence(double wavenumber) const {
  const double t = row_height() / column_width_ * std::tan(0.5 * wavenumber * column_width_);
  double level = 1;
  double difference = 0;
  for (std::size_t j = 1; j < rows_; ++j) {
    difference += 4 * t * t / (1 - t * t) * level;
    level += difference;
  }
  const double x = 4 * t * t + (1 - t * t) * difference / level;
  return std::sqrt(gravity_ / row_height() * potential_factor(wavenumber * column_width_) * x / (1 + inertia_ * x));
}

SelfTest LagrangianMeshDispersion::self_test() const {
  const double shortest = std::numbers::pi / column_width_;
  // Waves with T <= 1/2, for which the recurrence only adds.
  const double resolved = 2 / column_width_ * std::atan(0.5 * column_width_ / row_height());
  const auto inertia = inertia_ < 0.5 ? SurfaceInertia::tuned : SurfaceInertia::nodal;
  const LagrangianMeshDispersion one_row(gravity_, depth_, column_width_, 1, inertia);
  const FrankDispersion markers(gravity_, depth_, column_width_,
                                {.alpha = one_row.inertia_, .beta = 1.0 / 3, .gamma = 0});
  Worst rows_defect;
  Worst markers_defect;
  constexpr int waves = 16;
  for (int i = 1; i < waves; ++i) {
    const double part = static_cast<double>(i) / waves;
    rows_defect.add(by_recurrence(part * resolved) / frequency(part * resolved) - 1);
    markers_defect.add(one_row.frequency(part * shortest) / markers.frequency(part * shortest) - 1);
  }
  const double shortest_frequency = std::sqrt(gravity_ / (3 * inertia_ * row_height()));
  const double longest = 1e-9 / std::max(depth_, column_width_);
  return {{"frequency from the rows one by one", rows_defect.value(),
           std::numeric_limits<double>::epsilon() * static_cast<double>(16 + rows_),
           "half an ulp for each of 16 roundings in either formula; 4 more per row, under the root"},
          {"one row: formula (13) with alpha = b", markers_defect.value(), 2e-14,
           "90 ulp: 40 roundings, the shortest of the waves makes a rounding of the phase ten of the tangent"},
          {"shortest wave: omega^2 = g/(3 b h2)", std::abs(frequency(shortest) / shortest_frequency - 1), 4e-15,
           "18 ulp for as many roundings"},
          {"long waves: omega = k sqrt(g H)", std::abs(phase_speed(longest) / std::sqrt(gravity_ * depth_) - 1), 4e-15,
           "18 ulp for as many roundings; the next term of the law is 1e-18"}};
}

}  // namespace seiche::exact
