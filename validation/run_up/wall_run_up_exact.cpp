/*
A solitary wave of the full Euler equations runs against a vertical wall: the same flow as the head-on collision of two
equal waves. The maximum run-up follows from fully nonlinear potential flow, started from two exact solitary waves and
computed with a spectral boundary-integral method.

**What is compared.** The case computes the run-up for a sequence of amplitudes with two resolutions and shows it beside
the series of Su and Mirie, $R = 2a + a^2/2 + 3a^3/4$, and of Byatt-Smith, $R = 2a + a^2/2$. It accepts external
results: the maximum elevation at the wall.

**What to look at.** The series are accurate to 1 % up to $a \approx 0.45$; beyond, the water rises at the wall as a
thin sheet, and the exact values depart from every series.
*/
#include <memory>

#include <fmt/format.h>

#include "seiche/exact/overturning/wall_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::wall_run_up_exact {

const std::string source = "Su and Mirie (1980); Cooker, Weidman and Bale (1997)";

struct Results {
  double runup = 0;
  double uncertainty = 0;
  exact::SelfTest identities;
};

void claims(const Values& values, const Claims<Results>& claims) {
  claim_identities(claims.from(source).of(&Results::identities),
                   exact::WallRunup::identities(values.real("amplitude") / values.real("depth")));
}

Results compute(const Run& run) {
  const exact::WallRunup wall(run.real("amplitude"), run.real("depth"));
  return {.runup = wall.runup(), .uncertainty = wall.uncertainty(), .identities = wall.self_test()};
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const double depth = values.real("depth");
  const double amplitude = values.real("amplitude");
  exhibit.measure("reference_uncertainty", r.uncertainty);
  exhibit.measure("runup", r.runup);
  exhibit.measure("su_mirie", exact::WallRunup::su_mirie(amplitude, depth));

  const io::Table table = values.table("wall_runup_exact");
  const std::vector<double>& a = table.column("a");
  const std::vector<double> fine = evenly(0.05, a.back(), 101);
  auto& panel = add_panel(
      exhibit, "runup", "Run-up over amplitude",
      fmt::format("Exact values (tabulated, and this run's at a = {:g} depth) beside the series.", amplitude / depth),
      {.x = "amplitude/depth", .y = "run-up/amplitude"});
  panel.points("exact, tabulated", a, quotients(table.column("R"), a), Role::exact);
  panel.points("this run", std::vector{amplitude / depth}, std::vector{r.runup / amplitude}, Role::computed);
  panel.line("Su and Mirie", fine, each(fine, [](double at) { return exact::WallRunup::su_mirie(at) / at; }),
             Role::guide);
  panel.line("Byatt-Smith", fine, each(fine, [](double at) { return exact::WallRunup::byatt_smith(at) / at; }),
             Role::guide);
}

std::vector<WantedTable> wanted(const Values& values) {
  const double amplitude = values.real("amplitude");
  const double depth = values.real("depth");
  const std::function<double()> runup = [=] { return exact::WallRunup(amplitude, depth).runup(); };
  return {
      {.name = "numbers",
       .quantities = {wanted_number(
           {"runup", "m", "maximum elevation at the wall"}, runup, values,
           "The run-up agrees with fully nonlinear potential flow within the tolerance, by default 3.5 %.", source)},
       .exact = {fmt::format("seiche exact wall_runup --set amplitude={},depth={}", values.real("amplitude"),
                             values.real("depth"))}}};
}

void wall_run_up_exact(Case& c) {
  c.former_names = {"wall_runup"};
  c.title = "Run-up of a solitary wave on a vertical wall: fully nonlinear potential flow";
  c.source = literature::su_mirie + "; M. J. Cooker, P. D. Weidman, D. S. Bale, J. Fluid Mech. 342 (1997) 141";
  c.parameters = {
      real("amplitude", 0.3, "m", {1e-6, 1e6}, "of the incident wave, 0.05 to 0.6 depth"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::wall_run_up_exact
