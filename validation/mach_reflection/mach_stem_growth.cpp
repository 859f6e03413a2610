/*
Development of the triple configuration of Mach reflection: figure 6 of Frank (1994). A solitary wave of $a_i = 0.3$
meets the wall $y = 0$ at 30 degrees. Reflection is regular at first: incident and reflected crest meet at the wall.
Then the crests leave the wall, connected to it by the stem, whose length grows indefinitely and whose amplitude tends
to a limit. Lengths are over the depth, times over $\sqrt{\text{depth}/g}$.

**Set-up.** As in `mach_reflection`, 2DH model.

**What is compared.** The growth with a straight line: far from the start of the wall the pattern is self-similar, and
its length grows in proportion to the path. The speed of the crest at the wall with Serre's solitary wave of the stem
amplitude, $\sqrt{1 + a_w}$, and with the trace of the incident crest on any line parallel to the wall,
$c_i/\cos\psi_i$, which is slower; the stem grows by this difference.

**What to look at.** Three crests meet away from the wall. The reflected crest is lower than the incident one and makes
a larger angle with the wall. The amplitude is nearly constant along the stem.
*/
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation::cases::mach_stem_growth {

const std::string source = "Frank (1994), section 4.3, figure 6";
constexpr double between_patterns = 5;  // time

/// What is seen of the pattern on its way.
struct Development {
  struct Picture {
    double time;
    SurfacePart surface;
  };

  std::vector<double> time, wall_x, height, length;
  std::vector<Picture> pictures, film;

  /// Of the last half, where the stem has parted from the wall's beginning.
  [[nodiscard]] std::span<const double> late(const std::vector<double>& values) const {
    return std::span(values).subspan(values.size() / 2);
  }
  [[nodiscard]] Measurement angle() const { return stem_angle(late(wall_x), late(length)); }
  /// Of the last quarter less that of the third.
  [[nodiscard]] double change_of_angle() const {
    const auto x = late(wall_x);
    const auto y = late(length);
    const std::size_t half = y.size() / 2;
    return stem_angle(x.subspan(half), y.subspan(half)).value - stem_angle(x.first(half), y.first(half)).value;
  }
  /// Of the crest on the wall.
  [[nodiscard]] StraightLine path() const { return straight_line(late(time), late(wall_x)); }
};

ObliqueWave wave_of(const Values& values) {
  return {values.real("amplitude"), radians(values.real("angle"))};
}

std::string resolution_of(const Values& values) {
  return fmt::format("h = {:g}, tau = {:g}", values.real("h"), 0.5 * values.real("h"));
}

void claims(const Values& values, const Claims<Development>& all) {
  const Claims<Development> claims = all.at(resolution_of(values));
  claims.check(
      "straight",
      "The stem length grows in proportion to the path: the angles over the third and the last quarter agree within 10 "
      "%.",
      "difference of the angles over the angle",
      [](const Development& d) { return d.change_of_angle() / d.angle().value; },
      Bound{.limit = 0.1,
            .reason = "a tenth of the angle: the missing stem amplitude in the third quarter, up to 1 %, changes the "
                      "difference of speeds by which the stem grows by a tenth"});
  claims.from("Serre (1953)")
      .check(
          "speed", "The speed of the crest on the wall agrees with Serre's solitary wave of its height.",
          "speed over sqrt(1 + a_w), minus 1",
          [h = values.real("h")](const Development& d) -> Measurement {
            const double height = d.height.back();
            const double speed = std::sqrt(1 + height);
            const double width = std::sqrt(0.75 * height / (1 + height));
            const StraightLine path = d.path();
            return {.value = path.slope / speed - 1,
                    .uncertainty = path.slope_error / speed,
                    .told = {.limit = std::pow(h * width, 2) / 12}};
          },
          // K^2 is less than 3/4 for waves of any height.
          Bound{.limit = Amount::told_by_run(std::pow(values.real("h"), 2) / 16),
                .reason = "(h K)^2/12, K^2 = 3a/(4(1 + a)): the leading dispersion error of the grid for a wave of the "
                          "width of the stem"});
}

/// Throws std::runtime_error, with the time, for a surface without the crests of one.
ReflectionPattern pattern_at(double time, const SurfaceLattice& surface, double amplitude) {
  try {
    return measured_reflection(surface, amplitude);
  } catch (const std::runtime_error& failure) {
    throw std::runtime_error(fmt::format("t = {:g}: {}", time, failure.what()));
  }
}

Development compute(const Run& run) {
  const ObliqueWave wave = wave_of(run);
  const double end = run.real("time");
  const double unit = wave.width_unit();
  auto flow = reflection_flow(wave, window_until(end, wave, run.real("h")), {.tolerance = 1e-7});
  Development development;
  double shown = 0;
  for (double t = between_patterns; t < end + 1e-9; t += between_patterns) {
    march(flow, t, 0.5 * run.real("h"));
    const SurfaceLattice surface = surface_of(flow);
    const ReflectionPattern pattern = pattern_at(t, surface, wave.amplitude());
    development.time.push_back(t);
    development.wall_x.push_back(pattern.wall.x);
    development.height.push_back(five_node_height(surface, pattern.wall, 0));
    development.length.push_back(pattern.stem_length.value);
    const auto picture = [&]() -> Development::Picture {
      return {t, part_of(surface, {pattern.wall.x - 22 * unit, pattern.wall.x + 32 * unit, 45 * unit}, pattern.wall.x)};
    };
    if (development.time.size() % 3 == 0) development.film.push_back(picture());
    // Each picture at more than twice the time of the one before, the last at the end.
    if ((t >= 2.4 * shown + 10 && t <= 0.5 * end) || t > end - 1e-9) {
      shown = t;
      development.pictures.push_back(picture());
    }
    run.progress(t / end);
  }
  return development;
}

void draw_pictures(evidence::Exhibit& exhibit, const Values& values, const Development& development) {
  const ObliqueWave wave = wave_of(values);
  auto& perspective =
      exhibit.figure("perspective", "Development of the triple configuration",
                     fmt::format("a_i = {:g}, {:g} deg, {}. The wall is in front; x from the crest on the wall.",
                                 wave.amplitude(), values.real("angle"), resolution_of(values)),
                     {"frank-fig-6"});
  auto& plan = exhibit.figure("plan", "Growth of the stem from above",
                              "Elevation; x from the crest on the wall, all times on the same scales.");
  using exact::MachReflection;
  const double highest =
      MachReflection(wave.amplitude(), wave.angle(), MachReflection::Theory::kodama_yeh).wall_ratio() *
      wave.amplitude();
  plan.drawing = "film";
  const auto axes_of = [&](const Development::Picture& picture) -> evidence::Axes {
    return {.x = "x [depth]",
            .y = "y [depth]",
            .z = "elevation [depth]",
            .title = fmt::format("t = {:g}", picture.time),
            .z_min = -0.05 * highest,
            .z_max = highest};
  };
  for (const Development::Picture& picture : development.film) {
    plan.panel(axes_of(picture)).plan("elevation", picture.surface.lattice());
  }
  for (const Development::Picture& picture : development.pictures) {
    evidence::Axes axes = axes_of(picture);
    axes.view = {.azimuth = -60, .elevation = 32, .exaggeration = std::nullopt};
    perspective.panel(axes).surface("water", picture.surface.lattice());
  }
}

void show(const Development& development, const Values& values, evidence::Exhibit& exhibit) {
  draw_pictures(exhibit, values, development);
  exhibit.measure("stem_angle", degrees(development.angle().value));
  exhibit.measure("stem_length", development.length.back());
  exhibit.measure("wall_speed", development.path().slope);
  exhibit.measure("a_w", development.height.back());
  auto& figure = exhibit.figure("growth", "Growth of the stem",
                                fmt::format("{}. Height on the wall and length.", resolution_of(values)));
  figure.panel({.x = "t [sqrt(depth/g)]", .y = "a_w/a_i"})
      .line("height", development.time,
            each(development.height, [&](double height) { return height / values.real("amplitude"); }));
  auto& length = figure.panel({.x = "t [sqrt(depth/g)]", .y = "length [depth]"});
  length.line("length", development.time, development.length);
  const StraightLine line = straight_line(development.late(development.time), development.late(development.length));
  length.line("straight line through the last half", std::vector{0.0, development.time.back()},
              std::vector{line.at(0), line.at(development.time.back())}, Role::guide);
}

void mach_stem_growth(Case& c) {
  c.title = "Growth of a Mach stem";
  c.source = literature::frank + ", section 4.3, figure 6";
  c.parameters = {
      real("amplitude", 0.3, "depth", {0.01, 0.55}, "a_i of the incident wave"),
      real("angle", 30.0, "deg", {5, 75}, "psi_i between wave direction and wall"),
      real("h", {1, 0.5, 0.35}, "depth", {0.1, 1.25}, "initial grid spacing; steps are half of it"),
      real("time", 300.0, "sqrt(depth/g)", {100, 20000}, "how long"),
  };
  c.published = {{.tiles = {"frank-fig-6"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::mach_stem_growth
