/*
What the height of a Mach stem owes to the lattice, the step, the window and the solver. A solitary wave, $a_i = 0.3$ of
the depth, meets a wall at 30 degrees; its stem is still growing. Lengths are in depths, times in
$\sqrt{\text{depth}/g}$. Set-up: `mach_reflection`, plan model.

**What is compared.** $a_w$ near the end. Five lattices, each finer by $\sqrt2$, with equal steps; five steps on equal
lattices. If $a_w = a + b h^p$, then so are the differences of neighbours. Then a window twice as high and a solver a
thousand times more accurate. And a value that an independent implementation gives.

**What to look at.** Wide cells make the stem too low, long steps too high. With steps of half the spacing, as in all
cases of Mach reflection, the two nearly cancel: its error is then smaller than that of either alone, and does not
follow a power of $h$.
*/
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/mach_reflection/reflection_reference.hpp"
#include "validation/mach_reflection/reflection_run.hpp"
#include "validation/case/on_threads.hpp"
#include "reports/evidence/slope_guide.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;

const std::string source = "Frank (1994), section 4.3";

struct Variant {
  std::string id, text;
  ReflectionRun run;
};

/// Runs that differ in one size, by factors of sqrt(2).
struct Ladder {
  std::string id, text, axis;
  std::vector<double> size, wall;
};

void claim_order(evidence::Record& record, evidence::Figure& figure, const Ladder& ladder) {
  std::vector<double> size, difference;
  for (std::size_t k = 0; k + 1 < ladder.size.size(); ++k) {
    size.push_back(ladder.size[k]);
    difference.push_back(std::abs(ladder.wall[k] - ladder.wall[k + 1]));
  }
  record.check({.id = "order-" + ladder.id,
                .text = fmt::format("The height of the stem converges with second order in the {}.", ladder.text),
                .quantity = "observed order of the differences between neighbours",
                .source = source},
               evidence::observed_order(size, difference),
               evidence::Order{2, 0.5,
                               "the scheme's order; half an order for the coarsest, on which a stem is four to "
                               "six spacings wide"});
  auto& panel = figure.panel({.x = ladder.axis, .y = "difference of a_w [depth]", .log_x = true, .log_y = true});
  panel.points("computed", size, difference);
  slope_guide(panel, 2, size, 0.6 * difference.back());
}

void claim_same(evidence::Record& record, const Variant& variant, const Reflection& usual, const Reflection& other) {
  const evidence::Measurement a = usual.wall_ratio();
  const evidence::Measurement b = other.wall_ratio();
  record.check({.id = variant.id,
                .text = fmt::format("With {} the stem is as high.", variant.text),
                .quantity = "difference of a_w/a_i",
                .source = source},
               {.value = b.value - a.value, .resolution = other.run.resolution()},
               Bound{.limit = std::hypot(a.half_width(), b.half_width()),
                     .reason = "the scatter of the incident amplitude along its crest, in both runs"});
}

void claim_known(evidence::Record& record, const Reflection& usual) {
  constexpr double known = 0.81483;
  constexpr double parabola = 0.007;
  record.check(
      {.id = "independent",
       .text = "At h = 0.5 the stem is as high as by an independent program.",
       .quantity = "a_w",
       .unit = "depth",
       .source = independent_reflections},
      {.value = usual.wall.back(), .resolution = usual.run.resolution()},
      Bound{.limit = parabola * known,
            .reason = "0.7 %: what a parabola through three nodes, its way to find the crest, makes of a stem of "
                      "this height on such a lattice",
            .expected = known});
}

void run(Running& run) {
  const double end = run.real("time");
  const ReflectionRun base{.amplitude = 0.3, .angle = radians(30), .spacing = 0.5, .time = end};
  const ObliqueWave wave(base.amplitude, base.angle);
  constexpr std::size_t rungs = 5;
  std::vector<Variant> variants;
  Ladder lattices{"lattice", "spacing", "h [depth]", {}, {}};
  Ladder steps{"step", "step", "tau [sqrt(depth/g)]", {}, {}};
  for (std::size_t k = 0; k < rungs; ++k) {
    variants.push_back({"", "", base});
    lattices.size.push_back(1.4 * std::pow(0.5, 0.5 * static_cast<double>(k)));
    variants.back().run.spacing = lattices.size.back();
    variants.back().run.step = 0.125 / lattices.size.back();
  }
  for (std::size_t k = 0; k < rungs; ++k) {
    variants.push_back({"", "", base});
    variants.back().run.spacing = 0.7;
    variants.back().run.step = std::pow(0.5, 0.5 * static_cast<double>(k));
    steps.size.push_back(variants.back().run.tau());
  }
  variants.push_back({"usual", "", base});
  variants.push_back({"window", "a window twice as high", base});
  variants.back().run.height = 2 * window_until(end, wave, base.spacing).height;
  variants.push_back({"solver", "a solver with a tolerance of 1e-10", base});
  variants.back().run.tolerance = 1e-10;

  std::vector<Reflection> reflections(variants.size());
  on_threads(
      variants.size(), workers_of(run.tier()), [&](std::size_t k) { reflections[k] = reflect(variants[k].run); },
      [&](std::size_t finished) {
        run.progress(static_cast<double>(finished) / static_cast<double>(variants.size()));
      });

  // Values of a_w are means that end at the end; this is before the last of them.
  const double when = 0.95 * end;
  auto& figure = run.record.figure("orders", "Differences between neighbours", fmt::format("a_w at t = {:g}.", when));
  for (std::size_t k = 0; k < rungs; ++k) {
    lattices.wall.push_back(reflections[k].wall_at(when));
    steps.wall.push_back(reflections[rungs + k].wall_at(when));
    run.record.measure(fmt::format("a_w_h_{:.3f}", lattices.size[k]), lattices.wall[k]);
    run.record.measure(fmt::format("a_w_tau_{:.3f}", steps.size[k]), steps.wall[k]);
  }
  claim_order(run.record, figure, lattices);
  claim_order(run.record, figure, steps);
  const Reflection& usual = reflections[2 * rungs];
  run.record.measure("a_w", usual.wall.back());
  for (std::size_t k = 2 * rungs + 1; k < variants.size(); ++k) {
    claim_same(run.record, variants[k], usual, reflections[k]);
  }
  if (end == 120) claim_known(run.record, usual);
}

}  // namespace

Case mach_reflection_convergence() {
  Case c;
  c.title = "Mach reflection: lattice, step, window and solver";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 4.3";
  c.tiers = {Tier::full};
  c.parameters = {real("time", {40, 120, 120}, "sqrt(depth/g)", {40, 1000}, "when the stem is measured")};
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
