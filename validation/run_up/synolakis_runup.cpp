/*
How high a solitary wave climbs a plane beach of slope 1 : 19.85: Synolakis (1987) measured it, solved it exactly for
the shallow-water equations, and found the run-up law $R = 2.831\sqrt{\cot\beta}\,A^{5/4}$.

**Set-up.** As in `run_up_1d`.

**What is compared.** For $A = 0.019$ the largest run-up as the spacing goes to zero, with the tip of Frank's thesis, of
mass $V/4$, and with $V/6$, with which a plane surface over a plane slope accelerates as it should. And the run-up of
all 29 laboratory waves that do not break, $A \le 0.045$.

**What to look at.** The two tips tend to the same run-up. At $h = 1/2$ the tip $V/6$ is nearer to it than the other is
at $h = 1/16$. In the laboratory waves of $A < 0.01$ climb as high as the theories say, higher ones less high.
*/
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_source.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases {
namespace {

using dispersive::TipMass;
using evidence::Role;

constexpr double cot_slope = 19.85;
const std::string source = "Synolakis (1987)";
const std::string benchmark =
    "5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA Tech. Memo. OAR PMEL-135 (2007)";

/// Run-up of one wave with spacings 1/2, 1/4, ...
struct Sequence {
  std::vector<double> spacing;
  std::vector<double> runup;
};

Sequence refine(const Values& values, double amplitude, TipMass tip, long levels) {
  Sequence sequence;
  for (long k = 0; k < levels; ++k) {
    SolitaryClimb climb = climb_from(values, cot_slope, amplitude);
    climb.spacing = 0.5 / std::pow(2.0, static_cast<double>(k));
    climb.tip_mass = tip;
    sequence.spacing.push_back(climb.spacing);
    sequence.runup.push_back(run_up(climb).height);
  }
  return sequence;
}

void claim_runup(Running& run, double exact) {
  const long levels = run.integer("levels");
  auto& panel = run.record
                    .figure("refinement", "The largest run-up as the spacing goes to zero",
                            "A = 0.019. The mass of the shoreline marker decides how fast it converges.")
                    .panel({.x = "h [depth]", .y = "R [depth]"});
  for (const auto& [tip, id, label] : {std::tuple{TipMass::elementary, "elementary", "tip V/4, the thesis's"},
                                       std::tuple{TipMass::consistent, "consistent", "tip V/6"}}) {
    const Sequence sequence = refine(run.values(), 0.019, tip, levels);
    panel.line(label, sequence.spacing, sequence.runup, Role::computed);
    for (std::size_t k = 0; k < sequence.spacing.size(); ++k) {
      run.record.measure(fmt::format("runup_{}_h_1_{:g}", id, 1 / sequence.spacing[k]), sequence.runup[k]);
    }
    const evidence::GridConvergence limit = evidence::grid_convergence(sequence.spacing, sequence.runup, 2);
    run.record.measure(fmt::format("runup_{}_extrapolated", id), limit.extrapolated);
    run.record.measure(fmt::format("runup_{}_order", id), limit.order);
    run.record.measure(fmt::format("runup_{}_uncertainty", id), limit.uncertainty);
    if (tip == TipMass::elementary) continue;
    const std::string resolution = fmt::format("h = 0.5 to {:g}, tip V/6, extrapolated", sequence.spacing.back());
    run.record.check({.id = "runup",
                      .text = "The largest run-up is that of the exact solution of the shallow-water equations.",
                      .quantity = "run-up",
                      .unit = "depth",
                      .source = source},
                     {.value = limit.extrapolated, .resolution = resolution},
                     evidence::Bound{.limit = 0.05, .reason = benchmark, .expected = exact, .relative = true});
    if (run.text("kinetics") == "frank") {
      run.record.check({.id = "runup-digits",
                        .text = "Its limit for h = 0 is known from an independent implementation of the model.",
                        .quantity = "run-up",
                        .unit = "depth",
                        .source = "computed once by an independent implementation, five resolutions"},
                       {.value = limit.extrapolated, .resolution = resolution},
                       evidence::Bound{.limit = 1e-4, .reason = "a unit of the last digit given", .expected = 0.0882});
    }
  }
  panel.line("shallow-water equations", std::vector{0.0, 0.5}, std::vector{exact, exact}, Role::exact);
}

/// All laboratory waves that do not break, each height computed once.
void compare_laboratory_runups(Running& run) {
  constexpr double breaks_above = 0.045;
  const io::Table table = reference_table("synolakis_1987_runup", run.record.reference_data);
  const auto uncertainty = reference_source("synolakis_1987_runup").standard_uncertainty;
  std::map<double, double> model;
  double bias = 0;
  double square = 0;
  double law_square = 0;
  double count = 0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double amplitude = table.column("A_over_d")[k];
    if (amplitude > breaks_above) continue;
    if (!model.contains(amplitude)) {
      model[amplitude] = run_up(climb_from(run.values(), cot_slope, amplitude)).height;
      run.progress(0.2 + 0.8 * amplitude / breaks_above);
    }
    const double measured = model[amplitude] / table.column("R_over_d")[k] - 1;
    bias += measured;
    square += measured * measured;
    law_square += std::pow(model[amplitude] / runup_law(cot_slope, amplitude) - 1, 2);
    ++count;
  }
  run.record.measure("laboratory_runups", count);
  run.record.measure("laboratory_runup_bias", bias / count);
  run.record.measure("laboratory_runup_rms", std::sqrt(square / count));
  run.record.measure("law_rms", std::sqrt(law_square / count));
  const std::string resolution = climb_from(run.values(), cot_slope, 0.02).resolution();
  run.record.check({.id = "law",
                    .text = "For the heights of the laboratory the model follows the run-up law.",
                    .quantity = "rms of R/R_law - 1, A <= 0.045",
                    .source = source},
                   {.value = std::sqrt(law_square / count), .resolution = resolution},
                   evidence::Bound{.limit = 0.05, .reason = benchmark});
  run.record.known_failure(
      {.id = "laboratory-runups",
       .text = "The run-up is the measured one.",
       .quantity = "rms of R/R_measured - 1, A <= 0.045",
       .source = source},
      {.value = std::sqrt(square / count), .resolution = resolution},
      evidence::Uncertainty{.data = uncertainty.at("R_over_d").value,
                            .useful = 0.15,
                            .reason = "5 %, the scatter of repeated heights (assumed)"},
      "from A = 0.01 on, flow without friction and surface tension climbs higher than water in a laboratory, and the "
      "run-up law does so as well");

  auto& panel = run.record
                    .figure("laboratory_runups", "Run-up on the beach 1 : 19.85",
                            "Measured, also for waves that break (A > 0.045); law and model where they do not.")
                    .panel({.x = "A [depth]", .y = "R [depth]", .log_x = true, .log_y = true});
  panel.points("laboratory", table.column("A_over_d"), table.column("R_over_d"), Role::data);
  std::vector<double> a;
  std::vector<double> r;
  std::vector<double> law;
  for (const auto& [amplitude, runup] : model) {
    a.push_back(amplitude);
    r.push_back(runup);
    law.push_back(runup_law(cot_slope, amplitude));
  }
  panel.line("run-up law", a, law, Role::guide);
  panel.line("model", a, r, Role::computed);
}

void run(Running& run) {
  claim_runup(run, exact::SolitaryRunup(1, 1, 0.019, cot_slope).highest().elevation);
  run.progress(0.2);
  compare_laboratory_runups(run);
}

}  // namespace

Case synolakis_runup() {
  Case c;
  c.title = "Run-up of solitary waves on a beach 1 : 19.85 against Synolakis' laboratory and law";
  c.source = "C. E. Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = joined({climb_parameters({0.25, 0.25, 0.125}),
                         slope_parameters(),
                         {integer("levels", {3, 4, 5}, {3, 6}, "spacings of the sequence 1/2, 1/4, ...")}});
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
