/*
Hall and Watts (1953) measured the run-up of solitary waves, breaking and non-breaking, on smooth plane beaches of 5 to
45 degrees and fitted $R = 3.05 S^{-0.13} a^{1.15 S^{0.02}}$ from 12 degrees on, $R = 11 S^{0.67} a^{1.9 S^{0.35}}$
below, with the slope $S$ and lengths over the depth.

**What is compared.** The case shows the law beside the values that Frank (1994) read off the measurements. It accepts
external results: the run-up of waves of H/h = 0.05 to 0.3 on one beach, within the scatter of the experiments. The
suite's models are compared with the law in `slope_run_up_mesh` and `run_up_table`.

**What to look at.** The law is a fit: such experiments scatter by 5 %, the smallest difference that this case resolves.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::hall_watts_run_up {

using exact::HallWatts;

const std::string source = "Hall and Watts (1953)";

HallWatts law_of(const Values& values) {
  return {1, 1 / values.real("cot_slope")};
}

void show(const HallWatts& law, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<double> a = evenly(0.05, 0.3, 51);
  auto& panel = add_panel(
      exhibit, "runup", "Run-up of solitary waves on a plane beach",
      fmt::format("The law on the slope 1:{:g}, and Frank's readings of the measurements on slopes within 1 % of it.",
                  values.real("cot_slope")),
      {.x = "a [depth]", .y = "R [depth]"});
  panel.line("law", a, each(a, [&](const double amplitude) { return law.runup(amplitude); }), Role::guide);
  const io::Table table = values.table("frank_1994_runup_hall_watts");
  std::vector<double> measured_a, measured_r;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (std::abs(table.column("cot_slope")[k] / values.real("cot_slope") - 1) > 0.01) continue;
    measured_a.push_back(table.column("A")[k]);
    measured_r.push_back(table.column("R_HW")[k]);
  }
  if (!measured_a.empty()) panel.points("measured", measured_a, measured_r, Role::data);
}

std::vector<WantedTable> wanted(const Values& values) {
  const HallWatts law = law_of(values);
  return {{.name = "runups",
           .group = Column{"A_over_d", "1", "wave height over depth, H/h"},
           .quantities = {{.column = {"R_over_d", "1", "maximum run-up over depth, R/h"},
                           .reference = [law](Place p) { return law.runup(p.group); },
                           .requirements = {{.measure = Measure::relative_error,
                                             .criterion = Uncertainty{.data = HallWatts::scatter(),
                                                                      .useful = 0.25,
                                                                      .reason = "scatter of such experiments, assumed"},
                                             .text = "Maximum run-up agrees with the law of Hall and Watts (1953) "
                                                     "within the scatter of the experiments, 5 %.",
                                             .source = source}}}},
           .groups = {0.05, 0.1, 0.2, 0.3},
           .exact = {fmt::format("seiche exact hall_watts --set amplitude=0.1,cot_slope={}", values.real("cot_slope"))},
           .reference_role = Role::data}};
}

void hall_watts_run_up(Case& c) {
  c.title = "Run-up of solitary waves on plane beaches of 5 to 45 degrees: law of the experiments";
  c.source =
      "J. V. Hall, G. M. Watts, Laboratory investigation of the vertical rise of solitary waves on impermeable slopes, "
      "Beach Erosion Board Tech. Memo. 33 (1953)";
  c.parameters = {real("cot_slope", 2.747, "1", {1, 11.43}, "s of the beach slope 1:s")};
  c.study = exact_study<law_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::hall_watts_run_up
