/*
Steady flow over a parabolic bump, $z = 0.2 - 0.05 (x - 10)^2$ on $8 < x < 12$ m, in a channel of 25 m. Bernoulli's law
gives the depth,

$$\frac{q^2}{2 g h^2} + h + z = E,$$

in three regimes: subcritical ($q = 4.42$ m²/s, depth 2 m at the outflow), transcritical without a jump (1.53) and with
one (0.18, 0.33 m).

The ends are fixed sections: the water enters at $q$ and leaves at the given depth (or freely, where supercritical), so
that particles are created at one end and removed at the other. Instants differ: errors are means over the last fifth of
the time.

**What is compared.** Depth, and the discharge, uniform in steady flow; beside them the fixed-grid comparison scheme
with hydrostatic reconstruction.

**Your solver.** One regime at a time (`--set regime=jump`; default `subcritical`): depth and velocity of the settled
flow are evaluated by the depth, the discharge and the position of the jump.

**What to look at.** The discharge, which shows errors that the depth hides. Smooth flow converges at second order,
transcritical flow too once the particles, which lengthen as the water becomes shallow, resolve the bump: from 50 on. At
a jump the method is first-order at best, and only with many particles: on the bump the water of the jump is a sixth as
deep as at the outflow, particles are six times as long, and each disturbs the flow as it passes through the jump.
*/
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/score.hpp"
#include "validation/steady_flow/judged_steady_flow.hpp"
#include "validation/steady_flow/settled_flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"
#include "validation/studies/shallow_water/profile_points.hpp"

namespace seiche::validation::cases::steady_bump {

/// A regime: its exact solution, discharge, and the depth given at the outflow (none where it is supercritical).
struct Regime {
  std::string name;
  long coarseness;  ///< its numbers of particles over those of the parameters
  exact::SteadyBump flow;
  std::optional<double> outflow_depth;
  double start_level;  ///< surface at t = 0, upstream of the crest at least [m]
  std::optional<double> start_depth_downstream;

  /// Depth at t = 0. A supercritical outflow gives nothing to the flow that could pull it down: it has to start so.
  [[nodiscard]] double start_depth(double x) const {
    if (start_depth_downstream && x > flow.bump().crest) return *start_depth_downstream;
    return start_level - flow.elevation(x);
  }
};

Regime regime_from(const std::string& name, double gravity) {
  if (name == "subcritical") return {name, 1, exact::SteadyBump(gravity, 4.42, 2.0), 2.0, 2.0, {}};
  if (name == "transcritical") {
    const exact::SteadyBump flow = exact::SteadyBump::transcritical(gravity, 1.53);
    return {name, 2, flow, {}, flow.at(0).depth, 0.8 * flow.critical_depth()};
  }
  return {name, 4, exact::SteadyBump(gravity, 0.18, 0.33), 0.33, 0.33, {}};
}

std::vector<Regime> regimes_of(const Values& values) {
  const std::string& which = values.text("regime");
  std::vector<Regime> regimes;
  for (const std::string name : {"subcritical", "transcritical", "jump"}) {
    if (which == name || which == "all" || (which == "smooth" && name != "jump")) {
      regimes.push_back(regime_from(name, values.real("gravity")));
    }
  }
  return regimes;
}

/// Level water stands as high as the flow does where it comes in, or goes out with a jump.
JudgedSteadyFlow judged_flow(const Regime& regime, const Values& values) {
  const exact::SteadyBump& flow = regime.flow;
  const double gravity = values.real("gravity");
  JudgedSteadyFlow judged{
      .source = "Delestre et al. (2013), section 3.1",
      .exact = [flow](double x) { return flow.at(x); },
      .level_water = [flow, level = regime.start_level](double x) { return level - flow.elevation(x); },
      .discharge = flow.discharge(),
      .length = flow.bump().length,
      .tolerance = values.real("tolerance"),
      .command = fmt::format("seiche exact steady_bump --set discharge={},outflow_depth={},gravity={}",
                             flow.discharge(), regime.outflow_depth.value_or(0), gravity)};
  if (!std::isnan(flow.jump())) {
    const exact::SteadyBump more(gravity, 1.01 * flow.discharge(), *regime.outflow_depth);
    judged.jump = {.front = {.behind = flow.depth_before_jump(),
                             .ahead = flow.depth_after_jump(),
                             .position = flow.jump(),
                             .reach = 1},
                   .sway = std::abs(more.jump() - flow.jump())};
  }
  return judged;
}

/// The same by the peer.
struct OnCells {
  Profile profile = {};
  std::vector<double> discharge = {};
};

OnCells by_cells(const Regime& regime, double gravity, long n, double time) {
  using shallow_water_finite_volume::End;
  const double length = regime.flow.bump().length;
  std::vector<double> depth;
  for (long i = 0; i < n; ++i) {
    depth.push_back(regime.start_depth(length * (static_cast<double>(i) + 0.5) / static_cast<double>(n)));
  }
  shallow_water_finite_volume::FiniteVolumeFlow::Settings settings;
  settings.gravity = gravity;
  // The exact end states are held: the weakest way to err at the ends.
  settings.left = End::inflow(regime.flow.at(0));
  settings.right = End::inflow(regime.flow.at(length));
  shallow_water_finite_volume::FiniteVolumeFlow flow(
      settings, 0, length, depth, std::vector<double>(depth.size(), regime.flow.discharge()), regime.flow.bed());
  march(flow, time);
  OnCells cells{.discharge = {flow.discharge().begin(), flow.discharge().end()}};
  cells.profile.edges = flow.edges();
  for (std::size_t i = 0; i < flow.cells(); ++i) cells.profile.means.push_back({flow.depth()[i], flow.velocity()[i]});
  return cells;
}

/// Mean errors of a profile.
struct ProfileErrors {
  double depth = 0;
  double discharge = 0;  ///< relative
};

/// Of the part of the channel between two places.
ProfileErrors errors_between(const Profile& whole, const exact::SteadyBump& exact, double from, double to) {
  const Profile part = part_of(whole, from, to);
  const double depth = shallow_water::cell_error(
                           part, [&](double x) { return exact.at(x); }, exact.breakpoints())
                           .depth.l1;
  return {depth, mean_discharge_error(part, exact.discharge())};
}

/// With one number of particles.
struct Errors {
  long particles = 0;
  Mean depth;       ///< L1, over the settled instants
  Mean discharge;   ///< relative L1
  Mean jump_depth;  ///< the same within a metre of the jump
  Mean jump_discharge, below_jump_discharge;
  ProfileErrors peer;
};

constexpr double about_jump = 1;  // [m] to either side

struct Settling {
  std::vector<Errors> errors = {};
  Settled finest = {};
  OnCells peer = {};

