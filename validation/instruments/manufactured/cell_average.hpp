/// Averages of exact shallow-water solutions over cells, by Gauss quadrature split at the wave positions.
///
/// Ten points per smooth piece integrate polynomials up to degree 19 exactly: every fan of a Riemann problem (degree 2
/// in h, 3 in h u) to round-off, any solution that varies over several cells to better than 1e-14.
///
/// When not to use it: one cell over a solution with fine structure and no breakpoints (a whole simple wave in one
/// cell); divide the cell.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/shallow_water/relations.hpp"

namespace seiche::validation {

/// A solution of the shallow-water equations: state at a point and an instant.
template <class S>
concept ShallowWaterSolution = requires(const S& solution, double x, double t) {
  { solution.at(x, t) } -> std::same_as<shallow_water::State>;
};

/// A solution that knows where it has jumps or corners, in increasing order.
template <class S>
concept HasBreakpoints = requires(const S& solution, double t) {
  { solution.breakpoints(t) } -> std::convertible_to<std::vector<double>>;
};

/// Mean depth [m] and mean discharge h u [m^2/s] of a cell.
struct CellMean {
  double depth = 0;
  double discharge = 0;

  /// Velocity of the water in the cell: discharge over depth [m/s]; 0 in a dry cell.
  [[nodiscard]] double velocity() const { return depth > 0 ? discharge / depth : 0.0; }
};

namespace detail {

template <ShallowWaterSolution S>
CellMean mean_between(const S& solution, double a, double b, double t, const std::vector<double>& breakpoints) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  CellMean total;
  const auto add_piece = [&](double from, double to) {
    const double centre = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    const auto add_point = [&](double x, double weight) {
      const shallow_water::State state = solution.at(x, t);
      total.depth += half * weight * state.depth;
      total.discharge += half * weight * state.depth * state.velocity;
    };
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      const double offset = half * Rule::abscissa()[k];
      add_point(centre - offset, Rule::weights()[k]);
      add_point(centre + offset, Rule::weights()[k]);
    }
  };
  double from = a;
  for (auto p = std::upper_bound(breakpoints.begin(), breakpoints.end(), a); p != breakpoints.end() && *p < b; ++p) {
    if (*p > from) add_piece(from, *p);
    from = *p;
  }
  add_piece(from, b);
  return {total.depth / (b - a), total.discharge / (b - a)};
}

template <ShallowWaterSolution S>
std::vector<double> breakpoints_of(const S& solution, double t) {
  if constexpr (HasBreakpoints<S>) {
    return solution.breakpoints(t);
  } else {
    return {};
  }
}

}  // namespace detail

/// Mean of the solution over [a, b], a < b, at time t.
template <ShallowWaterSolution S>
CellMean cell_average(const S& solution, double a, double b, double t) {
  return detail::mean_between(solution, a, b, t, detail::breakpoints_of(solution, t));
}

/// Means over the cells between consecutive edges (increasing): one fewer than there are edges.
template <ShallowWaterSolution S>
std::vector<CellMean> cell_averages(const S& solution, const std::vector<double>& edges, double t) {
  const std::vector<double> breakpoints = detail::breakpoints_of(solution, t);
  std::vector<CellMean> means;
  means.reserve(edges.size());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    means.push_back(detail::mean_between(solution, edges[i], edges[i + 1], t, breakpoints));
  }
  return means;
}

}  // namespace seiche::validation
