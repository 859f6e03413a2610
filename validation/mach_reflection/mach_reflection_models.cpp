/*
The same reflections by two models of Frank (1994, chapter 4): water columns seen from above, whose waves are those of
the Green-Naghdi equations, and layers of Lagrangian hexahedra, which tend to the full equations. Lengths are in depths,
times in $\sqrt{\text{depth}/g}$.

**Set-up.** As in `mach_reflection`. Both models start from Serre's solitary wave, which is nearly exact for the columns
only: the hexahedra shed some of it. So amplitudes are taken over the measured incident one.

**What is compared.** Amplitudes at the wall and of the reflected wave, and its angle. The models with each other on the
same lattice.

**What to look at.** The models agree within 4 to 6 %, which is what they differ in physics and lattice. Next to
resonance both stems still grow at the end.
*/
#include <cmath>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation::cases::mach_reflection_models {
namespace {

const std::string source = "Frank (1994), section 4.3";

struct Configuration {
  double amplitude, angle, spacing, time;

  [[nodiscard]] std::string id() const { return fmt::format("{}-{:.0f}", id_of(amplitude), angle); }
  [[nodiscard]] std::string text() const { return fmt::format("a = {:g}, {:g} deg", amplitude, angle); }
};

std::vector<Configuration> configurations(const Values& values) {
  if (values.tier() == Tier::quick) return {{.amplitude = 0.3, .angle = 30, .spacing = 1, .time = 160}};
  return {{0.3, 30, 0.7, 400}, {0.186, 25, 0.9, 500}, {0.3, 36, 0.7, 400}};
}

struct Pair {
  Configuration configuration;
  Reflection columns, hexahedra;
};
using Results = std::vector<Pair>;

void claim_models(const Claims<Pair>& claims, const Configuration& configuration) {
  claims.check(
      "models-" + configuration.id(),
      fmt::format("{}: the two models have nearly the same amplitude at the wall.", configuration.text()),
      "a_w/a_i of the hexahedra over that of the columns, less 1",
      [](const Pair& pair) -> Measurement {
        const Measurement layered = pair.hexahedra.wall_ratio();
        const Measurement columns = pair.columns.wall_ratio();
        return {.value = layered.value / columns.value - 1,
                .uncertainty = std::hypot(layered.half_width(), columns.half_width()) / columns.value,
                .resolution = pair.hexahedra.run.resolution()};
      },
      Bound{.limit = 0.06, .reason = "an earlier program finds 4 to 6 % between the two models"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<Configuration> all = configurations(values);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto pair = claims.of([k](const Results& r) -> const Pair& { return r.at(k); });
    claim_models(pair, all[k]);
  }
}

Results compute(const Run& run) {
  Results pairs;
  for (const Configuration& one : configurations(run)) pairs.push_back({one, {}, {}});
  const std::size_t count = 2 * pairs.size();
  on_threads(
      count, workers_of(run.tier()),
      [&](std::size_t k) {
        Pair& pair = pairs[k % pairs.size()];
        const bool layered = k < pairs.size();
        ReflectionRun what{.amplitude = pair.configuration.amplitude,
                           .angle = radians(pair.configuration.angle),
                           .spacing = pair.configuration.spacing,
                           .time = pair.configuration.time,
                           .model = layered ? WaveModel::hexahedra : WaveModel::plan,
                           .layers = static_cast<std::size_t>(run.integer("layers")),
                           .tolerance = layered ? 1e-6 : 1e-7};
        (layered ? pair.hexahedra : pair.columns) = reflect(what);
      },
      [&](std::size_t finished) { run.progress(static_cast<double>(finished) / static_cast<double>(count)); });
  return pairs;
}

void show(const Results& pairs, const Values& /*values*/, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "models", "Two models on the same lattices", "Growth: of a_w in the last fifth of the run.",
                {"a [depth]", "psi_i [deg]", "model", "run", "a_i [depth]", "a_w/a_i [1]", "growth [1]", "a_r/a_i [1]",
                 "psi_r [deg]", "stem angle [deg]", "iterations [1]", "processor time [s]"});
  auto& history =
      exhibit.figure("history", "Amplitude at the wall by two models", "Over the measured incident amplitude.");
  for (const Pair& pair : pairs) {
    auto& panel = history.panel({.x = "t [sqrt(depth/g)]", .y = "a_w/a_i", .title = pair.configuration.text()});
    auto& sections = exhibit.figure("crests-" + pair.configuration.id(), "The pattern by two models",
                                    fmt::format("{}: columns left, hexahedra right; {}.", pair.configuration.text(),
                                                pair.hexahedra.run.resolution()));
    for (const auto& [name, reflection] :
         {std::pair{"columns", &pair.columns}, std::pair{"hexahedra", &pair.hexahedra}}) {
      const Reflection& r = *reflection;
      const auto digits = [](double value) { return std::round(value * 1e4) / 1e4; };
      table.rows.push_back({pair.configuration.amplitude, pair.configuration.angle, std::string(name),
                            r.run.resolution(), digits(r.pattern.incident_amplitude.value),
                            digits(r.wall_ratio().value), digits(r.limit.growth), digits(r.reflected_ratio().value),
                            digits(r.reflected_angle().value), digits(degrees(r.stem.value)), digits(r.iterations),
                            std::round(r.seconds)});
      std::vector<double> ratio = r.wall;
      for (double& value : ratio) value /= r.pattern.incident_amplitude.value;
      panel.line(fmt::format("{}, {}", name, r.growth_flag()), r.time, ratio);
      sections.panel({.x = "x [depth]", .y = "y [depth]", .z = "elevation [depth]", .title = name})
          .plan("elevation", r.surface.lattice());
    }
  }
}

}  // namespace

Case mach_reflection_models() {
  Case c;
  c.title = "Mach reflection by columns of water and by hexahedra";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 4";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {integer("layers", 2, {1, 8}, "of hexahedra")};
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::mach_reflection_models