  [[nodiscard]] evidence::ObservedOrder order(Mean Errors::*error) const {
    return evidence::observed_order(
        each(errors, [](const Errors& e) { return 25.0 / static_cast<double>(e.particles); }),
        each(errors, [&](const Errors& e) { return (e.*error).value(); }));
  }
};

using Results = std::vector<Settling>;  // of the regimes

void claim_orders(const Claims<Settling>& claims, const Regime& regime) {
  const auto claim = [&](const std::string& what, const std::string& text,
                         const std::string& quantity) -> evidence::Claim {
    return {regime.name + "-" + what, fmt::format("{} ({}).", text, regime.name), quantity, "1",
            "Delestre et al. (2013), section 3.1"};
  };
  if (regime.name != "jump") {
    const Order second{2, 0.5,
                       "second order; the corners of the bump, and particles that enter at their own rhythm, change it "
                       "by a few tenths"};
    claims.check(
        claim("order", "The depth converges to the exact steady state at second order", "observed order of cell L1(h)"),
        [](const Settling& r) { return r.order(&Errors::depth); }, second);
    claims.check(
        claim("discharge", "The discharge converges to a uniform value at second order", "observed order of L1(q)"),
        [](const Settling& r) { return r.order(&Errors::discharge); }, second);
    return;
  }
  const Order first{1, 0.5,
                    "first order at a jump: errors of the height of the jump over a fixed number of particles; the "
                    "position of the jump between particles changes the order by a few tenths"};
  claims.check(
      claim("order", "The depth within 1 m of the jump converges at first order", "observed order of cell L1(h)"),
      [](const Settling& r) { return r.order(&Errors::jump_depth); }, first);
  claims.check(
      claim("discharge", "The discharge at the jump converges at first order", "observed order of L1(q)"),
      [](const Settling& r) { return r.order(&Errors::jump_discharge); }, first);
  claims.check(
      claim("discharge-below", "The discharge downstream of the jump equals the inflow within 1 %",
            "mean |q/q_in - 1|"),
      [](const Settling& r) { return r.errors.back().below_jump_discharge.value(); },
      Bound{.limit = 0.01,
            .reason = "fluctuations at the hydraulic jump emit waves; 1 %, the uncertainty of a measuring weir"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<Regime> regimes = regimes_of(values);
  for (std::size_t k = 0; k < regimes.size(); ++k) {
    const Regime& regime = regimes[k];
    const auto one = claims.entry(k);
    claim_orders(one, regime);
    const long finest = numbers_of_particles(regime.coarseness * values.integer("particles")).back();
    const double depth = regime.start_depth(0);
    claim_steady_flow(one.at(fmt::format("N = {}", finest)).of(&Settling::finest), judged_flow(regime, values),
                      {.particles = finest,
                       .time = values.real("time"),
                       .depth = depth,
                       .celerity = std::sqrt(values.real("gravity") * depth),
                       .regime = regime.name});
  }
}

Settling settle(const Regime& regime, const Run& run, const Run::Progress& progress) {
  const double gravity = run.real("gravity");
  const double time = run.real("time");
  const double length = regime.flow.bump().length;
  const double jump = regime.flow.jump();
  const OpenReach reach{.length = length,
                        .discharge = regime.flow.discharge(),
                        .outflow_depth = regime.outflow_depth,
                        .start_depth = [&](double x) { return regime.start_depth(x); },
                        .forcing = {.gravity = gravity, .bed = regime.flow.bed()}};
  Settling r;
  for (const long count : numbers_of_particles(regime.coarseness * run.integer("particles"))) {
    const auto done = static_cast<double>(r.errors.size());
    Errors errors{.particles = count};
    r.finest = validation::settle(
        reach, count, time, [&](double part) { progress((done + part) / numbers_of_resolutions); },
        [&](const Profile& profile) {
          const ProfileErrors all = errors_between(profile, regime.flow, 0, length);
          errors.depth.add(all.depth);
          errors.discharge.add(all.discharge);
          if (regime.name != "jump") return;
          const ProfileErrors near = errors_between(profile, regime.flow, jump - about_jump, jump + about_jump);
          errors.jump_depth.add(near.depth);
          errors.jump_discharge.add(near.discharge);
          errors.below_jump_discharge.add(errors_between(profile, regime.flow, jump + about_jump, length).discharge);
        });
    r.peer = by_cells(regime, gravity, count, time);
    errors.peer = errors_between(r.peer.profile, regime.flow, 0, length);
    r.errors.push_back(errors);
  }
  return r;
}

Results compute(const Run& run) {
  const std::vector<Regime> regimes = regimes_of(run);
  Results r;
  for (const Regime& regime : regimes) {
    r.push_back(settle(regime, run, [&](double done) {
      run.progress((static_cast<double>(r.size()) + done) / static_cast<double>(regimes.size()));
    }));
  }
  return r;
}

void draw(evidence::Exhibit& exhibit, const Settling& r, const Regime& regime) {
  const exact::SteadyBump& flow = regime.flow;
  const std::vector<double> x = evenly(0, 25, 501);
  const auto bed = [&](double at) { return flow.elevation(at); };
  auto& figure = exhibit.figure("profile-" + regime.name, "Steady flow over a bump, " + regime.name,
                                "Surface and discharge after the flow has settled.");
  auto& top = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  const ProfileCurve means = means_of(r.finest.profile);
  std::vector<double> level = each(means.x, bed);
  for (std::size_t i = 0; i < level.size(); ++i) level[i] += means.depth[i];
  top.fill("bed", x, each(x, bed), Role::bed);
  top.line("exact surface", x, each(x, [&](double at) { return flow.at(at).depth + bed(at); }), Role::exact);
  top.points("particles", means.x, level, Role::computed);
  auto& bottom = figure.panel({.x = "x [m]", .y = "discharge q [m²/s]"});
  const double q = flow.discharge();
  bottom.line("exact", std::vector<double>{0, 25}, std::vector<double>{q, q}, Role::exact);
  bottom.points("particles", means.x, each(r.finest.profile.means, [](const State& s) { return s.depth * s.velocity; }),
                Role::computed);
  bottom.points("MUSCL-HLL", means_of(r.peer.profile).x, r.peer.discharge, Role::peer);
}

void show_regime(const Settling& r, const Regime& regime, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(
      exhibit, "resolutions-" + regime.name, "Refinement, " + regime.name, "Mean errors after the flow has settled.",
      {"N", "particles: L1(h) [m]", "particles: L1(q)/q", "cells: L1(h) [m]", "cells: L1(q)/q"});
  const bool jumps = regime.name == "jump";
  if (jumps) {
    for (const char* name : {"particles, at the jump: L1(h)", "L1(q)/q", "below it: L1(q)/q"}) {
      table.columns.emplace_back(name, "");
    }
  }
  for (const Errors& e : r.errors) {
    table.rows.push_back(
        {static_cast<double>(e.particles), e.depth.value(), e.discharge.value(), e.peer.depth, e.peer.discharge});
    if (!jumps) continue;
    for (const Mean* mean : {&e.jump_depth, &e.jump_discharge, &e.below_jump_discharge}) {
      table.rows.back().emplace_back(mean->value());
    }
  }
  exhibit.measure("momentum_defect_" + regime.name, r.finest.momentum_defect);
  draw(exhibit, r, regime);
}

/// Of the first of the regimes.
Submission submission() {
  return submission_of([](const Values& values) { return judged_flow(regimes_of(values).front(), values); });
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<Regime> regimes = regimes_of(values);
  for (std::size_t k = 0; k < regimes.size(); ++k) show_regime(r[k], regimes[k], exhibit);
  measure_own(submission().tables(values), submitted_profile(r.front().finest.profile), exhibit);
}

void steady_bump(Case& c) {
  c.title = "Steady flow over a bump";
  c.source =
      "O. Delestre et al., SWASHES: a compilation of shallow water analytic solutions, Int. J. Numer. Meth. Fluids 72 "
      "(2013) 269, section 3.1";
  c.parameters = {
      choice("regime", {"smooth", "all", "all"}, {"all", "smooth", "subcritical", "transcritical", "jump"},
             "which steady states; smooth: those without a jump"),
      integer("particles", {25, 100, 400}, {8, 1e5},
              "smallest number of particles; up to 8 times as many run too; twice that in transcritical flow, four "
              "times with a jump"),
      real("time", {100, 200, 400}, "s", {1, 1e5}, "settling time of the flow"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      level_tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, "conservation law of mass");
  c.submission = submission();
}

}  // namespace seiche::validation::cases::steady_bump
