/*
A solitary wave meets a conical island: the laboratory experiment of Briggs, Synolakis, Harkins and Green (1995). Such
an island is Babi, where the tsunami of Flores (1992) destroyed the villages in the lee.

**Set-up.** The island is 7.2 m wide at the base, 2.2 m at the top, 0.625 m high, with slopes of 1:4; the water is
0.32 m deep. Waves of 0.045, 0.096 and 0.181 depths (cases A, B, C) come along $x$. Half the basin is computed. The
lattice goes around the island; its first row of markers is the shoreline, which slides on the bottom. No condition is
set there and nothing is tuned: no friction, no breaking. The bottom is a bicubic spline through elevations on a raster
of 0.1 m, as for a surveyed coast. Walls are reflecting; they stand where their echo comes too late to matter.

**What is compared.** The largest run-up $R/A$ by the angle from the front of the island with the measurements, and with
the shallow-water model of Liu et al. (1995).

**What to look at.** The crest bends around the island, and its two ends meet behind it: there the water climbs nearly
as high as in front, though the sides saw much less. In case A the whole course is computed. In cases B and C the
lattice folds before the ends meet: the thin edge of the water runs along the shore faster than the water beside it, and
a lattice that moves with the water cannot be sheared without end. What is shown of them is the run-up until then, and
nothing is claimed of what follows. Finer lattices fold earlier; with columns 0.25 m apart case A does too, after the
wave has passed the sides. In front the run-up converges with the first order of the spacing: $R/A$ = 2.65, 2.60, 2.57
in case A with 0.5, 0.35, 0.25 m. The higher the wave, the more the model climbs above the laboratory: it has neither
friction nor breaking.
*/
#include "validation/run_up/island_flow.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/case/reference_case.hpp"

namespace seiche::validation::cases {
namespace {

using dispersive_shallow_water_2d::Flow;
using evidence::Role;
using evidence::Uncertainty;

const std::string source = "Briggs, Synolakis, Harkins and Green (1995)";
constexpr std::array heights{0.045, 0.096, 0.181};
constexpr std::array names{"A", "B", "C"};
constexpr double after_passage = 6;  // [s], until the water behind the island runs down

/// Measured run-up of one wave.
struct Measured {
  std::vector<double> angle, runup, error, liu;
};

Measured measured(const io::Table& table, double height) {
  Measured rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (std::abs(table.column("H_over_d")[k] - height) > 1e-9) continue;
    rows.angle.push_back(table.column("angle")[k]);
    rows.runup.push_back(table.column("R_over_A")[k]);
    rows.error.push_back(0.1 * rows.runup.back());
    rows.liu.push_back(table.column("R_over_A_liu")[k]);
  }
  return rows;
}

struct Passed {
  double height = 0;  // [m]
  double spacing = 0;
  double step = 0;
  std::vector<double> angle, runup;       // of the markers, run-up over the height
  std::vector<double> time, front, back;  // elevation of the shoreline over the height
  double energy_defect = 0;
  double volume_defect = 0;                                  // relative, of the worst cell
  double folded = std::numeric_limits<double>::quiet_NaN();  // when [s]
  double passage = 0;
  RunupEnvelope envelope;

