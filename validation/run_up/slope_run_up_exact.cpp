/*
A solitary wave of the full Euler equations climbs a plane slope behind a level bed. The maximum run-up follows from
fully nonlinear potential flow by a spectral boundary-integral method, in a plane where bed and slope are one straight
line (`seiche exact slope_runup`).

**What is compared.** The run-up with the formula that Hall and Watts fitted to their measurements, over heights and
slopes. The case accepts external results: the maximum shoreline elevation.

**What to look at.** The computed run-up exceeds the measured one, which has friction and surface tension and ends at a
finite film thickness.

**Limits of this test.** Waves that break on their way up, and slopes milder than 1:3, are not covered.
*/
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "seiche/exact/overturning/slope_runup.hpp"
#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::slope_run_up_exact {

const std::string source = "Grilli, Svendsen and Subramanya (1997)";

struct Results {
  double runup = 0;
  std::optional<double> uncertainty;  ///< not in the quick tier: takes as long as the run-up itself
  exact::SelfTest identities;
  std::vector<exact::SlopeRunup::Shore> shore;
};

double formula(const Values& values) {
  return exact::HallWatts(values.real("depth"), 1 / values.real("cotangent")).runup(values.real("amplitude"));
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_identities(claims.from(source).of(&Results::identities),
                   exact::SlopeRunup::identities(values.real("amplitude") / values.real("depth")));
  claims.only_if(values.real("cotangent") > 0, "measurements exist for slopes only")
      .check(
          "measurements",
          "The run-up lies 0 to 10 % above the measurement, as friction and two standard uncertainties of 5 % allow.",
          "R/R_measured - 1",
          [measured = values.real("cotangent") > 0 ? formula(values) : 0](const Results& r) {
            return r.runup / measured - 1;
          },
          Bound{.limit = 0.05,
                .reason = "0 to 10 %: a frictionless run-up cannot lie below the measurement, and above it by at most "
                          "two standard uncertainties, 5 % each (assumed)",
                .expected = 0.05});
}

Results compute(const Run& run) {
  const exact::SlopeRunup slope(run.real("amplitude"), run.real("cotangent"), run.real("depth"));
  run.progress(0.6);
  Results r{slope.runup(), {}, slope.self_test(), slope.history()};
  if (run.tier() != Tier::quick) r.uncertainty = slope.uncertainty();
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  if (r.uncertainty) exhibit.measure("reference_uncertainty", *r.uncertainty);
  exhibit.measure("runup", r.runup);
  const io::Table table = values.table("slope_runup_exact");
  auto& figure = exhibit.figure("runup", "Run-up over amplitude",
                                fmt::format("Exact values (tabulated, and this run's at a = {:g} depth) beside the "
                                            "formula of Hall and Watts for their measurements.",
                                            values.real("amplitude") / values.real("depth")));
  for (const double cotangent : {1.0, 2.0}) {
    auto& panel = figure.panel(
        {.x = "amplitude/depth", .y = "run-up/amplitude", .title = fmt::format("cotangent {:g}", cotangent)});
    const io::Table rows = rows_where(table, {{"cot_slope", cotangent}});
    const std::vector<double>& a = rows.column("A");
    const exact::HallWatts law(1, 1 / cotangent);
    panel.points("exact, tabulated", a, quotients(rows.column("R"), a), Role::exact);
    panel.line("Hall and Watts", a, each(a, [&](double height) { return law.runup(height) / height; }), Role::guide);
    if (values.real("cotangent") == cotangent) {
      panel.points("this run", std::vector{values.real("amplitude") / values.real("depth")},
                   std::vector{r.runup / values.real("amplitude")}, Role::computed);
    }
  }
  add_panel(exhibit, "shore", "The shore",
            "Elevation above still water; at t = 0 the undisturbed crest passes the toe.",
            {.x = "t sqrt(g/depth)", .y = "elevation [m]"})
      .line("shore", each(r.shore, &exact::SlopeRunup::Shore::time), each(r.shore, &exact::SlopeRunup::Shore::level),
            Role::exact);
}

std::vector<WantedTable> wanted(const Values& values) {
  const double amplitude = values.real("amplitude");
  const double cotangent = values.real("cotangent");
  const double depth = values.real("depth");
  const std::function<double()> runup = [=] { return exact::SlopeRunup(amplitude, cotangent, depth).runup(); };
  return {
      {.name = "numbers",
       .quantities = {wanted_number(
           {"runup", "m", "maximum shoreline elevation above still water"}, runup, values,
           "The run-up agrees with fully nonlinear potential flow within the tolerance, by default 3.5 %.", source)},
       .exact = {fmt::format("seiche exact slope_runup --set amplitude={},cotangent={},depth={}", amplitude, cotangent,
                             depth)}}};
}

void slope_run_up_exact(Case& c) {
  c.title = "Run-up of a solitary wave on a plane slope: fully nonlinear potential flow";
  c.source = "S. T. Grilli, I. A. Svendsen, R. Subramanya, J. Waterway, Port, Coastal, Ocean Eng. 123 (1997) 102; " +
             literature::hall_watts;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.3, "m", {1e-6, 1e6}, "of the incident wave, 0.02 to 0.5 depth"),
      real("cotangent", 1.0, "1", {0, 3}, "s of the slope 1:s; 0: a vertical wall"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, "Hall and Watts (1953)");
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::slope_run_up_exact
