/*
The exact solitary wave of the Euler equations travels through a tank of water that is cut into quadrilaterals of
constant area (Frank 1994, chapter 2). Depth, gravity and density are 1.

**Set-up.** The tank is 60 long, between vertical walls. The crest starts at $x = 15$ and runs for 20 time units. The
mesh has `rows` rows of height $h_2$; its columns hold equal areas, about `h1` wide. The surface is the exact one.

**What is compared.** Speed and height of the crest, and the surface about it. The crest is the top of the quartic
through the highest node and its neighbours. The profile error is taken about the computed crest, so that it measures
shape and height only.

The exact wave is not quite the wave of the mesh. In the first five time units the crest falls back by two thirds of
what it loses in twenty, and leaves small waves behind. The **speed** is therefore that of a straight line through the
crest's places from $t = 5$ on. The **phase error** counts from the start.

**What to look at.** All errors are of second order, and the height of the cells governs them: twice as many rows help
much more than twice as many columns. Sharper waves show it on finer meshes only: for $A = 0.5$ the orders observed here
are 1.5 to 1.8. On coarse meshes the wave is too slow and loses height. The energy of the one-step scheme is kept to
second order in the step; that of the conservative one to round-off, and the area of every cell with it.

**How to start.** `sampled`: the exact velocities at the nodes, made to change no area. In a potential flow of the mesh
surface nodes are slower along the surface, to first order in the cells. Given the exact velocity, they slide over the
row beneath where the wave started, and nothing ever stops them. A high wave on coarse cells folds the mesh there in the
end, when it has long gone. `impulse`: the velocities that an impulsive pressure $-\varphi$ on the surface, the
potential of the exact wave, gives the mesh at rest. They are a potential flow of the mesh, and the fold does not come.
A small restoring force (`hourglass`) prevents it too.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/impulsive_start.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/crest_track.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/case/reference_case.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/instruments/mesh_solitary_wave.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Order;
using evidence::Role;
using evidence::Roundoff;
using exact::SolitaryWave;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Scheme;
using lagrangian_mesh_2d::Settings;
using lagrangian_mesh_2d::Stepping;

const std::string source = "Frank (1994), chapter 2";
const std::string digits = "computed once by an independent implementation";
constexpr double length = 60;  // of the tank
constexpr double start = 15;
constexpr double duration = 20;
constexpr double settled = 5;  // when the first adjustment is over
constexpr double reach = 10;   // of the profile, from the crest

struct Outcome {
  CrestTrack track;
  double speed_error = 0;  ///< relative, from `settled` on
  double crest = 0;        ///< height at the end
  double profile = 0;      ///< largest error about the computed crest
  double phase = 0;        ///< crest less exact crest at the end
  double energy = 0;       ///< largest relative defect
  double area = 0;         ///< largest defect of a cell over its area
};

enum class First { sampled, impulse };  ///< velocities

First first_of(const Values& values) {
  return values.text("start") == "impulse" ? First::impulse : First::sampled;
}

Flow flow_of(const SolitaryWave& wave, const MeshResolution& resolution, Scheme scheme, double hourglass,
             First first = First::sampled) {
  const PlacedWave placed{wave, start};
  const lagrangian_mesh_2d::Mesh mesh = placed.mesh(length, resolution);
  const Flow::Velocity velocity = first == First::sampled
                                      ? Flow::Velocity([&](Point r) { return placed.velocity(r); })
                                      : impulsive_start(mesh, [&](double x) { return placed.surface_potential(x); });
  return Flow(mesh, velocity, scheme, Settings{.hourglass = hourglass});
}

Outcome travel(Flow& flow, const SolitaryWave& wave, double tau) {
  Outcome result{.track = follow_crest(flow, duration, tau, [&] { flow.observe(); })};
  const CrestTrack& track = result.track;
  result.speed_error = track.speed(settled) / wave.speed() - 1;
  result.crest = track.elevation.back();
  result.profile = largest_profile_error(flow, track.place.back(), reach, [&](double s) { return wave.elevation(s); });
  result.phase = track.place.back() - start - wave.speed() * track.time.back();
  result.energy = flow.ledger().entry("energy").largest_defect / flow.ledger().entry("energy").initial;
  const auto areas = flow.model().first_areas();
  result.area = flow.ledger().entry("volume_worst").largest_defect / *std::min_element(areas.begin(), areas.end());
  return result;
}

Outcome travel(const SolitaryWave& wave, const MeshResolution& mesh, Scheme scheme = {}, double hourglass = 0,
               First first = First::sampled) {
  Flow flow = flow_of(wave, mesh, scheme, hourglass, first);
  return travel(flow, wave, mesh.tau);
}

/// Cells twice as wide as high, five steps to a column.
MeshResolution with_rows(long rows) {
  const double height = 1 / static_cast<double>(rows);
  return {.column_width = 2 * height, .rows = rows, .tau = 0.4 * height};
}

evidence::Table table_of_runs(const std::string& id, const std::string& title, const std::string& caption) {
  return {.id = id,
          .title = title,
          .caption = caption,
          .columns = {{"amplitude", "depth"},
                      {"h1", "depth"},
                      {"rows", "1"},
                      {"tau", "sqrt(depth/g)"},
                      {"speed error", "1"},
                      {"crest at the end", "depth"},
                      {"profile error", "depth"},
                      {"phase error", "depth"},
                      {"worst corner", "1"},
                      {"until", "sqrt(depth/g)"}}};
}

void add_row(evidence::Table& table, double amplitude, const MeshResolution& mesh, const Outcome& run) {
  table.rows.push_back({amplitude, mesh.column_width, static_cast<double>(mesh.rows), mesh.tau, run.speed_error,
                        run.crest, run.profile, run.phase, run.track.worst_corner, run.track.time.back()});
}

/// A number as it is printed, with the unit of its last digit.
struct Printed {
  double value;
  double unit;
};

struct Published {
  double amplitude;
  MeshResolution mesh;
  Printed speed_error, crest, profile;
};

const std::vector<Published>& published() {
  static const MeshResolution one{1, 2, 0.1};
  static const MeshResolution two{0.5, 4, 0.1};
  static const MeshResolution three{0.25, 8, 0.05};
  static const MeshResolution four{0.125, 16, 0.025};
  static const std::vector<Published> all = {
      {0.1, one, {-6.7e-3, 1e-4}, {0.0988, 1e-4}, {3.6e-3, 1e-4}},
      {0.1, two, {-1.9e-3, 1e-4}, {0.0997, 1e-4}, {1.0e-3, 1e-4}},
      {0.1, three, {-4.9e-4, 1e-5}, {0.0999, 1e-4}, {2.7e-4, 1e-5}},
      {0.1, four, {-1.25e-4, 1e-6}, {0.1000, 1e-4}, {6.9e-5, 1e-6}},
      {0.3, one, {-8.3e-3, 1e-4}, {0.2823, 1e-4}, {2.0e-2, 1e-3}},
      {0.3, two, {-2.3e-3, 1e-4}, {0.2938, 1e-4}, {6.4e-3, 1e-4}},
      {0.3, three, {-6.0e-4, 1e-5}, {0.2981, 1e-4}, {1.9e-3, 1e-4}},
      {0.3, four, {-1.5e-4, 1e-5}, {0.2995, 1e-4}, {5.1e-4, 1e-5}},
      {0.5, two, {-4.3e-3, 1e-4}, {0.4776, 1e-4}, {2.1e-2, 1e-3}},
      {0.5, three, {-1.3e-3, 1e-4}, {0.4918, 1e-4}, {8.0e-3, 1e-4}},
      {0.5, four, {-3.7e-4, 1e-5}, {0.4975, 1e-4}, {2.5e-3, 1e-4}},
  };
  return all;
}

/// How far a number is from a printed one, beyond what the printing rounds away.
double beyond_rounding(double value, const Printed& printed) {
  return std::max(0.0, std::abs(value - printed.value) - 0.5 * printed.unit);
}

void claim_published(Running& run) {
  evidence::Table table = table_of_runs("published", "Three heights on the same meshes as an independent program",
                                        "One-step scheme, no hourglass force.");
  for (const double amplitude : {0.1, 0.3, 0.5}) {
    const SolitaryWave wave(amplitude);
    double speed = 0;
    double crest = 0;
    double profile = 0;
    std::string meshes;
    for (const Published& one : published()) {
      if (one.amplitude != amplitude || (one.mesh.rows > 8 && run.tier() == Tier::quick)) continue;
      const Outcome outcome = travel(wave, one.mesh);
      add_row(table, amplitude, one.mesh, outcome);
      speed = std::max(speed, beyond_rounding(outcome.speed_error, one.speed_error));
      crest = std::max(crest, beyond_rounding(outcome.crest, one.crest));
      profile = std::max(profile, beyond_rounding(outcome.profile, one.profile));
      meshes += fmt::format("{}{}", meshes.empty() ? "rows: " : ", ", one.mesh.rows);
    }
    const Bound rounding{.limit = 0, .reason = "half a unit of the last digit given is all that may differ"};
    const Bound beginning{.limit = 1e-3,
                          .reason =
                              "the speed of a line that begins 0.4 later differs by that on the coarsest mesh; when "
                              "the other program's begins is not known to more digits"};
    const auto claim = [&](const std::string& id, const std::string& what, double worst, const Bound& bound) {
      run.record.check({.id = fmt::format("digits-{}-{:.0f}", id, 10 * amplitude),
                        .text = fmt::format("A = {:g}: the {} is that of an independent program.", amplitude, what),
                        .quantity = "largest difference beyond half a unit of the last digit given, over A",
                        .source = digits},
                       {.value = worst / amplitude, .resolution = meshes}, bound);
    };
    claim("speed", "speed error", speed, beginning);
    claim("crest", "height of the crest", crest, rounding);
    claim("profile", "profile error", profile, rounding);
  }
  run.record.table(std::move(table));
}

/// The coarsest mesh under a high wave: how long it lasts with either start, and with the restoring force.
void claim_fold(Running& run) {
  const SolitaryWave wave(0.5);
  const MeshResolution mesh{1, 2, 0.1};
  const Outcome sampled = travel(wave, mesh);
  const Outcome impulse = travel(wave, mesh, {}, 0, First::impulse);
  const Outcome held = travel(wave, mesh, {}, 0.02);
  if (sampled.track.folded) {
    run.record.measure("fold_time", sampled.track.folded->time());
    run.record.measure("fold_place", sampled.track.folded->place());
  }
  const Bound to_the_end{
      .limit = 1e-9, .reason = "the time that was asked for, to the rounding of its steps", .expected = duration};
  const auto claim = [&](const std::string& id, const std::string& sentence) {
    return evidence::Claim{
        .id = id, .text = sentence, .quantity = "end of the run", .unit = "sqrt(depth/g)", .source = source};
  };
  const auto end = [&](const Outcome& outcome) {
    return evidence::Measurement{.value = outcome.track.time.back(), .resolution = mesh.text()};
  };
  run.record.known_failure(
      claim("fold",
            "A = 0.5 on cells one depth wide: no corner folds behind a wave that starts with sampled velocities."),
      end(sampled), to_the_end,
      "surface nodes with the exact velocity slide over the row beneath: no force stops them" +
          (sampled.track.folded ? fmt::format("; {}", sampled.track.folded->what()) : ""));
  run.record.check(claim("fold-impulse", "Nor behind one that an impulse on the surface starts."), end(impulse),
                   to_the_end);
  run.record.check(claim("fold-hourglass", "Nor where the hourglass force, kappa_0 = 0.02, holds the mesh."), end(held),
                   to_the_end);
  for (const auto& [id, outcome] :
       {std::pair{"sampled", &sampled}, std::pair{"impulse", &impulse}, std::pair{"hourglass", &held}}) {
    run.record.measure(fmt::format("worst_corner_{}", id), outcome->track.worst_corner);
    run.record.measure(fmt::format("crest_{}", id), outcome->crest);
    run.record.measure(fmt::format("speed_error_{}", id), outcome->speed_error);
  }
}

/// Columns, rows and steps refined together.
void refine(Running& run, const SolitaryWave& wave) {
  const double amplitude = wave.amplitude();
  evidence::Table table = table_of_runs("refinement", "Columns, rows and steps refined together",
                                        "One-step scheme, as the parameters else.");
  auto& errors = run.record
                     .figure("errors", "Errors against the height of the cells",
                             "At the end of the run; cells twice as wide as high, five steps to a column.")
                     .panel({.x = "h2 [depth]", .y = "error", .log_x = true, .log_y = true});
  auto& history = run.record.figure("history", "The crest on its way",
                                    "The wave of the mesh is not quite the exact one: the crest falls back while the "
                                    "difference is left behind.");
  auto& lag = history.panel({.x = "t [sqrt(depth/g)]", .y = "crest less exact crest [depth]"});
  auto& height = history.panel({.x = "t [sqrt(depth/g)]", .y = "crest/A"});
  std::vector<long> ladder = {4, 6, 8, 12, 16};
  if (run.tier() != Tier::quick) ladder.push_back(24);
  std::vector<double> h2, speed, loss, profile, phase;
  for (const long rows : ladder) {
    const MeshResolution mesh = with_rows(rows);
    const Outcome outcome = travel(wave, mesh, {}, run.real("hourglass"), first_of(run.values()));
    add_row(table, amplitude, mesh, outcome);
    std::vector<double> lags;
    std::vector<double> heights;
    for (std::size_t k = 0; k < outcome.track.time.size(); ++k) {
      lags.push_back(outcome.track.place[k] - start - wave.speed() * outcome.track.time[k]);
      heights.push_back(outcome.track.elevation[k] / amplitude);
    }
    lag.line(fmt::format("{} rows", rows), outcome.track.time, lags, Role::computed);
    height.line(fmt::format("{} rows", rows), outcome.track.time, heights, Role::computed);
    if (outcome.track.folded) continue;
    h2.push_back(1 / static_cast<double>(rows));
    speed.push_back(std::abs(outcome.speed_error));
    loss.push_back(std::abs(amplitude - outcome.crest) / amplitude);
    profile.push_back(outcome.profile / amplitude);
    phase.push_back(std::abs(outcome.phase));
  }
  run.record.table(std::move(table));
  if (h2.empty()) return;
  for (const auto& [id, what, values] :
       {std::tuple{"speed", "speed", &speed}, std::tuple{"crest", "loss of height over A", &loss},
        std::tuple{"profile", "profile over A", &profile}, std::tuple{"phase", "phase [depth]", &phase}}) {
    errors.points(what, h2, *values, Role::computed);
    run.record.check({.id = fmt::format("order-{}", id),
                      .text = fmt::format("Error of the {}: second order.", what),
                      .quantity = "observed order",
                      .source = source},
                     evidence::observed_order(h2, *values),
                     Order{2, 0.3,
                           "the next term is of third order, not fourth: surface nodes feel the pressure half a cell "
                           "below; with four rows it takes a fifth off the error, so 0.2 off the order"});
  }
  slope_guide(errors, 2, h2, 2 * phase.back());
}

/// Which of the cell's sides matters.
void refine_one_side(Running& run, const SolitaryWave& wave) {
  evidence::Table table = table_of_runs("sides", "Columns alone, rows alone", "The steps are the same, 0.05.");
  const auto profile = [&](double column_width, long rows) {
    const MeshResolution mesh{column_width, rows, 0.05};
    const Outcome outcome = travel(wave, mesh, {}, run.real("hourglass"), first_of(run.values()));
    add_row(table, wave.amplitude(), mesh, outcome);
    return outcome.track.folded ? std::numeric_limits<double>::quiet_NaN() : outcome.profile;
  };
  const double both_coarse = profile(0.5, 4);
  const double columns_halved = profile(0.25, 4);
  const double rows_halved = profile(0.5, 8);
  profile(0.25, 8);
  run.record.measure("gain_of_columns", 1 - columns_halved / both_coarse);
  run.record.measure("gain_of_rows", 1 - rows_halved / both_coarse);
  run.record.check(
      {.id = "rows-govern",
       .text = "The height of the cells governs the error: halving it takes off more than halving the width.",
       .quantity = "profile error with half the height over that with half the width",
       .source = source},
      {.value = rows_halved / columns_halved, .resolution = "from h1 = 0.5, 4 rows"},
      Bound{.limit = 1, .reason = "more than means a ratio below 1"});
  run.record.table(std::move(table));
}

/// What the steps keep: the one-step scheme to second order in them, the conservative one to round-off.
void claim_conservation(Running& run, const SolitaryWave& wave) {
  const MeshResolution coarse{0.5, 4, 0.1};
  std::vector<double> tau, energy, area;
  for (int k = 0; k < 4; ++k) {
    MeshResolution mesh = coarse;
    mesh.tau = coarse.tau / static_cast<double>(1L << k);
    const Outcome outcome = travel(wave, mesh, {}, run.real("hourglass"), first_of(run.values()));
    tau.push_back(mesh.tau);
    energy.push_back(outcome.energy);
    area.push_back(outcome.area);
  }
  const auto claim_order = [&](const std::string& id, const std::string& what, const std::vector<double>& defects) {
    run.record.check({.id = "one-step-" + id,
                      .text = "One-step: " + what + " are kept to second order in the step.",
                      .quantity = "observed order of the largest relative defect",
                      .source = "Frank (1994), chapter 1"},
                     evidence::observed_order(tau, defects),
                     Order{2, 0.1, "even powers of the step only: the scheme is time-reversible"});
  };
  claim_order("energy", "energy", energy);
  claim_order("area", "areas", area);

  Flow flow =
      flow_of(wave, coarse, {.stepping = Stepping::conservative}, run.real("hourglass"), first_of(run.values()));
  const Outcome kept = travel(flow, wave, coarse.tau);
  run.record.measure("conservative_speed_error", kept.speed_error);
  const auto solves = static_cast<double>(flow.model().solver().solutions());
  const auto claim_kept = [&](const std::string& id, const std::string& text, double value, double scale,
                              const std::string& reason) {
    run.record.check(
        {.id = "conservative-" + id, .text = text, .quantity = "largest relative defect", .source = source},
        {.value = value, .resolution = coarse.text()},
        Roundoff{.operations = solves, .scale = scale, .reason = reason + ", once per solve"});
  };
  claim_kept("energy", "Conservative: energy is kept.", kept.energy, 1, "the rounded energy");
  claim_kept("area", "Conservative: the area of every cell is kept.", kept.area, length / coarse.column_width,
             "a rounded coordinate, up to the tank's length, over the width of a cell");
}

/// The run that the parameters describe.
void follow_one(Running& run, const SolitaryWave& wave) {
  const MeshResolution mesh{run.real("h1"), run.integer("rows"), run.real("tau")};
  Flow flow = flow_of(wave, mesh, {.stepping = mechanics::stepping_named(run.text("scheme"))}, run.real("hourglass"),
                      first_of(run.values()));
  const Outcome outcome = travel(flow, wave, mesh.tau);
  if (outcome.track.folded) throw *outcome.track.folded;
  run.record.measure("h1_used", length / static_cast<double>(mesh.columns(length)));
  run.record.measure("speed", outcome.track.speed(settled));
  run.record.measure("speed_from_the_start",
                     (outcome.track.place.back() - outcome.track.place.front()) / outcome.track.time.back());
  run.record.measure("exact_speed", wave.speed());
  run.record.measure("speed_error", outcome.speed_error);
  run.record.measure("end_amplitude", outcome.crest);
  run.record.measure("phase_error", outcome.phase);
  run.record.measure("max_profile_error", outcome.profile);
  run.record.measure("energy_defect", outcome.energy);
  run.record.measure("area_defect", outcome.area);
  run.record.measure("worst_corner", outcome.track.worst_corner);

  const double place = start + wave.speed() * duration;
  const MeshWindow window{place - 6, place + 6};
  auto& figure =
      run.record.figure("wave", "The wave at the end", "Mesh; surface nodes and exact surface: " + mesh.text() + ".");
  std::vector<double> x = evenly(window.begin, window.end, 241);
  std::vector<double> surface;
  for (const double at : x) surface.push_back(wave.elevation(at - place));
  auto& picture = figure.panel(mesh_axes("Mesh", window));
  draw_mesh(picture, "", flow, window);
  auto& profile =
      figure.panel({.x = "x [depth]", .y = "elevation [depth]", .x_min = window.begin, .x_max = window.end});
  profile.line("exact", x, surface, Role::exact);
  auto& error =
      figure.panel({.x = "x [depth]", .y = "computed less exact [depth]", .x_min = window.begin, .x_max = window.end});
  std::vector<double> nodes, heights, differences;
  for (std::size_t i = 0; i < flow.surface_x().size(); ++i) {
    if (std::abs(flow.surface_x()[i] - place) > 6) continue;
    nodes.push_back(flow.surface_x()[i]);
    heights.push_back(flow.surface_y()[i]);
    differences.push_back(heights.back() - wave.elevation(nodes.back() - place));
  }
  profile.points("nodes", nodes, heights, Role::computed);
  error.points("nodes", nodes, differences, Role::computed);
}

void run(Running& run) {
  const SolitaryWave wave(run.real("amplitude"));
  follow_one(run, wave);
  run.progress(0.05);
  claim_conservation(run, wave);
  refine_one_side(run, wave);
  run.progress(0.2);
  refine(run, wave);
  run.progress(0.7);
  claim_published(run);
  claim_fold(run);
}

}  // namespace

Case solitary_mesh() {
  Case c;
  c.former_names = {"solitary_2d"};
  c.title = "A solitary wave of the Euler equations on a Lagrangian mesh";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 2; D. Dutykh, D. Clamond, "
      "Wave Motion 51 (2014) 86";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.3, "depth", {0.01, 0.65}, "crest above still water"),
      real("h1", {0.5, 0.25, 0.125}, "depth", {0.02, 2}, "width of the columns; changed to fill the tank"),
      integer("rows", {4, 8, 16}, {1, 100}, "of cells over the depth"),
      real("tau", {0.1, 0.05, 0.025}, "sqrt(depth/g)", {1e-3, 0.5}, "step"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"},
             "of the run whose measures are kept"),
      choice("start", std::string("sampled"), {"sampled", "impulse"},
             "first velocities, but for the comparison with the independent program"),
      real("hourglass", 0.0, "1", {0, 10},
           "kappa_0 of the force against node motions (-1)^(i+j), with the same exception"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
