/// A solitary wave climbs a plane slope or a wall: set-up and run-up by the discrete dispersive shallow-water model.
///
/// Units: the depth before the slope and gravity are 1. The slope's toe is at x = -cot, still water ends at x = 0;
/// water that is to climb a vertical wall ends there at a depth of 1 (cot = 0). Serre's wave starts where all but 1e-4
/// of its height is before the toe, with as much room behind it.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/grid_convergence.hpp"
#include "reports/evidence/record.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {

namespace dispersive = dispersive_shallow_water_1d;

struct SolitaryClimb {
  double cot_slope = 10;  ///< 0 is a vertical wall
  double amplitude = 0.03;
  double spacing = 0.25;  ///< of markers at rest
  double tau_over_spacing = 0.25;
  dispersive::TipMass tip_mass = dispersive::TipMass::elementary;
  dispersive::Kinetics kinetics = dispersive::Kinetics::frank;
  dispersive::Scheme scheme = {};
  dispersive::Friction friction = {};
  std::optional<dispersive::Breaking> breaking = {};

  /// Distance from the crest at which the wave has fallen to `fraction` of its height, by Boussinesq's profile
  /// sech^2(sqrt(3A/4) x), as experimenters count it.
  [[nodiscard]] double reach(double fraction) const;
  /// Place of the crest at the start.
  [[nodiscard]] double crest() const;
  /// From the start until the crest of the undisturbed wave is at x.
  [[nodiscard]] double time_to(double x) const { return (x - crest()) / exact::SerreSolitary(amplitude).speed(); }
  [[nodiscard]] dispersive::Flow start() const;
  /// The next step: tau_over_spacing * spacing, or less where the water is shallow.
  [[nodiscard]] double step(const dispersive::Flow& flow) const;
  /// Steps until `time`, which is hit exactly.
  void advance_to(dispersive::Flow& flow, double time) const;
  /// "h = 0.25, tau = h/4".
  [[nodiscard]] std::string resolution() const;
};

struct RunUp {
  /// Highest the water's edge gets before it falls again, and when, since the start; NaN if it was still rising.
  double height = std::numeric_limits<double>::quiet_NaN();
  double time = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> times = {}, levels = {};  ///< of the water's edge, after every step

  /// The times, less an origin.
  [[nodiscard]] std::vector<double> since(double origin) const {
    return each(times, [origin](double t) { return t - origin; });
  }
};

/// Runs until the water's edge has fallen to 0.9 of its highest, or to a latest time. Throws Divergence.
RunUp run_up(const SolitaryClimb& climb, const std::function<void(const dispersive::Flow&)>& after_step = {},
             double latest = 1e4);

/// Run-ups with several spacings.
struct RunUpSequence {
  std::vector<double> spacing = {}, height = {};

  void add(double h, double reached) {
    spacing.push_back(h);
    height.push_back(reached);
  }
  [[nodiscard]] evidence::GridConvergence limit() const { return evidence::grid_convergence(spacing, height, 2); }
};
RunUpSequence run_ups(SolitaryClimb climb, const std::vector<double>& spacings);

/// Parameters that choose the method: spacing and, of the steps, tau_over_spacing and scheme; over slopes tip_mass and
/// kinetics.
std::vector<Parameter> climb_parameters(ByTier<double> spacing);
std::vector<Parameter> step_parameters();
Parameter scheme_parameter();
std::vector<Parameter> slope_parameters();
/// A climb with those of them that the case has. @param spacing  instead of its own
SolitaryClimb climb_from(const Values& values, double cot_slope, double amplitude, std::optional<double> spacing = {});

/// Joins lists of parameters.
std::vector<Parameter> joined(std::vector<std::vector<Parameter>> lists);

/// Synolakis (1987): run-up law 2.831 sqrt(cot) A^(5/4), and the amplitude above which the water breaks as it runs
/// back, 0.479 cot^(-10/9).
double runup_law(double cot_slope, double amplitude);
double backwash_limit(double cot_slope);

}  // namespace seiche::validation