  [[nodiscard]] double at(double place) const { return envelope.at(place) / height; }
  /// Angles whose largest run-up the run has seen: the wave has gone by there by a second.
  [[nodiscard]] bool saw(double place) const {
    if (std::isnan(folded)) return true;
    const auto marker =
        static_cast<std::size_t>(std::lower_bound(angle.begin(), angle.end() - 1, place) - angle.begin());
    return envelope.time()[marker] < folded - 0.25;
  }
  [[nodiscard]] std::string resolution() const {
    return fmt::format("columns {:g} m apart, tau = {:.3g} s", spacing, step);
  }
};

Passed pass(const ConicalIsland& island, double spacing, const std::function<void(const Flow&)>& observe = {}) {
  Flow flow = island.flow();
  Passed passed{.height = island.wave().amplitude(),
                .spacing = spacing,
                .step = island.step(),
                .passage = island.passage(),
                .envelope = RunupEnvelope(flow)};
  const double energy = flow.energy();
  const double end = island.passage() + after_passage;
  try {
    flow.advance_to(end, island.step(), [&] {
      passed.envelope.observe(flow);
      passed.time.push_back(flow.time());
      passed.front.push_back(flow.z()[0] / passed.height);
      passed.back.push_back(flow.z()[flow.shape().columns] / passed.height);
      passed.energy_defect = std::max(passed.energy_defect, std::abs(flow.energy() / energy - 1));
      if (observe) observe(flow);
    });
  } catch (const Divergence&) {
    passed.folded = flow.time();
  }
  std::vector<double> defects(flow.shape().cells());
  flow.model().constraint_values(flow.state().q, defects);
  for (std::size_t cell = 0; cell < defects.size(); ++cell) {
    passed.volume_defect = std::max(passed.volume_defect, std::abs(defects[cell] / flow.model().first_volumes()[cell]));
  }
  passed.angle = passed.envelope.angle();
  for (const double runup : passed.envelope.runup()) passed.runup.push_back(runup / passed.height);
  return passed;
}

/// Root mean square of the relative difference from the measurements, where the run saw the run-up.
double deviation(const Passed& passed, const Measured& data) {
  double sum = 0;
  double count = 0;
  for (std::size_t k = 0; k < data.angle.size(); ++k) {
    if (!passed.saw(data.angle[k])) continue;
    sum += std::pow(passed.at(data.angle[k]) / data.runup[k] - 1, 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

void claim_wave(evidence::Record& record, const std::string& name, const Passed& passed, const Measured& data) {
  const evidence::Claim claim{
      .id = "runup-" + name,
      .text = std::isnan(passed.folded)
                  ? fmt::format("Case {}: the run-up all around the island is the measured one.", name)
                  : fmt::format("Case {}: where the wave has passed, the run-up is the measured one.", name),
      .quantity = "rms of R/R_measured - 1",
      .source = source};
  const Uncertainty criterion{.data = 0.1,
                              .useful = 0.25,
                              .reason =
                                  "10 % of the measurements (assumed): whether they are given in nominal or in "
                                  "measured wave heights makes up to 11 %"};
  const evidence::Measurement rms{.value = deviation(passed, data), .resolution = passed.resolution()};
  if (name == "C") {
    record.known_failure(claim, rms, criterion, "no friction and no breaking: the highest wave climbs too high");
  } else {
    record.check(claim, rms, criterion);
  }
  record.measure("energy_defect_" + name, passed.energy_defect);
  record.measure("volume_defect_" + name, passed.volume_defect);
  if (!std::isnan(passed.folded)) record.measure("fold_time_" + name, passed.folded);
  const evidence::Claim whole{.id = "whole-" + name,
                              .text = fmt::format("Case {}: the wave passes the island entirely.", name),
                              .quantity = "wave fronts met behind the island, lattice sound",
                              .source = source};
  const evidence::Qualitative sound{.detector = "no cell folds until 6 s after the crest would pass the middle",
                                    .reason = "the water behind the island has run up and down by then"};
  const evidence::Measurement reached{.value = std::isnan(passed.folded) ? 1.0 : 0.0,
                                      .resolution = passed.resolution()};
  if (name == "A") {
    record.check(whole, reached, sound);
  } else {
    record.known_failure(whole, reached, sound,
                         "the edge of the water outruns along the shore what is beside it, and shears the lattice");
  }
}

void claim_lee(evidence::Record& record, const Passed& passed) {
  record.check(
      {.id = "lee",
       .text = "Behind the island, where the two ends of the crest meet, the water climbs higher than beside it.",
       .quantity = "run-up at 180 degrees over that at 157.5",
       .source = source},
      {.value = passed.at(180) > 1.2 * passed.at(157.5) ? 1.0 : 0.0, .resolution = passed.resolution()},
      evidence::Qualitative{.detector = "run-up at 180 degrees above 1.2 times that at 157.5 degrees",
                            .reason = "measured: 1.6 times"});
}

void draw_runup(evidence::Record& record, const std::vector<Passed>& all, const io::Table& table) {
  auto& figure =
      record.figure("runup", "Run-up around a conical island",
                    "Against the angle from the front. Measurements with their uncertainty; the model as far "
                    "as the wave has passed when the lattice folds (B, C); the shallow-water model of Liu et "
                    "al. (1995).");
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Measured data = measured(table, heights[k]);
    auto& panel = figure.panel(
        {.x = "angle [deg]", .y = "R/A", .title = fmt::format("{}: A = {:g} depths", names[k], heights[k])});
    std::vector<double> angle, runup;
    for (std::size_t i = 0; i < all[k].angle.size(); ++i) {
      if (!all[k].saw(all[k].angle[i])) continue;
      angle.push_back(all[k].angle[i]);
      runup.push_back(all[k].runup[i]);
    }
    panel.line("model", angle, runup);
    panel.points("measured", data.angle, data.runup, Role::data, data.error);
    panel.line("Liu et al.", data.angle, data.liu, Role::peer);
  }
}

/// Case of the parameters: the surface from above, the shoreline in front and behind.
void show(Running& run, const ConicalIsland& island, double spacing) {
  auto& plans = run.record.figure("plan", "The wave around the island",
                                  fmt::format("Elevation of the surface from above, A = {:g} depths; the white disc is "
                                              "what is dry of the island.",
                                              run.real("height")));
  const std::array<double, 3> moments{island.passage() - 1, island.passage() + 1, island.passage() + 3.5};
  std::size_t next = 0;
  const Passed passed = pass(island, spacing, [&](const Flow& flow) {
    if (next == moments.size() || flow.time() < moments[next]) return;
    ++next;
    plans
        .panel({.x = "x [m]",
                .y = "y [m]",
                .z = "elevation [m]",
                .title = fmt::format("t = {:.1f} s", flow.time()),
                .equal_aspect = true,
                .x_min = -8.0,
                .x_max = 8.0,
                .y_min = 0.0,
                .y_max = 8.0})
        .plan(
            "surface",
            {.columns = flow.shape().columns, .rows = flow.shape().rows, .x = flow.x(), .y = flow.y(), .z = flow.z()});
  });
  auto& panel = run.record
                    .figure("shoreline", "The shoreline in front of and behind the island",
                            "Elevations over the height of the wave.")
                    .panel({.x = "t [s]", .y = "elevation/A"});
  panel.line("front", passed.time, passed.front);
  panel.line("back", passed.time, passed.back, Role::peer);
  run.record.measure("runup_front", passed.at(0));
  run.record.measure("runup_side", passed.at(90));
  run.record.measure("runup_back", passed.at(180));
}

void run(Running& run) {
  const double spacing = run.real("spacing");
  show(run, ConicalIsland({.height = run.real("height"), .depth = run.real("depth"), .spacing = spacing}), spacing);
  run.progress(0.3);
  const io::Table table = reference_table("conical_island_runup", run.record.reference_data);
  const double compared = run.tier() == Tier::quick ? 0.5 : 0.35;
  std::vector<Passed> all;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    all.push_back(pass(ConicalIsland({.height = heights[k], .spacing = compared}), compared));
    claim_wave(run.record, names[k], all.back(), measured(table, heights[k]));
    run.progress(0.3 + 0.2 * static_cast<double>(k + 1));
  }
  claim_lee(run.record, all.front());
  draw_runup(run.record, all, table);
}

}  // namespace

Case conical_island() {
  Case c;
  c.title = "A solitary wave around a conical island";
  c.source =
      "M. J. Briggs, C. E. Synolakis, G. S. Harkins, D. R. Green, Laboratory experiments of tsunami runup on a "
      "circular "
      "island, Pure Appl. Geophys. 144 (1995) 569; P. L.-F. Liu et al., J. Fluid Mech. 302 (1995) 259";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {real("height", 0.045, "depth", {0.01, 0.25}, "height of the wave"),
                  real("depth", 0.32, "m", {0.25, 0.45}, "of the water"),
                  real("spacing", 0.5, "m", {0.2, 1}, "of the columns along the walls of the basin")};
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
