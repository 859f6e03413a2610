/*
Figure 7 of Frank (1994) with both of his models: amplitudes and angles of solitary waves reflected by a wall, with
water columns and with layers of hexahedra. The theory of Miles (1977) holds in the limit of small waves and infinite
time; here each value is extrapolated to fine grids and long times, and tends to that limit with the amplitude. Lengths
are over the depth, times over $\sqrt{\text{depth}/g}$.

**Set-up.** As in `mach_reflection_curves`: spacings are proportional to the wavelength, and runs last for the
theoretical settling time of the stem. Each run uses three grids, with 1, 1.4 and 2 times the finest spacing,
extrapolated to $h \to 0$; amplitudes at the wall are first extrapolated to $t \to \infty$. The hexahedra run at $a_i$ =
0.097 and 0.186, as in the source, the columns at 0.05 and 0.3 too.

**What is compared.** The theory for finite angles at the measured incident amplitude, because the wave on hexahedra
loses some of its amplitude: $\kappa = \tan\psi_i/(\sqrt{3a_i}\cos\psi_i)$ gives $a_w = (1+\kappa)^2 a_i$, $a_r =
\kappa^2 a_i$ and $\tan\psi_r = \sqrt{3a_i}\cos\psi_i$. The limit is the order of the neglected terms, $a_i$. Also
compared: the settling time of the stem, for small waves; the two models with each other; a run from a wave half as high
again next to the wall.

**What to look at.** From $a_i$ = 0.3 over 0.186 and 0.097 to 0.05 the results approach the theory; Miles's own $a_r =
\psi_i^2/3$ is low by 15 % at 0.05 still, because $\tan^2/\cos^2$ exceeds the square of the angle. Stems settle later
than in theory, the more so the higher the wave. The result does not depend on the initial state. Regular reflection
returns all of the incident amplitude up to $a_i$ = 0.186, and 97 % of 0.3; most of the 4 to 5 % that grids of half a
depth lose is a grid error.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/mach_reflection.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/mach_reflection/reflection_run.hpp"
#include "validation/mach_reflection/reflection_sweep.hpp"

namespace seiche::validation::cases::mach_reflection_limits {

using exact::MachReflection;

const std::string theory_source = "Miles (1977); Li, Yeh and Kodama (2011)";
const std::vector<double> lattices{1, 1.4, 2};  // spacings over that of the finest
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double lowest_reflected = 0.03;
constexpr double cusp = 0.15;                // of kappa: next to 1 no limit is reached
constexpr double small = 0.1;                // amplitude up to which the theory's second order still tells something
constexpr double coarser_layers = 10.0 / 7;  // spacing of hexahedra over that of columns: 0.5 for 0.35
constexpr double excess = 0.5;               // of the other start

/// What is run at one amplitude.
struct Plan {
  double amplitude;
  double coarseness;  ///< spacing over that at a = 0.3
  std::vector<double> angles;
  double hexahedra_from;  ///< least angle of the hexahedra: below, their reflected crests sink into the ripples
};

const std::vector<Plan> plans{{0.05, 2.5, {14, 17, 24}, none},
                              {0.097, 1.8, {18, 20, 22, 30}, 20},
                              {0.186, 1.2, {20, 25, 28, 40}, 25},
                              {0.3, 1, {25, 30, 33, 45}, none}};

/// One wave and one model: lattices, the finest first, and the other start on the coarsest.
struct Wave {
  double amplitude = 0;
  double angle = 0;  ///< [deg]
  WaveModel model = WaveModel::plan;
  double coarseness = 1;          ///< of the plan
  bool starts_otherwise = false;  ///< too: the first angle of each plan
  std::vector<Reflection> lattices = {};
  std::optional<Reflection> strengthened = {};

  [[nodiscard]] std::string name() const { return model == WaveModel::plan ? "columns" : "hexahedra"; }
  [[nodiscard]] std::string id() const { return fmt::format("{}-{}-{:g}", name(), id_of(amplitude), angle); }
  [[nodiscard]] std::string text() const {
    return fmt::format("{}, a = {:g}, {:g} deg", model == WaveModel::plan ? "Columns" : "Hexahedra", amplitude, angle);
  }
  /// By the nominal amplitude: what is claimed must not depend on what comes out.
  [[nodiscard]] MachReflection nominal() const {
    return {amplitude, radians(angle), MachReflection::Theory::kodama_yeh};
  }
  [[nodiscard]] bool stem() const { return nominal().kappa() < 1 - cusp + 1e-9; }
  [[nodiscard]] double incident() const { return limit(&Reflection::incident_amplitude).value; }
  [[nodiscard]] MachReflection theory() const {
    return {incident(), radians(angle), MachReflection::Theory::kodama_yeh};
  }
  /// tan(psi_r) = sqrt(3a) cos(psi_i) where a stem grows [deg].
  [[nodiscard]] double theory_angle() const {
    return stem() ? degrees(std::atan(std::sqrt(3 * incident()) * std::cos(radians(angle)))) : angle;
  }

  /// Of fine lattices, from what each of them gave.
  [[nodiscard]] Measurement limit(Measurement (Reflection::*of)() const) const {
    const FineLimit fine = limit_of_lattices(lattices, [&](const Reflection& r) { return (r.*of)().value; });
    return {.value = fine.value,
            .uncertainty = std::hypot(fine.uncertainty, (lattices.front().*of)().half_width()),
            .resolution = fmt::format("{} and {} times that", lattices.front().run.resolution(), "1.4 and 2")};
  }
};

using Results = std::vector<Wave>;

/// In the quick tier one angle of each plan, by the columns.
std::vector<Wave> waves(const Values& values) {
  const double amplitude = values.real("amplitude");
  const bool quick = values.tier() == Tier::quick;
  std::vector<Wave> all;
  for (const Plan& plan : plans) {
    if (amplitude != 0 && amplitude != plan.amplitude) continue;
    for (const double angle : plan.angles) {
      if (quick && angle != plan.angles[1]) continue;
      all.push_back({.amplitude = plan.amplitude,
                     .angle = angle,
                     .coarseness = plan.coarseness,
                     .starts_otherwise = quick || angle == plan.angles.front()});
      if (quick || angle < plan.hexahedra_from) continue;
      Wave layered = all.back();
      layered.model = WaveModel::hexahedra;
      layered.starts_otherwise = false;
      all.push_back(layered);
    }
  }
  if (all.empty()) {
    throw std::invalid_argument(
        fmt::format("amplitude = {:g}; allowed: 0.05, 0.097, 0.186, 0.3, or 0 for all of them", amplitude));
  }
  return all;
}

Measurement relative(const Measurement& found, double expected) {
  return {.value = found.value / expected - 1,
          .uncertainty = found.half_width() / expected,
          .resolution = found.resolution};
}

void claim_theory(const Claims<Wave>& claims, const Wave& wave) {
  const Bound bound{.limit = wave.amplitude, .reason = "the neglected terms are of the order of the amplitude"};
  claims.check(
      "wall-" + wave.id(), fmt::format("The wall amplitude agrees with the theory ({}).", wave.text()),
      "a_w/a_i for fine grids and infinite time over theory, minus 1",
      [](const Wave& w) { return relative(w.limit(&Reflection::limit_ratio), w.theory().wall_ratio()); }, bound);
  const MachReflection nominal = wave.nominal();
  const bool unsteady = wave.model == WaveModel::hexahedra && wave.amplitude < small && !wave.stem();
  claims
      .only_if(nominal.reflected_ratio() * wave.amplitude > lowest_reflected,
               "waves of a/h < 0.03 are not resolved to 10 % on these grids")
      .only_if(!unsteady, "the three grids of hexahedra leave 40 % of this regular reflection undetermined")
      .check(
          "reflected-" + wave.id(),
          fmt::format("The amplitude of the reflected wave agrees with the theory ({}).", wave.text()),
          "a_r/a_i for fine grids over theory, minus 1",
          [](const Wave& w) { return relative(w.limit(&Reflection::reflected_ratio), w.theory().reflected_ratio()); },
          Bound{.limit = 2 * wave.amplitude,
                .reason = "kappa is known to the order of the amplitude, its square to twice that"});
  claims.check(
      "angle-" + wave.id(), fmt::format("The angle of the reflected wave agrees with the theory ({}).", wave.text()),
      "psi_r for fine grids over theory, minus 1",
      [](const Wave& w) { return relative(w.limit(&Reflection::reflected_angle), w.theory_angle()); }, bound);
}

void claim_small(const Claims<Wave>& claims, const Wave& wave) {
  const double kappa = wave.nominal().kappa();
  claims.from("Kodama and Yeh (2016)")
      .at([](const Wave& w) { return w.lattices.front().run.resolution(); })
      .check(
          "settling-" + wave.id(),
          fmt::format("The settling rate of the stem agrees with the theory ({}).", wave.text()),
          "rate of the fitted exponential over theory, minus 1",
          [](const Wave& w) {
            const Reflection& r = w.lattices.front();
            return r.limit.exponential.rate / r.run.settling_rate() - 1;
          },
          Bound{.limit = wave.amplitude * (2.5 + kappa / (1 - kappa)),
                .reason = "r = S^3 kappa (1 - kappa)/3: a relative error a in S^2 and in kappa makes 3a/2, a and a "
                          "kappa/(1 - kappa)"});
}

void claim_start(const Claims<Wave>& claims, const Wave& wave) {
  claims.from("Frank (1994), section 4.3")
      .check(
          "start-" + wave.id(),
          fmt::format(
              "The wall amplitude from 1.5 times the initial height next to the wall equals the usual one ({}).",
              wave.text()),
          "difference of a_w/a_i for infinite time",
          [](const Wave& w) -> Measurement {
            const Measurement usual = w.lattices.back().limit_ratio();
            const Measurement other = w.strengthened->limit_ratio();
            return {.value = other.value - usual.value,
                    .resolution = w.strengthened->run.resolution(),
                    .told = {.limit = std::hypot(usual.half_width(), other.half_width())}};
          },
          Bound{.limit = Amount::told_by_run(0.1),
                .reason = "the combined uncertainty of the two limits, 0.1 at most; a half-remembered initial state "
                          "would leave a quarter of a_w/a_i"});
}

void claim_models(const Claims<Results>& claims, const Wave& wave, std::size_t columns, std::size_t hexahedra) {
  claims.from("Frank (1994), section 4.3")
      .check(
          fmt::format("models-{}-{:g}", id_of(wave.amplitude), wave.angle),
          fmt::format(
              "The wall amplitudes of both models for a = {:g} at {:g} deg agree to the order of the neglected terms.",
              wave.amplitude, wave.angle),
          "a_w/a_i of the hexahedra over a_w/a_i of the columns, minus 1",
          [=](const Results& r) {
            const Measurement layered = r.at(hexahedra).limit(&Reflection::limit_ratio);
            const Measurement plain = r.at(columns).limit(&Reflection::limit_ratio);
            return Measurement{.value = layered.value / plain.value - 1,
                               .uncertainty = std::hypot(layered.half_width(), plain.half_width()) / plain.value,
                               .resolution = layered.resolution};
          },
          Bound{.limit = wave.amplitude, .reason = "they differ by the neglected terms of their common theory"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<Wave> all = waves(values);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto wave = claims.entry(k);
    claim_theory(wave, all[k]);
    if (all[k].amplitude < small && all[k].stem()) claim_small(wave, all[k]);
    if (all[k].starts_otherwise) claim_start(wave, all[k]);
    if (all[k].model == WaveModel::hexahedra) claim_models(claims, all[k], k - 1, k);
  }
}

Results compute(const Run& run) {
  Results all = waves(run);
  struct Task {
    ReflectionRun what;
    Reflection* result;
  };
  std::vector<Task> tasks;
  for (Wave& wave : all) {
    wave.lattices.resize(lattices.size());
    if (wave.starts_otherwise) wave.strengthened.emplace();
    const bool layered = wave.model == WaveModel::hexahedra;
    ReflectionRun what{.amplitude = wave.amplitude,
                       .angle = radians(wave.angle),
                       .model = wave.model,
                       .layers = run.count("layers"),
                       .tolerance = layered ? 1e-6 : 1e-7};
    for (std::size_t lattice = 0; lattice < lattices.size(); ++lattice) {
      what.spacing = run.real("h") * wave.coarseness * (layered ? coarser_layers : 1) * lattices[lattice];
      tasks.push_back({what, &wave.lattices[lattice]});
    }
    if (!wave.strengthened) continue;
    what.excess = excess;
    tasks.push_back({what, &*wave.strengthened});
  }
  on_threads(run, tasks.size(), [&](std::size_t k) { *tasks[k].result = reflect_as_part(run, tasks[k].what); });
  return all;
}

void draw(evidence::Exhibit& exhibit, const Results& all) {
  auto& figure = exhibit.figure(
      "amplitudes", "Amplitudes for fine grids and long times, by both models",
      "Against kappa for finite angles, by the measured incident amplitude. Lines: theory for small waves.",
      {"frank-fig-7"});
  auto& wall = figure.panel({.x = "kappa", .y = "a_w/a_i"});
  auto& reflected = figure.panel({.x = "kappa", .y = "a_r/a_i"});
  const std::vector<double> kappa = evenly(0.4, 1.595, 240);
  wall.line("theory", kappa, each(kappa, [](double k) { return MachReflection::wall_ratio(k); }), Role::guide);
  reflected.line("theory", kappa, each(kappa, [](double k) { return MachReflection::reflected_ratio(k); }),
                 Role::guide);
  for (const WaveModel model : {WaveModel::plan, WaveModel::hexahedra}) {
    std::map<double, std::vector<Wave>> by_amplitude;
    for (const Wave& wave : all) {
      if (wave.model == model) by_amplitude[wave.amplitude].push_back(wave);
    }
    for (const auto& [amplitude, waves] : by_amplitude) {
      const auto points = [&, amplitude = amplitude, &waves = waves](evidence::Panel& panel,
                                                                     Measurement (Reflection::*of)() const) {
        panel.points(fmt::format("{}, a = {:g}", waves.front().name(), amplitude),
                     each(waves, [](const Wave& wave) { return wave.theory().kappa(); }),
                     each(waves, [&](const Wave& wave) { return wave.limit(of).value; }),
                     model == WaveModel::plan ? Role::computed : Role::peer,
                     each(waves, [&](const Wave& wave) { return wave.limit(of).half_width(); }));
      };
      points(wall, &Reflection::limit_ratio);
      points(reflected, &Reflection::reflected_ratio);
    }
  }
  auto& growth = exhibit.figure("start", "Two starts", "The second run starts half as high again next to the wall.");
  for (const Wave& wave : all) {
    if (!wave.strengthened) continue;
    auto& panel = growth.panel({.x = "t [sqrt(depth/g)]", .y = "a_w [depth]", .title = wave.text()});
    panel.line("usual", wave.lattices.back().time, wave.lattices.back().wall);
    panel.line("higher next to the wall", wave.strengthened->time, wave.strengthened->wall, Role::peer);
  }
}

void show(const Results& all, const Values& /*values*/, evidence::Exhibit& exhibit) {
  draw(exhibit, all);
  evidence::Table& table = add_table(
      exhibit, "limits", "Limits of fine grids and long times",
      "h: the finest spacing. Settling: rate of the fitted exponential over theory. Time: processor time of the finest "
      "run.",
      {"model", "a [depth]", "psi_i [deg]", "h [depth]", "a_i [depth]", "kappa [1]", "a_w/a_i [1]", "theory [1]",
       "a_r/a_i [1]", "theory [1]", "3 a_r/psi_i^2 [1]", "psi_r [deg]", "theory [deg]", "settling [1]", "time [s]"});
  for (const Wave& wave : all) {
    const Reflection& finest = wave.lattices.front();
    const double settling = wave.stem() ? finest.limit.exponential.rate / finest.run.settling_rate() : nan;
    const MachReflection theory = wave.theory();
    const double reflected = wave.limit(&Reflection::reflected_ratio).value;
    table.rows.push_back(
        {wave.name(), wave.amplitude, wave.angle, rounded(finest.run.spacing), rounded(wave.incident()),
         rounded(theory.kappa()), rounded(wave.limit(&Reflection::limit_ratio).value), rounded(theory.wall_ratio()),
         rounded(reflected), rounded(theory.reflected_ratio()),
         rounded(3 * reflected * wave.incident() / std::pow(radians(wave.angle), 2)),
         rounded(wave.limit(&Reflection::reflected_angle).value), rounded(wave.theory_angle()),
         wave.stem() ? fmt::format("{:.2f}", settling) : std::string("-"), rounded(finest.seconds, 10)});
  }
}

void mach_reflection_limits(Case& c) {
  c.title = "Mach reflection by two models: limits of fine grids, small waves and long times";
  c.source = literature::frank + ", chapter 4, figure 7; " + literature::miles;
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = {
      real("amplitude", {0.097, 0, 0}, "depth", {0, 0.3}, "of the only wave: 0.05, 0.097, 0.186 or 0.3; 0 for all"),
      real("h", {0.5, 0.35, 0.3}, "depth", {0.3, 0.6},
           "finest spacing of columns at a = 0.3; 1.2, 1.8 and 2.5 times that at the others"),
      integer("layers", 2, {1, 4}, "of hexahedra"),
  };
  c.published = {{.tiles = {"frank-fig-7"}, .tier = Tier::full}};
  c.study = Study(claims, compute, show, theory_source);
}

}  // namespace seiche::validation::cases::mach_reflection_limits
