/// Depth and velocity at points along a channel, joined by straight lines: what others submit of a shallow-water flow,
/// and how far it is from the exact one, whatever the number of points.
#pragma once

#include <functional>
#include <vector>

#include "validation/case/submission.hpp"
#include "validation/studies/shallow_water/flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// x is strictly increasing.
struct ProfilePoints : ProfileCurve {
  /// The same as cells around the points.
  [[nodiscard]] Profile cells() const;
  /// Mean distance of neighbours.
  [[nodiscard]] double apart() const { return (x.back() - x.front()) / static_cast<double>(x.size() - 1); }
  [[nodiscard]] bool cover(double place) const { return place >= x.front() && place <= x.back(); }
};

/// The table of points that is asked for: depth h and velocity u at the centres of so many cells of a channel.
/// @param exact  state at a place [m]
/// @param command  prints the reference
WantedTable wanted_profile(double start, double end, long cells, const std::function<State(double)>& exact,
                           const std::string& command);

/// Means of a flow of our own at the centres, as others would submit them.
ProfilePoints points_of(const Profile& profile);
Submitted submitted_profile(const Profile& profile);

/// The submitted points, NaN for a quantity that was not submitted. @throws std::invalid_argument where they lie
/// outside the channel, or farther apart than two cells: such points show less than the solver knows, and cannot be
/// judged for it
ProfilePoints submitted_points(const Submitted& submitted, double start, double end, double cell);

/// Size of the cells that limits are for: the solver's own; where it does not say, the mean distance of its points, and
/// at most as large as with as many cells over the channel as the case asks for.
/// @throws std::invalid_argument for cells of more than a quarter of the channel
double judged_cell(const Submitted& submitted, double length, long cells, const SolverFacts& facts);

/// "cells of 0.125 m, as the points are apart (--dx says otherwise), 400 points".
std::string resolution_of(const ProfilePoints& points, double cell, const SolverFacts& facts);

/// Means over the length that the points cover, of so many samples between two points.
struct MeanErrors {
  double depth = 0;      ///< of |h - exact| [m]
  double velocity = 0;   ///< of |u - exact| where the exact bed is wet [m/s]
  double discharge = 0;  ///< of |h u - exact| [m^2/s]
};
MeanErrors mean_errors(const ProfilePoints& points, const std::function<State(double)>& exact, int samples = 16);

}  // namespace seiche::validation
