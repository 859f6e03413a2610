/*
A standing wave in a tank, computed with three discrete models of the same fluid: the Lagrangian mesh of quadrilaterals
(Frank 1994, chapter 2), Dirichlet cells of constant area (5.2), and variable-mass particles whose nodes are drawn back
to their positions (5.3). Depth, gravity and density are 1; the tank is 3 long and contains half a wavelength.

**Set-up.** The surface starts flat, with the velocities of the linear wave. Meshes of square cells, staggered rows for
the two models of Dirichlet cells; without and with pressure stabilisation.

**What is compared.** For a small wave, the period with the linear wave on a sequence of meshes, and the *noise*: the
maximum kinetic energy outside the velocity field of the linear wave, over the initial kinetic energy. For a/h = 0.1,
the time that a model lasts, up to `periods`.

**What to look at.** The source states that the spurious motion of Dirichlet cells costs accuracy. The frequency does
not show it: it converges at second order everywhere. The noise does: without stabilisation it is many times the noise
of the quadrilaterals and does not fall with the mesh. High waves end the run: no force restores the position of a node
in its cell, and after about one period a triangle of the outline inverts. The quadrilaterals, here without hourglass
force, last for nearly five periods. Variable-mass particles complete. Where their nodes follow the water and are drawn
back, the energy of the motion passes into short waves after a few periods, on finer meshes too. Nodes of constant $x$,
here on twice as many rows, exchange more water per step, and lose about 1 % of the energy in ten periods.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/harmonic_fit.hpp"
#include "validation/instruments/surface_points.hpp"

namespace seiche::validation::cases::standing_wave_free_lagrangian {

const std::string source =
    "Frank, Discrete models of incompressible fluid (1994), chapters 2 and 5.2, 5.3; linear wave";
constexpr double length = 3;
constexpr double k = std::numbers::pi / length;
constexpr double small_amplitude = 0.01;
constexpr double small_periods = 3;
constexpr std::array ladder{4L, 8L, 12L, 16L, 20L, 24L};
constexpr long rows_of_life = 8;
constexpr double courant_of_life = 0.25;  // step over spacing

double frequency() {
  return std::sqrt(k * std::tanh(k));
}
double period() {
  return 2 * std::numbers::pi / frequency();
}

/// Velocity of the linear wave of amplitude 1 when the surface is flat and rises at x = 0.
Point linear(Point r) {
  const double scale = frequency() / std::sinh(k);
  return {-scale * std::cosh(k * (r.y + 1)) * std::sin(k * r.x), scale * std::sinh(k * (r.y + 1)) * std::cos(k * r.x)};
}

/// A model and how it is run.
struct Kind {
  const char* id;
  const char* name;
  enum { quadrilaterals, dirichlet, variable } model;
  double stabilisation;
};
constexpr std::array kinds{Kind{"quadrilaterals", "quadrilaterals", Kind::quadrilaterals, 0},
                           Kind{"dirichlet", "Dirichlet cells", Kind::dirichlet, 0},
                           Kind{"dirichlet-stabilised", "Dirichlet cells, stabilised", Kind::dirichlet, 0.1},
                           Kind{"variable-mass", "variable mass, stabilised", Kind::variable, 0.1}};
enum { of_quadrilaterals, of_dirichlet, of_stabilised, of_variable, of_fixed };

struct Wave {
  std::vector<double> time, amplitude;
  std::vector<double> noise;  ///< over the kinetic energy of the beginning
  double lasted = 0;          ///< periods
  bool broke = false;
  double lost = 0;    ///< energy of the water, over the kinetic energy of the beginning
  double remade = 0;  ///< triangles that flips make anew in a step, over all of them
};

/// Kinetic energy outside the linear wave's field.
template <class Flow>
double outside(const Flow& flow) {
  const auto& model = flow.model();
  const mechanics::State& state = flow.state();
  const std::size_t n = state.q.size() / 2;
  std::vector<double> field(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point f = linear({state.q[i], state.q[n + i]});
    field[i] = f.x;
    field[n + i] = f.y;
  }
  std::vector<double> more = state.u;
  std::vector<double> less = state.u;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    more[i] += field[i];
    less[i] -= field[i];
  }
  const double product = (model.kinetic_energy(state.q, more) - model.kinetic_energy(state.q, less)) / 2;
  return model.kinetic_energy(state.q, state.u) - product * product / (4 * model.kinetic_energy(state.q, field));
}

/// Part of the surface in the wave, by the trapezoidal rule.
double mode(const std::vector<Point>& surface) {
  double sum = 0;
  for (std::size_t i = 1; i < surface.size(); ++i) {
    const Point a = surface[i - 1];
    const Point b = surface[i];
    sum += (b.x - a.x) * (a.y * std::cos(k * a.x) + b.y * std::cos(k * b.x)) / 2;
  }
  return 2 * sum / length;
}

/// Follows a flow for so many periods, or until it breaks down.
template <class Flow, class Surface>
Wave follow(Flow&& flow, const Surface& surface, double tau, double periods) {
  const auto& model = flow.model();
  const auto kinetic_energy = [&] { return model.kinetic_energy(flow.state().q, flow.state().u); };
  const double kinetic = kinetic_energy();
  const double energy = kinetic + model.potential_energy(flow.state().q);
  Wave wave;
  const auto look = [&] {
    wave.time.push_back(flow.time());
    wave.amplitude.push_back(mode(surface(flow)));
    wave.noise.push_back(outside(flow) / kinetic);
    wave.lasted = flow.time() / period();
    wave.lost = (energy - kinetic_energy() - model.potential_energy(flow.state().q)) / kinetic;
  };
  look();
  try {
    const auto steps = static_cast<long>(std::ceil(periods * period() / tau));
    for (long n = 0; n < steps; ++n) {
      flow.advance(tau);
      look();
    }
  } catch (const Divergence&) {
    wave.broke = true;
  }
  // A flip makes two triangles, and a node has about two: as many as coordinates.
  if constexpr (requires { flow.flips(); }) {
    wave.remade =
        2 * static_cast<double>(flow.flips()) / static_cast<double>(flow.state().q.size() * (wave.time.size() - 1));
  }
  return wave;
}

Wave run_wave(const Kind& kind, double amplitude, long rows, double tau, double periods,
              const variable_mass::Control& control, double drift_feedback = 0) {
  const auto start = [amplitude](Point r) {
    const Point u = linear(r);
    return Point{amplitude * u.x, amplitude * u.y};
  };
  const int columns = static_cast<int>(length) * static_cast<int>(rows);
  if (kind.model == Kind::quadrilaterals) {
    const auto surface = [](const auto& flow) { return joined({flow.surface_x(), flow.surface_y()}); };
    return follow(lagrangian_mesh_2d::Flow(lagrangian_mesh_2d::layer_mesh({.end = length,
                                                                           .columns = static_cast<std::size_t>(columns),
                                                                           .rows = static_cast<std::size_t>(rows)}),
                                           start),
                  surface, tau, periods);
  }
  const free_lagrangian::Mesh rest =
      free_lagrangian::layer_mesh({.end = length, .columns = columns, .rows = static_cast<int>(rows)});
  const variable_mass::Surface top(rest);
  const auto surface = [&](const auto& flow) { return chosen(top.nodes(), {flow.x(), flow.y()}); };
  if (kind.model == Kind::dirichlet) {
    return follow(dirichlet_mesh::Flow(rest, start, {.stabilisation = kind.stabilisation}, drift_feedback), surface,
                  tau, periods);
  }
  return follow(
      variable_mass::Flow(rest, {.velocity = start}, control, {.stabilisation = kind.stabilisation}, drift_feedback),
      surface, tau, periods);
}

/// A model on finer meshes: errors of the period, and noise.
struct Results {
  Refinement period = {};  ///< |T/T_0 - 1|, a quantity for each kind
  Refinement noise = {};   ///< largest
  std::vector<Wave> life = {};

  [[nodiscard]] double noise_ratio(std::size_t kind) const {
    return noise.finest(kind) / noise.on(std::lround(noise.n().back() / 2), kind);
  }
};

std::vector<long> meshes(const Values& values) {
  std::vector<long> rows;
  std::ranges::copy_if(ladder, std::back_inserter(rows), [&](long n) { return n <= values.integer("ny"); });
  return rows;
}

/// The kinds of the high wave: as above, with the little stabilisation that serves it best.
std::vector<Kind> kinds_of_life() {
  std::vector<Kind> all(kinds.begin(), kinds.end());
  all[of_stabilised].stabilisation = 0.01;
  all[of_variable].stabilisation = 0.01;
  all.push_back({"variable-mass-fixed", "variable mass at fixed x, stabilised", Kind::variable, 0.1});
  return all;
}

long rows_of(std::size_t kind_of_life) {
  return kind_of_life == of_fixed ? 2 * rows_of_life : rows_of_life;
}

RefinementStudy study(const std::string& what) {
  RefinementStudy s{.source = source};
  for (const Kind& kind : kinds) {
    const bool noisy = kind.model == Kind::dirichlet;
    s.quantities.push_back(
        {.id = kind.id,
         .name = std::string(kind.name),
         .statement = fmt::format("The {1} converges at second order ({0}).", kind.name, what),
         .order = Order{2, noisy ? 0.5 : 0.3,
                        noisy ? "cells of regular rows: second order; the series from which the frequency is fitted "
                                "contains the noise of the cells, which hardly falls with the mesh"
                              : "cells of regular rows, and steps in proportion: second order"}});
  }
  return s;
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<long> rows = meshes(values);
  if (rows.back() != values.integer("ny") || rows.back() % 8 != 0) {
    throw std::invalid_argument(fmt::format("ny = {}; allowed: 16, 24", values.integer("ny")));
  }
  study("period").claim_orders(
      claims.of(&Results::period)
          .only_if(rows.size() >= 6, "on fewer meshes the scatter of errors leaves the order undetermined: ny = 24"));
  claims.at(fmt::format("{} rows, a = {:g}", rows.back(), small_amplitude))
      .from("Frank (1994), 5.2, in words")
      .check(
          "noise",
          "The noise of Dirichlet cells without stabilisation exceeds three times the noise of quadrilaterals.",
          "noise over the noise of the quadrilaterals",
          [](const Results& r) { return r.noise.finest(of_dirichlet) > 3 * r.noise.finest(of_quadrilaterals); },
          Qualitative{"more than three times",
                      "the motion of the cells differs from the motion of the water, which costs accuracy"});
  const auto falls = [&](const std::string& id, const std::string& text, std::size_t kind, bool expected) {
    claims.at(fmt::format("{} and {} rows", rows.back() / 2, rows.back()))
        .check(
            "noise-falls-" + id, text, "noise over the noise of half as many rows",
            [kind](const Results& r) { return r.noise_ratio(kind) <= 0.5; },
            Qualitative{"at most a half: first order or higher", "a discretisation error vanishes with the cell size",
                        expected});
  };
  falls("quadrilaterals", "The noise of quadrilaterals falls with the mesh.", of_quadrilaterals, true);
  falls("dirichlet", "The noise of Dirichlet cells without stabilisation does not fall with the mesh.", of_dirichlet,
        false);
  falls("variable-mass", "The noise of variable-mass particles falls with the mesh.", of_variable, true);
  const double periods = values.real("periods");
  const double amplitude = values.real("amplitude");
  const bool controlled = values.text("control") == "mapped" || values.text("control") == "fixed_x";
  const auto life = claims.at(fmt::format("{} rows, a = {:g}", rows_of_life, amplitude));
  const auto completes = [periods](const Claims<Results>& list, const std::string& id, const std::string& text,
                                   std::size_t kind) {
    list.check(
        "life-" + id, text, "periods until it breaks down",
        [=](const Results& r) { return std::min(r.life.at(kind).lasted, periods); },
        Bound{.limit = 1e-9, .reason = "the requested periods", .expected = periods});
  };
  completes(life.only_if(controlled, "surface nodes without a restoring force collide"), "variable-mass",
            "The run of the high wave with variable-mass particles completes the requested periods, to 1e-9.",
            of_variable);
  const auto at_fixed_x =
      claims.at(fmt::format("{} rows, a = {:g}", rows_of(of_fixed), amplitude))
          .only_if(amplitude <= 0.1 && values.real("surface_rate") >= 1 && values.real("rate") >= 1,
                   "with higher waves, or weaker control, the model breaks down where the surface is steepest");
  completes(
      at_fixed_x, "variable-mass-fixed",
      "The run of the high wave with variable-mass particles at fixed x completes the requested periods, to 1e-9.",
      of_fixed);
  at_fixed_x.only_if(periods <= 10, "the loss grows with time")
      .check(
          "loss-of-life", "The energy loss of variable-mass particles is below 10 % of the initial kinetic energy.",
          "energy lost over kinetic energy at the start", [](const Results& r) { return r.life.at(of_fixed).lost; },
          Bound{.limit = 0.1, .reason = "5 % of the amplitude, its second-order term a/2H, after ten periods"});
  life.from("Frank (1994), 5.2, in words")
      .check(
          "flips",
          "The fraction of triangles flipped per step is at most the displacement of the fastest node over the "
          "spacing.",
          "flipped triangles per step over all triangles",
          [](const Results& r) { return r.life.at(of_dirichlet).remade; },
          Bound{.limit = courant_of_life * amplitude * frequency() / std::tanh(k),
                .reason = "displacement of the fastest node per step over the spacing: the maximum rate at which it "
                          "passes a neighbour, which causes a flip"});
  const Bound one_wave{.limit = 0.05,
                       .reason =
                           "harmonics of a wave of a/H = 0.1 have relative velocities of order a/H: 1 % of its energy, "
                           "and a few per cent on meshes of eight rows"};
  at_fixed_x.only_if(periods <= 10, "the noise grows with time")
      .check(
          "noise-of-life-fixed",
          "The kinetic energy outside the single wave, with variable-mass particles at fixed x, is below the limit.",
          "largest noise of particles of variable mass at fixed x",
          [](const Results& r) { return largest(r.life.at(of_fixed).noise); }, one_wave);
  life.only_if(amplitude == 0.1 && periods == 10, "the noise grows with height and time")
      .fails(
          {.value = 0.2, .width = 0.1, .reason = "surface nodes sliding back and exchanged water excite short waves"})
      .check(
          "noise-of-life",
          "The kinetic energy outside the single wave, with variable-mass particles, is below the limit for the high "
          "wave.",
          "largest noise of particles of variable mass",
          [](const Results& r) { return largest(r.life.at(of_variable).noise); }, one_wave);
  completes(life.only_if(amplitude == 0.1 && periods >= 3, "the life of Dirichlet cells depends on the wave height")
                .fails({.value = 1.12,
                        .width = 0.2,
                        .reason = "no force restores the position of a node in its cell: the instability belongs to "
                                  "the model, not to the time step; a triangle of the outline inverts after about one "
                                  "period"}),
            "dirichlet",
            "The run of the high standing wave with Dirichlet cells completes the requested periods, to 1e-9.",
            of_dirichlet);
}

Results compute(const Run& run) {
  Results r;
  const variable_mass::Control control{variable_mass::control_named(run.text("control")), run.real("rate"),
                                       run.real("surface_rate")};
  const std::vector<long> rows = meshes(run);
  for (const long n : rows) {
    std::vector<double> periods, noises;
    const double tau = 0.4 / static_cast<double>(n);
    for (const Kind& kind : kinds) {
      const Wave wave = run_wave(kind, small_amplitude, n, tau, small_periods, control);
      const double found = wave.broke ? nan : fit_oscillation(wave.amplitude, tau, {1, 3}).frequency;
      periods.push_back(std::abs(frequency() / found - 1));
      noises.push_back(largest(wave.noise));
    }
    r.period.add(n, periods);
    r.noise.add(n, noises);
    run.progress(0.7 * std::pow(static_cast<double>(n) / static_cast<double>(rows.back()), 3));
  }
  const std::vector<Kind> all = kinds_of_life();
  for (std::size_t i = 0; i < all.size(); ++i) {
    variable_mass::Control own = control;
    if (i == of_fixed) own.kind = variable_mass::ControlKind::fixed_x;
    const double tau = courant_of_life / static_cast<double>(rows_of(i));
    r.life.push_back(run_wave(all[i], run.real("amplitude"), rows_of(i), tau, run.real("periods"), own,
                              all[i].model == Kind::variable ? 0.2 : 0));
  }
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("convergence", "Period and noise against the mesh",
                                "Small wave, three periods. Grey lines have slopes 1 and 2.", {"frank-dirichlet"});
  study("period").draw(r.period, figure.panel({.x = "rows", .y = "|T/T_0 - 1|", .log_x = true, .log_y = true}));
  study("noise").draw(r.noise, figure.panel({.x = "rows", .y = "noise", .log_x = true, .log_y = true}));
  study("period").tabulate(r.period, exhibit);
  auto& life =
      exhibit.figure("life", "Wave of a/h = 0.1",
                     "Modal elevation at the left wall, and noise, until a model breaks down.", {"frank-dirichlet"});
  auto& waves = life.panel({.x = "t/T_0", .y = "amplitude/a"});
  auto& noises = life.panel({.x = "t/T_0", .y = "noise"});
  const std::vector<Kind> all = kinds_of_life();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Wave& wave = r.life[i];
    const auto time = each(wave.time, [](double t) { return t / period(); });
    const std::string label =
        fmt::format("{}{}", all[i].name, all[i].stabilisation > 0 ? fmt::format(" by {:g}", all[i].stabilisation) : "");
    waves.line(label, time, each(wave.amplitude, [&](double a) { return a / values.real("amplitude"); }));
    noises.line(label, time, wave.noise);
    exhibit.measure(fmt::format("lost_{}", all[i].id), wave.lost);
  }
}

void standing_wave_free_lagrangian(Case& c) {
  c.title = "A standing wave in three free-Lagrangian models";
  c.source = literature::frank + ", chapters 2, 5.2 and 5.3";
  c.parameters = {
      integer("ny", {16, 24, 24}, {16, 24}, "rows of the finest mesh: 16 or 24; 4, 8, 12, ... up to it"),
      real("amplitude", 0.1, "depth", {0.02, 0.2}, "of the high wave"),
      real("periods", {4.0, 10.0, 10.0}, "1", {1, 50}, "of the high wave"),
      choice("control", "mapped", {"none", "centroid", "mapped", "fixed_x"}, "of the nodes of variable mass"),
      real("rate", 1.0, "sqrt(g/depth)", {0, 10}, "of the control"),
      real("surface_rate", 1.0, "sqrt(g/depth)", {0, 10}, "rate at which surface nodes slide back"),
  };
  c.published = {{.tiles = {"frank-dirichlet"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::standing_wave_free_lagrangian
