/*
A Lagrangian mesh has a finite life. Some motions of its nodes change no cell area and meet no force: vortices, down to
the hourglass motion $(-1)^{i+j}$. Standing waves excite them in every period, until a cell corner inverts and Frank's
model (1994, chapter 2) stops. The case shows when and where, that the time step is not the cause, and two remedies.

**The remedies.** A conservative hourglass potential, $\tfrac12\kappa \sum |r_0 - r_1 + r_2 - r_3 - \text{initial}|^2$
over the cells, $\kappa = \kappa_0\,\rho g\sqrt{h_1h_2}$, vanishes for parallelograms: its effect on waves tends to zero
with the cell size. Rezoning needs no force: tilted columns become vertical again (`run_up_mesh_rezoned`).

**Set-up.** A tank of $L/2 = 6$, half a wavelength. The water starts from rest with the elevation $a\cos(\pi x/6)$.

**What is compared.** Without the potential: the time of tangling for two time steps and both schemes. With it: whether
the run completes; the energy of the one-step scheme with the band of its modified energy, a fraction $(\omega\tau)^2/4$
for small waves; the change of the wave frequency with the error of the mesh without the potential. With rezoning:
whether the run completes; the energy that rezoning takes from the wave.

**What to look at.** The relative Jacobian of the worst corner falls at a growing rate from 1 to 0, as surface nodes
drift along the row below them. With the potential it oscillates with the wave. The energy is no indicator: one step
before tangling it is as accurate as at the start. Monitor the corners.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_standing_mode.hpp"

namespace seiche::validation::cases::standing_wave_mesh_life {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Stepping;

constexpr double length = 6;
constexpr double wavenumber = std::numbers::pi / length;
const std::string frank = "Frank, Discrete models of incompressible fluids (1994), chapter 2";

/// A wave in the tank and what became of its mesh.
struct Life {
  std::unique_ptr<Flow> flow;  ///< at the end, or before the step that tangles the mesh
  double tau = 0;
  std::vector<double> time, corner, energy_error, amplitude;
  std::optional<Divergence> tangle;

  [[nodiscard]] double end() const { return tangle ? tangle->time() : flow->time(); }
  [[nodiscard]] double largest_energy_error() const {
    const auto& energy = flow->ledger().entry("energy");
    return energy.largest_defect / energy.initial;
  }
  /// Of the first forty time units, with harmonics.
  [[nodiscard]] double frequency() const {
    const auto count = std::min(amplitude.size(), static_cast<std::size_t>(40 / tau));
    constexpr std::size_t fewest = 12;
    if (tangle && count < fewest) throw Divergence(*tangle);  // before the wave has a frequency
    return fit_oscillation({amplitude.data(), count}, tau, {1, 3}).frequency;
  }
};

/// One wave: Frank's model, with the hourglass potential, and the variants that are compared with them.
struct Wave {
  double amplitude;
  std::string suffix = {};  ///< of the ids of the low wave
  Life without = {}, with = {};
  Life rezoned = {};                  ///< without it, on a mesh that is rezoned
  double tangles_conservative = nan;  ///< without it; where the time of the tangle is compared
  double tangles_half_step = nan;
  double change = nan;  ///< of the frequency by the potential, relative

  /// Of the times of the tangle without the potential.
  [[nodiscard]] double spread() const {
    return worst(std::array{tangles_conservative - without.end(), tangles_half_step - without.end()});
  }
};

using Results = std::vector<Wave>;

/// A time of the tangle that is known, as the model's property: of these waves on this mesh, where the step hardly
/// matters.
struct KnownTangle {
  double amplitude, time, width;
};
constexpr std::array<KnownTangle, 2> known_tangles{{{0.15, 51.1, 0.2}, {0.05, 216.75, 1}}};

/// Empty where the wave or the mesh is another one, or the run ends before.
std::optional<KnownTangle> known_tangle(const Values& values, double amplitude) {
  if (values.integer("columns") != 16 || values.integer("rows") != 4 || values.real("tau") != 0.05) return {};
  for (const KnownTangle& tangle : known_tangles) {
    if (std::abs(tangle.amplitude - amplitude) < 1e-12 && tangle.time + tangle.width < values.real("time"))
      return tangle;
  }
  return {};
}

/// Not yet computed.
Results waves_of(const Values& values) {
  const double amplitude = values.real("amplitude");
  Results waves;
  waves.push_back({.amplitude = amplitude});
  if (values.toggle("low_wave_too")) waves.push_back({.amplitude = amplitude / 3, .suffix = "-low"});
  return waves;
}

MeshTank tank_of(const Values& values) {
  return {.wavenumber = wavenumber, .columns = values.count("columns"), .rows = values.count("rows")};
}

struct Setting {
  double amplitude, tau, hourglass;
  Stepping stepping = Stepping::one_step;
  bool rezone = false;
};

/// As many as the mesh needs that is rezoned.
bool can_be_rezoned(const Values& values) {
  return values.integer("columns") >= 3 && values.integer("rows") >= 3;
}

Life live(const Values& values, const Setting& setting) {
  const MeshTank tank = tank_of(values);
  Life life{.tau = setting.tau};
  life.flow =
      std::make_unique<Flow>(lagrangian_mesh_2d::layer_mesh(
                                 {.end = length,
                                  .depth = 1,
                                  .columns = tank.columns,
                                  .rows = tank.rows,
                                  .elevation = [&](double x) { return setting.amplitude * std::cos(wavenumber * x); }}),
                             Flow::Velocity{}, lagrangian_mesh_2d::Scheme{.stepping = setting.stepping},
                             lagrangian_mesh_2d::Settings{.hourglass = setting.hourglass});
  Flow& flow = *life.flow;
  if (setting.rezone) flow.keep_upright();
  const double begin = flow.energy();
  life.amplitude.push_back(mode_amplitude(tank, flow));
  try {
    march(flow, values.real("time"), setting.tau, [&] {
      if (!setting.rezone) flow.observe();  // what it keeps, from the beginning on
      life.time.push_back(flow.time());
      life.corner.push_back(flow.worst_corner().shape);
      life.energy_error.push_back(flow.energy() / begin - 1);
      life.amplitude.push_back(mode_amplitude(tank, flow));
    });
  } catch (const Divergence& tangled) {
    life.tangle = tangled;
  }
  return life;
}

Results compute(const Run& run) {
  const double tau = run.real("tau");
  Results results = waves_of(run);
  double done = 0;
  for (Wave& wave : results) {
    const double amplitude = wave.amplitude;
    wave.without = live(run, {amplitude, tau, 0});
    if (known_tangle(run, amplitude)) {
      const auto tangles = [&](double step, Stepping stepping) {
        const Life life = live(run, {amplitude, step, 0, stepping});
        return life.tangle ? life.end() : nan;
      };
      wave.tangles_conservative = tangles(tau, Stepping::conservative);
      wave.tangles_half_step = tangles(0.5 * tau, Stepping::one_step);
    }
    run.progress((done + 0.3) / static_cast<double>(results.size()));
    wave.with = live(run, {amplitude, tau, run.real("hourglass")});
    wave.change = wave.with.frequency() / wave.without.frequency() - 1;
    if (can_be_rezoned(run)) wave.rezoned = live(run, {amplitude, tau, 0, Stepping::one_step, true});
    run.progress(++done / static_cast<double>(results.size()));
  }
  return results;
}

/// Frank's model: the tangle, and that it is not the time step's.
void claim_tangle(const Claims<Wave>& claims, const Values& values, double amplitude, const std::string& suffix) {
  const std::optional<KnownTangle> tangle = known_tangle(values, amplitude);
  (tangle ? claims.fails({.value = tangle->time,
                          .width = tangle->width,
                          .reason = "a property of the model: motions that change no cell area meet no force and grow"})
          : claims)
      .check(
          "carries" + suffix,
          fmt::format(
              "The run of the wave of amplitude {:g} reaches its end time without hourglass potential or rezoning.",
              amplitude),
          "end of the run [sqrt(H/g)]", [](const Wave& wave) { return wave.without.end(); },
          Bound{.limit = 1e-9,
                .reason = "the requested time, to the rounding of its steps",
                .expected = values.real("time")});
  claims
      .only_if(tangle.has_value(),
               "the time of tangling is known only for amplitudes 0.15 and 0.05 on 16 x 4 cells, tau = 0.05")
      .check("not-the-step" + suffix,
             "The time of tangling is the same with half the time step and with the conservative scheme.",
             "largest difference of the times of tangling [sqrt(H/g)]", &Wave::spread,
             Bound{.limit = 0.1 * 2 * std::numbers::pi / tank_of(values).law().frequency(wavenumber),
                   .reason = "a tenth of the wave period; if tangling were a time-step error of order tau^2, half the "
                             "step would extend the life fourfold"});
}

/// With the potential: energy of the one-step scheme, and the effect on the frequency.
void claim_longer_life(const Claims<Wave>& claims, const Values& values, const std::string& suffix) {
  const double tau = values.real("tau");
  claims.from("Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679 (hourglass control)")
      .check(
          "carries-with-hourglass" + suffix,
          fmt::format("The run with the hourglass potential reaches t = {:g} without tangling.", values.real("time")),
          "the mesh does not tangle", [](const Wave& wave) { return !wave.with.tangle; },
          Qualitative{.detector = "a corner triangle of negative area",
                      .reason = "the potential gives those motions a non-zero frequency, so that they are no longer "
                                "driven resonantly"});
  const double omega = tank_of(values).law().frequency(wavenumber);
  claims.check(
      "energy-one-step" + suffix,
      "The energy of the one-step scheme stays within (omega tau)^2/2 of its initial value.",
      "largest error of the energy, relative", [](const Wave& wave) { return wave.with.largest_energy_error(); },
      Bound{.limit = 2 * omega * omega * tau * tau / 4,
            .reason = "twice (omega tau)^2/4: the band of small waves, whose T + Pi - (tau^2/8) u.Ku is constant, and "
                      "as much again for the faster harmonics of a high wave"});
  const double mesh_error = omega / exact::AiryDispersion(1, 1).frequency(wavenumber) - 1;
  claims.from("Flanagan and Belytschko (1981); the mesh's dispersion law")
      .check("frequency-with-hourglass" + suffix,
             "The hourglass potential changes the wave's frequency by less than the error of small waves on this mesh "
             "against Airy.",
             "relative change of the frequency, first forty time units", &Wave::change,
             Bound{.limit = std::abs(mesh_error),
                   .reason = "relative error of small waves on this mesh against Airy's law"});
}

/// On a mesh that is rezoned.
void claim_rezoned(const Claims<Wave>& all, const Values& values, const std::string& suffix) {
  const auto claims = all.only_if(can_be_rezoned(values), "a rezoned mesh needs three columns and rows or more");
  const std::string hirt = "C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227";
  claims.from(hirt).check(
      "carries-rezoned" + suffix,
      fmt::format("The run with rezoned columns reaches t = {:g} without tangling.", values.real("time")),
      "the mesh does not tangle", [](const Wave& wave) { return !wave.rezoned.tangle; },
      Qualitative{.detector = "a corner triangle of negative area",
                  .reason = "the surface of a wave of this height is single-valued: vertical columns cannot tangle"});
  const double periods = values.real("time") * tank_of(values).law().frequency(wavenumber) / (2 * std::numbers::pi);
  claims.from(hirt).check(
      "taken-by-rezoning" + suffix, "The energy taken by rezoning is at most 0.1 % of the wave energy per period.",
      "energy taken over the initial energy, per period",
      [periods](const Wave& wave) {
        const Flow& flow = *wave.rezoned.flow;
        return wave.rezoned.tangle ? nan : flow.rezoning().lost / (flow.energy() + flow.rezoning().lost) / periods;
      },
      Bound{.limit = 0.001,
            .reason = "a choice: at 0.1 % per period a wave retains half of its energy after 700 periods"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const Claims<Results> all = claims.at(
      fmt::format("{} x {} cells, tau = {:g}", values.integer("columns"), values.integer("rows"), values.real("tau")));
  const Results waves = waves_of(values);
  for (std::size_t i = 0; i < waves.size(); ++i) {
    claim_tangle(all.entry(i), values, waves[i].amplitude, waves[i].suffix);
    claim_longer_life(all.entry(i), values, waves[i].suffix);
    claim_rezoned(all.entry(i), values, waves[i].suffix);
  }
}

/// Every so many values of a series that has thousands.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 2000);
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  return kept;
}

void draw(evidence::Exhibit& exhibit, const Wave& wave, double hourglass) {
  const double amplitude = wave.amplitude;
  const std::string& suffix = wave.suffix;
  const Life& without = wave.without;
  const Life& with = wave.with;
  auto& histories =
      exhibit.figure("life" + suffix, fmt::format("Life of a mesh under a standing wave, a = {:g}", amplitude),
                     "Left: relative Jacobian of the worst corner, 1 when square, 0 at inversion. Right: energy error "
                     "of the one-step scheme, which does not indicate tangling.");
  auto& corner = histories.panel({.x = "t", .y = "worst corner", .y_min = 0, .y_max = 1.02});
  auto& energy = histories.panel({.x = "t", .y = "energy error, relative"});
  const auto add = [&](const std::string& label, const Life& life, Role role) {
    if (!life.flow) return;
    corner.line(label, thinned(life.time), thinned(life.corner), role);
    energy.line(label, thinned(life.time), thinned(life.energy_error), role);
  };
  add("without", without, Role::peer);
  add(fmt::format("hourglass potential {:g}", hourglass), with, Role::computed);
  add("rezoned", wave.rezoned, Role::peer);
  exhibit.measure("worst_corner" + suffix, smallest(with.corner));
  exhibit.measure("frequency" + suffix, without.frequency());
  if (!without.tangle) return;
  exhibit.measure("tangle_place" + suffix, without.tangle->place());
  auto& meshes = exhibit.figure(
      "mesh" + suffix, fmt::format("The mesh, a = {:g}", amplitude),
      fmt::format("Left: without the potential, one step before a corner inverts at t = {:.2f}, x = {:.2f}; the "
                  "surface has drifted along the row below it. Right: with the potential, at t = {:g}.",
                  without.tangle->time(), without.tangle->place(), with.flow->time()));
  draw_mesh(meshes.panel(mesh_axes("before it tangles")), "mesh", *without.flow);
  draw_mesh(meshes.panel(mesh_axes("with the hourglass potential")), "mesh", *with.flow);
}

void show(const Results& results, const Values& values, evidence::Exhibit& exhibit) {
  for (const Wave& wave : results) draw(exhibit, wave, values.real("hourglass"));
}

void standing_wave_mesh_life(Case& c) {
  c.title = "Time until a Lagrangian mesh tangles under a standing wave";
  c.source = literature::frank + ", chapter 2";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = {
      real("amplitude", 0.15, "H", {1e-3, 0.5}, "of the initial elevation, a cos kx"),
      toggle("low_wave_too", {false, true, true}, "also a wave of a third of the amplitude"),
      integer("columns", 16, {2, 1000}, "of cells"),
      integer("rows", 4, {1, 200}, "of cells"),
      real("tau", 0.05, "sqrt(H/g)", {1e-4, 1}, "time step"),
      real("hourglass", 0.1, "1", {1e-4, 10}, "factor of the hourglass potential"),
      real("time", {150.0, 400.0, 1000.0}, "sqrt(H/g)", {50, 1e5}, "length of the run"),
  };
  c.study = Study(claims, compute, show, frank);
}

}  // namespace seiche::validation::cases::standing_wave_mesh_life
