/*
A Lagrangian mesh does not live for ever. Some motions of its nodes change no cell's area, so they meet no force:
vortices, down to the hourglass motion $(-1)^{i+j}$. Standing waves feed them a little in every period, until a cell's
corner folds. Frank's model (1994, chapter 2) stops there. This case shows when and where, that the time step has no
part in it, and what helps.

**The remedy.** A conservative hourglass potential, $\tfrac12\kappa \sum |r_0 - r_1 + r_2 - r_3 - \text{initial}|^2$
over the cells, $\kappa = \kappa_0\,\rho g\sqrt{h_1h_2}$. It vanishes for parallelograms: its effect on waves tends to
zero with the cells' size.

**Set-up.** A tank of six depths, half a wavelength. The water starts from rest with the elevation $a\cos(\pi x/6)$.

**What is compared.** Without the potential: the time of the fold for two time steps and both schemes. With it: the run
goes on; the energy of the one-step scheme stays within the band that its modified energy allows, $(\omega\tau)^2/4$ of
itself for small waves; the conservative scheme keeps energy and areas to round-off. The potential's effect on the
wave's frequency is compared with the error that the mesh has without it.

**What to look at.** The worst corner falls ever faster from 1 to 0: the surface nodes drift along the row below them.
With the potential it stays where the wave moves it. The energy says nothing: it is as good one step before the fold as
at the beginning. Watch the corners.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/instruments/mesh_standing_mode.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Stepping;

constexpr double length = 6;
constexpr double wavenumber = std::numbers::pi / length;
const std::string frank = "Frank, Discrete models of incompressible fluids (1994), chapter 2";

/// A wave in the tank and what became of its mesh.
struct Life {
  std::unique_ptr<Flow> flow;  ///< at the end, or before the step that folds the mesh
  std::vector<double> time, corner, energy_error, amplitude;
  double worst_corner = 1;
  std::optional<Divergence> fold;

  [[nodiscard]] double end() const { return fold ? fold->time() : flow->time(); }
  [[nodiscard]] double largest_energy_error() const {
    const auto& energy = flow->ledger().entry("energy");
    return energy.largest_defect / energy.initial;
  }
};

struct Setting {
  double amplitude, time, tau, hourglass;
  Stepping stepping;
};

MeshTank tank_of(const Run& run) {
  return {.wavenumber = wavenumber,
          .columns = static_cast<std::size_t>(run.integer("columns")),
          .rows = static_cast<std::size_t>(run.integer("rows"))};
}

Life live(const Run& run, const Setting& setting) {
  const MeshTank tank = tank_of(run);
  Life life;
  life.flow =
      std::make_unique<Flow>(lagrangian_mesh_2d::layer_mesh(
                                 {.begin = 0,
                                  .end = length,
                                  .depth = 1,
                                  .columns = tank.columns,
                                  .rows = tank.rows,
                                  .elevation = [&](double x) { return setting.amplitude * std::cos(wavenumber * x); }}),
                             Flow::Velocity{}, lagrangian_mesh_2d::Scheme{.stepping = setting.stepping},
                             lagrangian_mesh_2d::Settings{.hourglass = setting.hourglass});
  Flow& flow = *life.flow;
  life.amplitude.push_back(mode_amplitude(tank, flow));
  try {
    flow.advance_to(setting.time, setting.tau, [&] {
      flow.observe();
      const auto& energy = flow.ledger().entry("energy");
      life.time.push_back(flow.time());
      life.corner.push_back(flow.worst_corner().shape);
      life.energy_error.push_back(energy.defect / energy.initial);
      life.amplitude.push_back(mode_amplitude(tank, flow));
      life.worst_corner = std::min(life.worst_corner, life.corner.back());
    });
  } catch (const Divergence& folded) {
    life.fold = folded;
  }
  return life;
}

/// Of the first forty time units, with harmonics.
double frequency(const Life& life, double tau) {
  const auto count = std::min(life.amplitude.size(), static_cast<std::size_t>(40 / tau));
  return fit_oscillation({life.amplitude.data(), count}, tau, {1, 3}).frequency;
}

std::string resolution(const Run& run, double tau) {
  return fmt::format("{} x {} cells, tau = {:g}", run.integer("columns"), run.integer("rows"), tau);
}

/// Frank's model: the fold, and that it is not the time step's.
Life claim_fold(Running& run, double amplitude, const std::string& suffix) {
  const double tau = run.real("tau");
  Setting setting{amplitude, run.real("time"), tau, 0, Stepping::one_step};
  Life life = live(run, setting);
  run.record.known_failure(
      {.id = "carries" + suffix,
       .text =
           fmt::format("The mesh carries the wave of amplitude {:g} through the whole run without help.", amplitude),
       .quantity = "the mesh does not fold",
       .source = frank},
      {.value = life.fold ? 0.0 : 1.0, .resolution = resolution(run, tau)},
      evidence::Qualitative{.detector = "a corner's triangle with negative area",
                            .reason = "that the model keeps energy and areas does not keep its mesh in shape"},
      "a property of the model: motions that change no cell's area meet no force and grow");
  if (!life.fold) return life;
  run.record.measure("fold_time" + suffix, life.fold->time());
  run.record.measure("fold_place" + suffix, life.fold->place());
  setting.stepping = Stepping::conservative;
  const double conservative = live(run, setting).end();
  setting.stepping = Stepping::one_step;
  setting.tau = 0.5 * tau;
  const double half_step = live(run, setting).end();
  const double spread = std::max(std::abs(conservative - life.end()), std::abs(half_step - life.end()));
  run.record.check(
      {.id = "not-the-step" + suffix,
       .text = "With half the time step, and with the conservative scheme, it folds at the same time.",
       .quantity = "largest difference of the times of the fold",
       .unit = "sqrt(H/g)",
       .source = frank},
      {.value = spread, .resolution = resolution(run, tau)},
      Bound{.limit = 0.1 * 2 * std::numbers::pi / tank_of(run).law().frequency(wavenumber),
            .reason = "a tenth of the wave's period. Were it the error of the time step, of order tau^2, half the step "
                      "would multiply the life by four"});
  return life;
}

/// With the potential: energy of the one-step scheme, and the effect on the frequency.
Life claim_longer_life(Running& run, double amplitude, const Life& without, const std::string& suffix) {
  const double tau = run.real("tau");
  Life life = live(run, {amplitude, run.real("time"), tau, run.real("hourglass"), Stepping::one_step});
  run.record.measure("worst_corner" + suffix, life.worst_corner);
  run.record.check({.id = "carries-with-hourglass" + suffix,
                    .text = fmt::format("With the hourglass potential it carries it, to t = {:g}.", run.real("time")),
                    .quantity = "the mesh does not fold",
                    .source = "Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679 (hourglass control)"},
                   {.value = life.fold ? 0.0 : 1.0, .resolution = resolution(run, tau)},
                   evidence::Qualitative{.detector = "a corner's triangle with negative area",
                                         .reason = "the potential gives those motions a frequency, so that they are no "
                                                   "longer driven at zero frequency"});
  const double omega = tank_of(run).law().frequency(wavenumber);
  run.record.measure("energy_error" + suffix, life.largest_energy_error());
  run.record.check({.id = "energy-one-step" + suffix,
                    .text = "The energy of the one-step scheme stays in its band.",
                    .quantity = "largest error of the energy, relative",
                    .source = frank},
                   {.value = life.largest_energy_error(), .resolution = resolution(run, tau)},
                   Bound{.limit = 2 * omega * omega * tau * tau / 4,
                         .reason = "twice (omega tau)^2/4: the band of small waves, whose T + Pi - (tau^2/8) u.Ku is "
                                   "constant, and as much again for the harmonics of a high wave, which are faster"});
  const double before = frequency(without, tau);
  const double change = frequency(life, tau) / before - 1;
  const double mesh_error = omega / exact::AiryDispersion(1, 1).frequency(wavenumber) - 1;
  run.record.measure("frequency" + suffix, before);
  run.record.measure("frequency_change" + suffix, change);
  run.record.check(
      {.id = "frequency-with-hourglass" + suffix,
       .text = "The potential changes the wave's frequency by less than the mesh's own error.",
       .quantity = "relative change of the frequency, first forty time units",
       .source = "Flanagan and Belytschko (1981); the mesh's dispersion law"},
      {.value = change, .resolution = resolution(run, tau)},
      Bound{.limit = std::abs(mesh_error), .reason = "relative error of small waves on this mesh against Airy's law"});
  return life;
}

/// The conservative scheme through the whole run.
void claim_conservation(Running& run, double amplitude, const std::string& suffix) {
  const double tau = run.real("tau");
  const Life life = live(run, {amplitude, run.real("time"), tau, run.real("hourglass"), Stepping::conservative});
  const auto steps = static_cast<double>(life.flow->steps());
  const auto nodes = static_cast<double>(life.flow->model().nodes().size());
  const auto& areas = life.flow->ledger().entry("volume_worst");
  run.record.check({.id = "energy-conservative" + suffix,
                    .text = "The conservative scheme keeps the energy, that of the potential included, to round-off.",
                    .quantity = "largest error of the energy, relative",
                    .source = frank},
                   {.value = life.largest_energy_error(), .resolution = resolution(run, tau)},
                   evidence::Roundoff{.operations = 4 * nodes * steps,
                                      .scale = 1,
                                      .reason = "four coordinates and rates of each node are rounded in each step"});
  run.record.check({.id = "areas-conservative" + suffix,
                    .text = "It keeps the area of every cell to round-off.",
                    .quantity = "largest change of a cell's area",
                    .unit = "H^2",
                    .source = frank},
                   {.value = areas.largest_defect, .resolution = resolution(run, tau)},
                   evidence::Roundoff{.operations = 8 * steps,
                                      .scale = length / static_cast<double>(run.integer("rows")),
                                      .reason = "eight coordinates of a cell are rounded in each step, those along the "
                                                "tank to its length, and multiply heights of rows"});
}

/// Every so many values of a series that has thousands.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 2000);
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  return kept;
}

void draw(Running& run, double amplitude, const Life& without, const Life& with, const std::string& suffix) {
  auto& histories = run.record.figure(
      "life" + suffix, fmt::format("Life of a mesh under a standing wave, a = {:g}", amplitude),
      "Left: shape of the worst corner, 1 when square, 0 when it folds. Right: error of the energy of "
      "the one-step scheme, which shows nothing of the fold.");
  auto& corner = histories.panel({.x = "t", .y = "worst corner", .y_min = 0, .y_max = 1.02});
  auto& energy = histories.panel({.x = "t", .y = "energy error, relative"});
  const std::string label = fmt::format("hourglass potential {:g}", run.real("hourglass"));
  corner.line("without", thinned(without.time), thinned(without.corner), Role::peer);
  corner.line(label, thinned(with.time), thinned(with.corner));
  energy.line("without", thinned(without.time), thinned(without.energy_error), Role::peer);
  energy.line(label, thinned(with.time), thinned(with.energy_error));
  if (!without.fold) return;
  auto& meshes = run.record.figure(
      "mesh" + suffix, fmt::format("The mesh, a = {:g}", amplitude),
      fmt::format("Left: without the potential, one step before a corner folds at t = {:.2f}, x = {:.2f}; the surface "
                  "has drifted along the row below it. Right: with it, at t = {:g}.",
                  without.fold->time(), without.fold->place(), with.flow->time()));
  draw_mesh(meshes.panel(mesh_axes("before the fold")), "mesh", *without.flow);
  draw_mesh(meshes.panel(mesh_axes("with the hourglass potential")), "mesh", *with.flow);
}

void run(Running& run) {
  std::vector<double> amplitudes{run.real("amplitude")};
  if (run.toggle("low_wave_too")) amplitudes.push_back(amplitudes.front() / 3);
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const std::string suffix = i == 0 ? "" : "-low";
    const double amplitude = amplitudes[i];
    const Life without = claim_fold(run, amplitude, suffix);
    run.progress((static_cast<double>(i) + 0.3) / static_cast<double>(amplitudes.size()));
    const Life with = claim_longer_life(run, amplitude, without, suffix);
    claim_conservation(run, amplitude, suffix);
    draw(run, amplitude, without, with, suffix);
    run.progress((static_cast<double>(i) + 1) / static_cast<double>(amplitudes.size()));
  }
}

}  // namespace

Case standing_wave_mesh_life() {
  Case c;
  c.title = "How long a Lagrangian mesh lives under a standing wave";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 2";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = {
      real("amplitude", 0.15, "H", {1e-3, 0.5}, "of the first elevation, a cos kx"),
      toggle("low_wave_too", {false, true, true}, "also a wave of a third of the amplitude"),
      integer("columns", 16, {2, 1000}, "of cells"),
      integer("rows", 4, {1, 200}, "of cells"),
      real("tau", 0.05, "sqrt(H/g)", {1e-4, 1}, "time step"),
      real("hourglass", 0.1, "1", {1e-4, 10}, "factor of the hourglass potential"),
      real("time", {150.0, 400.0, 1000.0}, "sqrt(H/g)", {50, 1e5}, "length of the run"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
