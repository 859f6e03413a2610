#include "validation/run_up/solitary_climb.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "validation/instruments/peak.hpp"

namespace seiche::validation {

using dispersive::Channel;
using dispersive::End;

namespace {

constexpr double margin = 1e-4;      // of the wave's height, beyond the toe and at the far wall
constexpr double highest_land = 20;  // as far as the slope goes
constexpr double courant = 0.3;      // of the longest stable step
constexpr double fallen = 0.9;       // of the highest: it was the maximum

}  // namespace

double SolitaryClimb::reach(double fraction) const {
  return std::acosh(std::sqrt(1 / fraction)) / std::sqrt(0.75 * amplitude);
}

double SolitaryClimb::crest() const {
  return -cot_slope - reach(margin);
}

dispersive::Flow SolitaryClimb::start() const {
  const double wall = crest() - reach(margin);
  const double beyond = wall - 1 - reach(margin);
  Channel channel{
      .left = End::wall, .right = cot_slope > 0 ? End::tip : End::wall, .kinetics = kinetics, .tip_mass = tip_mass};
  channel.friction = friction;
  channel.breaking = breaking;
  if (cot_slope > 0) {
    channel.bottom = std::make_shared<PiecewiseLinearBottom>(
        std::vector{beyond, -cot_slope, 0.0, highest_land * cot_slope}, std::vector{-1.0, -1.0, 0.0, highest_land});
  } else {
    channel.bottom = std::make_shared<LevelBottom>(1.0);
  }
  return {channel, solitary_markers(channel, wall, 0, spacing, {.amplitude = amplitude, .crest = crest()}), scheme};
}

double SolitaryClimb::step(const dispersive::Flow& flow) const {
  return std::min(tau_over_spacing * spacing, courant * flow.stable_step());
}

void SolitaryClimb::advance_to(dispersive::Flow& flow, double time) const {
  march(flow, time, stable_steps(flow, tau_over_spacing * spacing, courant));
}

std::string SolitaryClimb::resolution() const {
  return fmt::format("h = {:g}, tau = {:g} h", spacing, tau_over_spacing);
}

RunUp run_up(const SolitaryClimb& climb, const std::function<void(const dispersive::Flow&)>& after_step,
             double latest) {
  dispersive::Flow flow = climb.start();
  RunUp run;
  Peak edge;
  edge.add(flow.time(), flow.y().back());
  // The water's edge rises above the wave's own height: what was before was not the run-up.
  const auto fell = [&] { return edge.value() > climb.amplitude && flow.y().back() < fallen * edge.value(); };
  while (flow.time() < latest && !fell()) {
    flow.advance(climb.step(flow));
    edge.add(flow.time(), flow.y().back());
    run.times.push_back(flow.time());
    run.levels.push_back(flow.y().back());
    if (after_step) after_step(flow);
  }
  if (fell()) {
    run.height = edge.value();
    run.time = edge.time();
  }
  return run;
}

RunUpSequence run_ups(SolitaryClimb climb, const std::vector<double>& spacings) {
  RunUpSequence sequence;
  for (const double spacing : spacings) {
    climb.spacing = spacing;
    sequence.add(spacing, run_up(climb).height);
  }
  return sequence;
}

Parameter scheme_parameter() {
  return choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"},
                "time stepping; the first is Frank's");
}

std::vector<Parameter> step_parameters() {
  return {real("tau_over_h", 0.25, "1", {1e-3, 2}, "time step over the spacing; shorter steps in shallow water"),
          scheme_parameter()};
}

std::vector<Parameter> climb_parameters(ByTier<double> spacing) {
  return joined({{real("h", spacing, "depth", {1e-3, 1}, "node spacing at rest")}, step_parameters()});
}

std::vector<Parameter> slope_parameters() {
  return {
      choice("tip_mass", "elementary", {"elementary", "consistent"},
             "mass of the shoreline node: V/4 of its triangle, as in Frank's thesis, or V/6, which converges faster"),
      choice("kinetics", "frank", {"frank", "green_naghdi"},
             "kinetic energy over a slope: Frank's, or Green and Naghdi's"),
  };
}

SolitaryClimb climb_from(const Values& values, double cot_slope, double amplitude, std::optional<double> spacing) {
  SolitaryClimb climb{.cot_slope = cot_slope, .amplitude = amplitude};
  for (const Parameter& one : values.declared()) {
    if (one.name == "h") climb.spacing = values.real(one.name);
    if (one.name == "tau_over_h") climb.tau_over_spacing = values.real(one.name);
    if (one.name == "scheme") climb.scheme.stepping = dispersive::stepping_named(values.text(one.name));
    if (one.name == "tip_mass" && values.text(one.name) == "consistent") {
      climb.tip_mass = dispersive::TipMass::consistent;
    }
    if (one.name == "kinetics" && values.text(one.name) == "green_naghdi") {
      climb.kinetics = dispersive::Kinetics::green_naghdi;
    }
  }
  climb.spacing = spacing.value_or(climb.spacing);
  return climb;
}

std::vector<Parameter> joined(std::vector<std::vector<Parameter>> lists) {
  std::vector<Parameter> all;
  for (std::vector<Parameter>& list : lists) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

double runup_law(double cot_slope, double amplitude) {
  return 2.831 * std::sqrt(cot_slope) * std::pow(amplitude, 1.25);
}

double backwash_limit(double cot_slope) {
  return 0.479 * std::pow(cot_slope, -10.0 / 9);
}

}  // namespace seiche::validation
