/*
A solitary wave of small amplitude $a_i$ meets a wall at a small angle $\psi_i$. Miles (1977), with the parameter of
Kodama and Yeh, $\kappa = \tan\psi_i/(\sqrt{3a_i}\cos\psi_i) < 1$, found the final state: a stem of amplitude $a_w =
(1+\kappa)^2 a_i$, and a wave of $a_r = \kappa^2 a_i$ reflected at $\tan\psi_r = \sqrt{3a_i}\cos\psi_i$; the end of the
stem leaves the wall at $\tan\psi_* = (1-\kappa)\tan\psi_r/3$. Lengths are over the depth.

**What is compared.** The case shows the theory for both parameters. It accepts external results: amplitudes over the
measured incident one, angles, and the growth of the wall amplitude in the last fifth of the run. The suite's models are
evaluated in `mach_reflection`.

**What to look at.** The theory neglects terms of order $a_i$, which is the limit; configurations in which this limit
does not separate a stem from regular reflection are rejected. Small waves settle slowly, over hundreds of depths.
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::mach_reflection_theory {

using exact::MachReflection;

const std::string source = "Miles (1977); Li, Yeh and Kodama (2011)";
constexpr double degree = std::numbers::pi / 180;

MachReflection theory_of(const Values& values) {
  return {values.real("amplitude"), values.real("angle") * degree, MachReflection::Theory::kodama_yeh};
}

/// A number of the theory, and the column of it in the table of runs.
struct Number {
  WantedQuantity wanted;
  std::string tabulated;
};

/// A number that the theory knows to about `neglected`. @param other  what it is in regular reflection
WantedQuantity wanted_of(const Column& column, double expected, double neglected, double other,
                         const std::string& text) {
  return {
      .column = column,
      .reference = [expected](Place) { return expected; },
      .requirements = {
          {.measure = Measure::value,
           .criterion = Bound{.limit = Amount::at_most(neglected, 0.5 * std::abs(expected - other)),
                              .reason = "the theory neglects terms of the order of the incident amplitude over the "
                                        "depth; the limit is at most half of the difference from regular reflection",
                              .expected = expected},
           .text = text,
           .source = source}}};
}

std::vector<Number> numbers_of(const Values& values) {
  const MachReflection theory = theory_of(values);
  const double angle = values.real("angle");
  const double amplitude = values.real("amplitude");
  const double neglected = theory.theory_uncertainty();
  const double wall = theory.wall_ratio();
  const double reflected = theory.reflected_ratio();
  // In the variables of kappa; the class has Miles's leading order.
  const double slope = std::sqrt(3 * amplitude) * std::cos(angle * degree);
  const double turned = std::atan(slope) / degree;
  const double stem = std::atan((1 - theory.kappa()) * slope / 3) / degree;
  const WantedQuantity growth{
      .column = {"growth", "1", "relative growth of a_w in the last fifth of the run"},
      .reference = [](Place) { return 0.0; },
      .requirements = {
          {.measure = Measure::value,
           .criterion =
               Bound{.limit = 0.01,
                     .reason = "an approach as 1/t leaves four times this, 4 %, less than the neglected terms"},
           .text = "The growth of the stem has settled within 1 %, which leaves 4 % of an approach as 1/t.",
           .source = source}}};
  return {{wanted_of({"a_w_over_a_i", "1", "amplitude at the wall over the incident one"}, wall, neglected * wall, 2,
                     "The Mach-stem amplitude a_w/a_i agrees with theory to the order of its neglected terms."),
           "aw_over_ai"},
          {wanted_of({"a_r_over_a_i", "1", "amplitude of the reflected wave over the incident one"}, reflected,
                     neglected * reflected, 1,
                     "The reflected-wave amplitude a_r/a_i agrees with theory to the order of its neglected terms."),
           "ar_over_ai"},
          {wanted_of({"psi_r", "deg", "angle of reflection"}, turned, neglected * turned, angle,
                     "The angle at which the reflected wave leaves the wall agrees with theory."),
           "psi_r_deg"},
          {wanted_of({"stem_angle", "deg", "angle between the wall and the path of the stem's end"}, stem,
                     neglected * turned / 3, 0, "The angle at which the stem grows agrees with theory."),
           "stem_angle_deg"},
          {growth, "rel_growth_last_20pct"}};
}

struct Results {
  exact::SelfTest identities;
};

void claims(const Values& values, const Claims<Results>& claims) {
  claim_identities(claims.from(source).of(&Results::identities), theory_of(values).self_test());
  const io::Table runs = values.table("mach_reflection_model2");
  const auto rows = indices(runs.rows());
  const auto run = std::ranges::find_if(rows, [&](std::size_t k) {
    return std::abs(runs.column("a_nominal")[k] - values.real("amplitude")) < 1e-9 &&
           std::abs(runs.column("psi_i_deg")[k] - values.real("angle")) < 1e-6;
  });
  const bool found = run != rows.end();
  const auto tabulated = claims.only_if(theory_of(values).has_stem() && found,
                                        "no run with a stem is tabulated at this amplitude and angle");
  for (const Number& one : numbers_of(values)) {
    const Requirement& required = one.wanted.requirements.front();
    tabulated.from(source).check(
        "tabulated-" + one.wanted.column.name, "A run of the 2DH model: " + required.text,
        fmt::format("{} [{}]", one.wanted.column.meaning, one.wanted.column.unit),
        [value = found ? runs.column(one.tabulated)[*run] : 0.0](const Results&) { return value; }, required.criterion);
  }
}

Results compute(const Run& run) {
  return {theory_of(run).self_test()};
}

void show(const Results& /*results*/, const Values& values, evidence::Exhibit& exhibit) {
  const double amplitude = values.real("amplitude");
  exhibit.measure("kappa", theory_of(values).kappa());
  auto& panel = add_panel(exhibit, "wall", "Amplitude at the wall",
                          fmt::format("Over the incident one, a = {:g} h, by both parameters.", amplitude),
                          {.x = "angle [deg]", .y = "a_w/a_i"});
  const std::vector<double> angles = evenly(1, 60, 237);
  for (const auto& [theory, label] : {std::pair{MachReflection::Theory::miles, "Miles"},
                                      std::pair{MachReflection::Theory::kodama_yeh, "Kodama and Yeh"}}) {
    std::vector<double> ratio = each(
        angles, [&](const double angle) { return MachReflection(amplitude, angle * degree, theory).wall_ratio(); });
    panel.line(label, angles, ratio, Role::guide);
  }
}

std::vector<WantedTable> wanted(const Values& values) {
  const MachReflection theory = theory_of(values);
  if (!theory.has_stem()) {
    throw std::invalid_argument(
        fmt::format("angle = {:g} is out of range: kappa = {:.3g} must be less than 1, or no stem grows",
                    values.real("angle"), theory.kappa()));
  }
  WantedTable table{.name = "numbers", .quantities = {}, .reference_role = evidence::Role::guide};
  for (const Number& one : numbers_of(values)) table.quantities.push_back(one.wanted);
  return {table};
}

void mach_reflection_theory(Case& c) {
  c.title = "Mach reflection of a small solitary wave: theory, accurate to the amplitude, 10 %";
  c.source =
      literature::miles +
      "; W. Li, H. Yeh, Y. Kodama, On the Mach reflection of a solitary wave: revisited, J. Fluid Mech. 672 (2011) 326";
  c.parameters = {
      real("amplitude", 0.097, "depth", {0.001, 0.8}, "a_i of the incident wave"),
      real("angle", 20.0, "deg", {1, 75}, "psi_i between wave direction and wall"),
  };
  c.study = Study(claims, compute, show);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::mach_reflection_theory
