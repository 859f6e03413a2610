/*
How the triple configuration of Mach reflection develops: figure 6 of Frank (1994). A solitary wave, $a_i = 0.3$ of the
depth, meets the wall $y = 0$ at 30 degrees. It is regular at first: incident and reflected crest meet at the wall. Then
they part from it, and between them and the wall stands the stem, which grows in length for ever and in height up to a
limit. Lengths are in depths, times in $\sqrt{\text{depth}/g}$.

**Set-up.** As in `mach_reflection`, plan model.

**What is compared.** The growth with a straight line: far from the wall's beginning the pattern is self-similar, its
length grows in proportion to the path. The speed of the crest on the wall with that of Serre's solitary wave of the
stem's height, $\sqrt{1 + a_w}$: the stem is such a wave. And with the incident crest, whose trace on any line parallel
to the wall runs at $c_i/\cos\psi_i$, slower than the stem: that is why the stem grows.

**What to look at.** Three crests meet away from the wall. The reflected one is lower than the incident one and makes a
larger angle with the wall. Along the stem the height hardly changes.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/case.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;

const std::string source = "Frank (1994), section 4.3, figure 6";
constexpr double between_patterns = 5;  // time

/// What is seen of the pattern on its way.
struct Development {
  std::vector<double> time, wall_x, height, length;

  /// Of the last half, where the stem has parted from the wall's beginning.
  [[nodiscard]] std::span<const double> late(const std::vector<double>& values) const {
    return std::span(values).subspan(values.size() / 2);
  }
};

std::string resolution_of(const Run& run) {
  return fmt::format("h = {:g}, tau = {:g}", run.real("h"), 0.5 * run.real("h"));
}

Development develop(Running& run, const ObliqueWave& wave) {
  const double end = run.real("time");
  auto flow = reflection_flow(wave, window_until(end, wave, run.real("h")), {.tolerance = 1e-7});
  auto& perspective =
      run.record.figure("perspective", "Development of the triple configuration",
                        fmt::format("a_i = {:g}, {:g} deg, {}. The wall is in front; x from the crest on the wall.",
                                    wave.amplitude(), run.real("angle"), resolution_of(run)),
                        {"frank-fig-6"});
  auto& plan = run.record.figure("plan", "The same from above",
                                 "Elevation; x from the crest on the wall, all times on the same scales.");
  const double unit = wave.width_unit();
  const exact::MachReflection theory(wave.amplitude(), wave.angle(), exact::MachReflection::Theory::kodama_yeh);
  const double highest = theory.wall_ratio() * wave.amplitude();
  Development development;
  double shown = 0;
  for (double t = between_patterns; t < end + 1e-9; t += between_patterns) {
    flow.advance_to(t, 0.5 * run.real("h"));
    const SurfaceLattice surface = surface_of(flow);
    const ReflectionPattern pattern = measured_reflection(surface, wave.amplitude());
    development.time.push_back(t);
    development.wall_x.push_back(pattern.wall.x);
    development.height.push_back(five_node_height(surface, pattern.wall, 0));
    development.length.push_back(pattern.stem_length.value);
    // Each picture at more than twice the time of the one before, the last at the end.
    if ((t >= 2.4 * shown + 10 && t <= 0.5 * end) || t > end - 1e-9) {
      shown = t;
      const SurfacePart part =
          part_of(surface, {pattern.wall.x - 22 * unit, pattern.wall.x + 32 * unit, 45 * unit}, pattern.wall.x);
      evidence::Axes axes{.x = "x [depth]",
                          .y = "y [depth]",
                          .z = "elevation [depth]",
                          .title = fmt::format("t = {:g}", t),
                          .z_min = -0.05 * highest,
                          .z_max = highest};
      plan.panel(axes).plan("elevation", part.lattice());
      axes.view = {.azimuth = -60, .elevation = 32, .exaggeration = std::nullopt};
      perspective.panel(axes).surface("water", part.lattice());
    }
    run.progress(t / end);
  }
  return development;
}

void claim_growth(Running& run, const Development& development) {
  const evidence::Measurement angle =
      stem_angle(development.late(development.wall_x), development.late(development.length));
  const std::size_t half = development.late(development.length).size() / 2;
  const auto part = [&](const std::vector<double>& values, bool second) {
    return second ? development.late(values).subspan(half) : development.late(values).first(half);
  };
  const double before = stem_angle(part(development.wall_x, false), part(development.length, false)).value;
  const double after = stem_angle(part(development.wall_x, true), part(development.length, true)).value;
  run.record.measure("stem_angle", degrees(angle.value));
  run.record.measure("stem_length", development.length.back());
  run.record.check(
      {.id = "straight",
       .text = "The stem's length grows in proportion to the path: the third and the last quarter of it "
               "give the same angle.",
       .quantity = "difference of the angles over the angle",
       .source = source},
      {.value = (after - before) / angle.value, .resolution = resolution_of(run)},
      Bound{.limit = 0.1,
            .reason = "a tenth of the angle: what the stem's height still lacks in the third quarter, up to "
                      "1 %, changes the speeds whose difference makes the stem grow by a tenth of it"});
}

void claim_speed(Running& run, const Development& development) {
  const StraightLine path = straight_line(development.late(development.time), development.late(development.wall_x));
  const double height = development.height.back();
  const double speed = std::sqrt(1 + height);
  const double width = std::sqrt(0.75 * height / (1 + height));
  run.record.measure("wall_speed", path.slope);
  run.record.measure("a_w", height);
  run.record.check(
      {.id = "speed",
       .text = "The crest on the wall is as fast as Serre's solitary wave of its height.",
       .quantity = "speed over sqrt(1 + a_w), less 1",
       .source = "Serre (1953)"},
      {.value = path.slope / speed - 1, .uncertainty = path.slope_error / speed, .resolution = resolution_of(run)},
      Bound{.limit = std::pow(run.real("h") * width, 2) / 12,
            .reason = "(h K)^2/12, K^2 = 3a/(4(1 + a)): the leading dispersion error of the lattice for a "
                      "wave as narrow as the stem"});
}

void draw_growth(Running& run, const ObliqueWave& wave, const Development& development) {
  auto& figure = run.record.figure("growth", "Growth of the stem",
                                   fmt::format("{}. Height on the wall and length.", resolution_of(run)));
  std::vector<double> ratio = development.height;
  for (double& value : ratio) value /= wave.amplitude();
  figure.panel({.x = "t [sqrt(depth/g)]", .y = "a_w/a_i"}).line("height", development.time, ratio);
  auto& length = figure.panel({.x = "t [sqrt(depth/g)]", .y = "length [depth]"});
  length.line("length", development.time, development.length);
  const StraightLine line = straight_line(development.late(development.time), development.late(development.length));
  length.line("straight line through the last half", std::vector{0.0, development.time.back()},
              std::vector{line.at(0), line.at(development.time.back())}, Role::guide);
}

void run(Running& run) {
  const ObliqueWave wave(run.real("amplitude"), radians(run.real("angle")));
  const Development development = develop(run, wave);
  claim_growth(run, development);
  claim_speed(run, development);
  draw_growth(run, wave, development);
}

}  // namespace

Case mach_stem_growth() {
  Case c;
  c.title = "Growth of a Mach stem";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 4.3, figure 6";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.3, "depth", {0.01, 0.55}, "a_i of the incident wave"),
      real("angle", 30.0, "deg", {5, 75}, "psi_i between the wave's direction and the wall"),
      real("h", {1, 0.5, 0.35}, "depth", {0.1, 1.25}, "spacing of the lattice at rest; steps are half of it"),
      real("time", 300.0, "sqrt(depth/g)", {100, 20000}, "how long"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
