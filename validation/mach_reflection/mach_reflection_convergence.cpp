/*
Sensitivity of the Mach-stem amplitude to grid, step, window and solver. A solitary wave of $a_i = 0.3$ meets a wall at
30 degrees; its stem is still growing. Lengths are over the depth, times over $\sqrt{\text{depth}/g}$. Set-up:
`mach_reflection`, 2DH model.

**What is compared.** $a_w$ near the end. Five grids, refined by $\sqrt2$, at equal steps; five steps on equal grids. If
$a_w = a + b h^p$, the differences between neighbours follow the same power. Then a window twice as high and a solver
tolerance a thousand times smaller.

**What to look at.** Coarse cells underestimate the stem, long steps overestimate it. With steps of half the spacing, as
in all cases of Mach reflection, the two errors nearly cancel: the remaining error is smaller than either, and does not
follow a power of $h$.
*/
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation::cases::mach_reflection_convergence {

const std::string source = "Frank (1994), section 4.3";

/// Runs that differ in one size, by factors of sqrt(2).
struct Ladder {
  std::string id, text, axis;
  std::vector<double> size = {}, wall = {};

  /// Changes from one to the next finer one.
  [[nodiscard]] std::vector<double> differences() const {
    std::vector<double> differences;
    for (std::size_t k = 0; k + 1 < wall.size(); ++k) differences.push_back(std::abs(wall[k] - wall[k + 1]));
    return differences;
  }
  [[nodiscard]] std::vector<double> coarser() const { return {size.begin(), size.end() - 1}; }
};

struct Results {
  Ladder lattices{"lattice", "spacing", "h [depth]"};
  Ladder steps{"step", "step", "tau [sqrt(depth/g)]"};
  Reflection usual, window, solver;
};

constexpr std::size_t rungs = 5;
constexpr double tolerance = 1e-7;  // of the solver, as usual

ReflectionRun usual_run(const Values& values) {
  return {.amplitude = 0.3, .angle = radians(30), .spacing = 0.5, .time = values.real("time"), .tolerance = tolerance};
}

/// Values of a_w are means that end at the end; this is before the last of them.
double when(const Values& values) {
  return 0.95 * values.real("time");
}

void claim_order(const Claims<Ladder>& claims, const Ladder& ladder) {
  claims.check(
      "order-" + ladder.id, fmt::format("The stem amplitude converges at second order in the {}.", ladder.text),
      "observed order of the differences between neighbours",
      [](const Ladder& l) { return evidence::observed_order(l.coarser(), l.differences()); },
      Order{2, 0.5,
            "the scheme's order; half an order for the coarsest grid, on which a stem is four to six spacings wide"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_order(claims.of(&Results::lattices), Results{}.lattices);
  claim_order(claims.of(&Results::steps), Results{}.steps);
  const double steps = values.real("time") / usual_run(values).tau();
  claims.check(
      "window", "The stem amplitude a_w/a_i in a window twice as high agrees with the reference run within 0.01.",
      "difference of a_w/a_i",
      [](const Results& r) -> Measurement {
        const Measurement a = r.usual.wall_ratio();
        const Measurement b = r.window.wall_ratio();
        return {.value = b.value - a.value,
                .resolution = r.window.run.resolution(),
                .told = {.limit = std::hypot(a.half_width(), b.half_width())}};
      },
      Bound{.limit = Amount::told_by_run(0.03),
            .reason = "the scatter of the incident amplitude along its crest, in both runs; 1 % of a_w/a_i at most, "
                      "about the grid error"});
  claims.at([](const Results& r) { return r.solver.run.resolution(); })
      .check(
          "solver",
          "The stem amplitude a_w/a_i with a solver tolerance of 1e-10 agrees with the one for 1e-7 within the solver "
          "error.",
          "difference of a_w/a_i",
          [](const Results& r) { return r.solver.wall_ratio().value - r.usual.wall_ratio().value; },
          Bound{.limit = 4 * tolerance * std::sqrt(steps),
                .reason = "a_w/a_i, 4 at most, to the usual tolerance of 1e-7; step errors add like random ones"});
}

Results compute(const Run& run) {
  Results r;
  const ReflectionRun base = usual_run(run);
  std::vector<ReflectionRun> runs(2 * rungs + 3, base);
  for (std::size_t k = 0; k < rungs; ++k) {
    const double part = std::pow(0.5, 0.5 * static_cast<double>(k));
    ReflectionRun& finer = runs[k];
    finer.spacing = 1.4 * part;
    finer.step = 0.125 / finer.spacing;
    r.lattices.size.push_back(finer.spacing);
    ReflectionRun& shorter = runs[rungs + k];
    shorter.spacing = 0.7;
    shorter.step = part;
    r.steps.size.push_back(shorter.tau());
  }
  const ObliqueWave wave(base.amplitude, base.angle);
  runs[2 * rungs + 1].height = 2 * window_until(base.time, wave, base.spacing).height;
  runs[2 * rungs + 2].tolerance = 1e-10;

  std::vector<Reflection> reflections(runs.size());
  on_threads(run, runs.size(), [&](std::size_t k) { reflections[k] = reflect(runs[k]); });
  for (std::size_t k = 0; k < rungs; ++k) {
    r.lattices.wall.push_back(reflections[k].wall_at(when(run)));
    r.steps.wall.push_back(reflections[rungs + k].wall_at(when(run)));
  }
  r.usual = reflections[2 * rungs];
  r.window = reflections[2 * rungs + 1];
  r.solver = reflections[2 * rungs + 2];
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("orders", "Differences between neighbours", fmt::format("a_w at t = {:g}.", when(values)));
  for (const Ladder* ladder : {&r.lattices, &r.steps}) {
    auto& panel = figure.panel({.x = ladder->axis, .y = "difference of a_w [depth]", .log_x = true, .log_y = true});
    panel.points("computed", ladder->coarser(), ladder->differences());
    slope_guide(panel, 2, ladder->coarser(), 0.6 * ladder->differences().back());
  }
  exhibit.measure("a_w", r.usual.wall.back());
}

void mach_reflection_convergence(Case& c) {
  c.title = "Mach reflection: sensitivity to grid, step, window and solver";
  c.source = literature::frank + ", section 4.3";
  c.tiers = {Tier::full};
  c.parameters = {real("time", {40, 120, 120}, "sqrt(depth/g)", {40, 1000}, "time at which the stem is measured")};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::mach_reflection_convergence
