/*
Water at rest in a tank, computed with weakly compressible SPH: velocities should stay zero and the pressure
hydrostatic. The error depends on the wall treatment, of which this case compares several.

**Set-up.** A tank 1 m wide with 0.5 m of water, $c_0 = 10\sqrt{2gH}$, $\alpha = 0.1$, XSPH $\epsilon = 0.5$, for 1 or 2
s. `plain`: wall particles have the density given by the continuity equation; `clamped`: the same, without suction;
`filter`: density filter every 30 steps; `diffusion`: density diffusion of delta-SPH, 0.1, with corrected gradients;
`extrapolated`: wall pressure extrapolated from the water (Adami, Hu and Adams 2012).

**What is compared.** Pressure with $\rho_0 g$ times the depth at 21 instants of the second half of the run: over all of
the water, and over its core, three smoothing lengths from walls and surface; velocity with zero; the final position of
the centre of mass with its initial position. Errors oscillate by half of their magnitude, so that one instant is not
representative.

**What to look at.** The pressure error of the plain scheme hardly falls with the spacing. Part of the error is sound
that the start emits at the walls, whose particles do not respond as water does; the other part is density noise, which
grows with the number of steps. Density diffusion removes the noise and, away from the walls, most of the error. Walls
with extrapolated pressure emit no sound: their error is ten times smaller, until it reaches about half the compression
$gH/c_0^2$ of the water.
*/
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation::cases::hydrostatic_sph {

using wcsph::Settings;

const std::string source =
    "Crespo, Gomez-Gesteira and Dalrymple, Comput. Mater. Contin. 5 (2007) 173; Adami, Hu and Adams, J. Comput. Phys. "
    "231 (2012) 7057";
constexpr double gravity = 9.81;
constexpr double width = 1;
constexpr double depth = 0.5;

Settings settings_of(const Values& values) {
  return sph_settings(values, gravity, 1000, std::sqrt(2 * gravity * depth));
}

struct Option {
  std::string name;
  void (*change)(Settings&);
};
const std::array options{Option{"plain", [](Settings&) {}},
                         Option{"clamped", [](Settings& s) { s.walls = wcsph::WallPressure::clamped; }},
                         Option{"filter", [](Settings& s) { s.filter_every = 30; }},
                         Option{"diffusion", [](Settings& s) { s.density_diffusion = 0.1; }},
                         Option{"extrapolated", [](Settings& s) { s.walls = wcsph::WallPressure::extrapolated; }}};

/// Errors of pressure over rho_0 g H, velocity over sqrt(g H), sinking of the centre of mass over H.
struct Rest {
  double spacing = 0;
  std::size_t particles = 0;
  Mean all, core;  ///< squares of errors of the pressure
  Mean kinetic;    ///< squares of velocities
  double sinking = 0;
  Worst largest;
  std::vector<double> height, pressure;  ///< z/H, P/(rho_0 g H) at the end

  [[nodiscard]] double core_rms() const { return std::sqrt(core.value()); }
  [[nodiscard]] double velocity() const { return std::sqrt(kinetic.value() / (gravity * depth)); }
  [[nodiscard]] std::string resolution() const { return sph_resolution(spacing, particles); }
};

double centre_of_mass(const wcsph::Totals& totals) {
  return totals.potential / (totals.mass * gravity);
}

Rest stay(const Settings& settings, double spacing, double time) {
  wcsph::Scene scene = wcsph::tank({.width = width, .depth = depth, .spacing = spacing}, settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, settings);
  const double first = centre_of_mass(flow.totals());
  Rest rest{.spacing = spacing, .particles = flow.particles().size()};
  const double scale = settings.density * settings.gravity * depth;
  const double margin = 3 * flow.smoothing_length();
  for (int instant = 0; instant <= 20; ++instant) {
    march(flow, time * (0.5 + 0.025 * instant));
    const wcsph::Particles& p = flow.particles();
    const std::vector<double> pressure = flow.pressure();
    rest.height.clear();
    rest.pressure.clear();
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.kind[i] != wcsph::Kind::fluid) continue;
      const double error = pressure[i] / scale - (1 - p.z[i] / depth);
      rest.all.add(error * error);
      rest.largest.add(error, p.z[i]);
      rest.kinetic.add(p.u[i] * p.u[i] + p.w[i] * p.w[i]);
      if (p.x[i] > margin && p.x[i] < width - margin && p.z[i] > margin && p.z[i] < depth - margin) {
        rest.core.add(error * error);
      }
      rest.height.push_back(p.z[i] / depth);
      rest.pressure.push_back(pressure[i] / scale);
    }
  }
  rest.sinking = (first - centre_of_mass(flow.totals())) / depth;
  return rest;
}

struct Results {
  std::vector<Rest> wide, fine;  ///< of each option, with 2 dx and dx
};

Results compute(const Run& run) {
  const double dx = run.real("dx");
  const std::array spacings{2 * dx, dx};
  std::vector<Rest> rests(options.size() * spacings.size());
  on_threads(run, rests.size(), [&](std::size_t k) {
    const std::size_t costly_first = rests.size() - 1 - k;
    Settings settings = settings_of(run);
    options[costly_first % options.size()].change(settings);
    rests[costly_first] = stay(settings, spacings[costly_first / options.size()], run.real("time"));
  });
  const auto middle = rests.begin() + static_cast<std::ptrdiff_t>(options.size());
  return {.wide = {rests.begin(), middle}, .fine = {middle, rests.end()}};
}

void claim_rest(const Claims<Rest>& claims, const Option& option, const Values& values) {
  const double cell = values.real("dx") / depth;
  const double compression = gravity * depth / std::pow(settings_of(values).sound_speed, 2);
  const bool extrapolated = option.name == "extrapolated";
  const auto check = [&](const std::string& id, const std::string& text, const std::string& quantity, auto measure,
                         const Bound& bound) {
    claims.check(fmt::format("{}-{}", id, option.name), fmt::format("{} ({}).", text, option.name), quantity, measure,
                 bound);
  };
  const Bound pressure =
      extrapolated
          ? Bound{.limit = cell, .reason = "the pressure of one spacing of water, the position uncertainty of a wall"}
          : Bound{.limit = 0.05, .reason = "5 % of the bed pressure, the accuracy asked of a wall treatment"};
  check("velocity",
        "The rms velocity of water at rest is at most the velocity of a sound wave with the pressure limit, 5 % or one "
        "spacing",
        "rms velocity over sqrt(g H)", &Rest::velocity,
        {.limit = pressure.limit.value() * std::sqrt(compression),
         .reason = "sound waves of pressure rho c u equal to the pressure limit"});
  check("core",
        "The pressure away from walls and surface agrees with the hydrostatic one within 5 %, or one spacing of water",
        "rms error over rho g H", &Rest::core_rms, pressure);
  Bound level{.limit = 2 * settings_of(values).smoothing * cell * compression,
              .reason =
                  "wall particles interact with water within 2h and bear its weight once it has approached by the "
                  "fraction g H/c^2 of that distance"};
  if (extrapolated) {
    level = {.limit = 0.5 * cell * compression, .reason = "compression by the pressure of one spacing of water"};
  } else if (option.name == "filter") {
    level = {.limit = 0.5 * cell, .reason = "half a spacing: filtered densities do not retain the volume of the water"};
  }
  check("level",
        "The sinking of the centre of mass is at most the compression g H/c^2 over two smoothing lengths, or half a "
        "spacing",
        "sinking of the centre of mass over the depth", &Rest::sinking, level);
}

void claims(const Values& values, const Claims<Results>& claims) {
  for (std::size_t k = 0; k < options.size(); ++k) {
    claim_rest(claims.of(&Results::fine).entry(k).at(&Rest::resolution), options[k], values);
  }
  const auto check_convergence = [](const Claims<Results>& to, std::size_t option) {
    to.check(
        "converges-" + options[option].name,
        fmt::format("Half the spacing halves the error of the pressure ({}).", options[option].name),
        "rms error with dx over that with 2 dx",
        [option](const Results& r) {
          return std::sqrt(r.fine.at(option).all.value()) / std::sqrt(r.wide.at(option).all.value());
        },
        Bound{.limit = 0.095,
              .reason = "first order to a quarter of an order, 0.5 times 2^(1/4): the orders between three spacings, "
                        "1.0 and 0.8, differ by that much",
              .expected = 0.5});
  };
  const bool quick = values.tier() == Tier::quick;
  check_convergence(
      claims.fails(
          {.value = quick ? 0.72 : 1.2,
           .width = quick ? 0.1 : 0.2,
           .reason = "sound emitted by the walls at the start decays slowly, and density noise without effect on "
                     "pressure gradients grows with the number of steps; neither falls with the spacing; density "
                     "diffusion removes the noise, extrapolated wall pressure the sound"},
          values.standard()),
      0);
  check_convergence(
      claims.fails(
          {.value = 1.1,
           .width = 0.3,
           .reason =
               "the error, 0.3 % of the pressure at the bottom, is about half of the compression g H/c^2, and does "
               "not fall below it; after some 1.5 s the particle arrangement begins to break up in the corners"},
          values.standard() && !quick),
      options.size() - 1);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "rest", "Water at rest",
                "Errors of the pressure over rho g H; velocity over sqrt(g H); sinking of the centre of mass over H.",
                {"option", "dx [m]", "rms, all", "rms, core", "largest", "rms velocity", "sinking"});
  auto& figure = exhibit.figure("pressure", "Pressure against height",
                                fmt::format("Every particle of the water after {:g} s.", values.real("time")));
  for (std::size_t k = 0; k < options.size(); ++k) {
    for (const Rest* rest : {&r.wide[k], &r.fine[k]}) {
      table.rows.push_back({options[k].name, rest->spacing, std::sqrt(rest->all.value()), rest->core_rms(),
                            rest->largest.value(), rest->velocity(), rest->sinking});
    }
    auto& panel = figure.panel({.x = "P/(rho g H)", .y = "z/H", .title = options[k].name});
    panel.points("SPH", r.fine[k].pressure, r.fine[k].height, Role::computed);
    panel.line("rho g times depth", std::array{0.0, 1.0}, std::array{1.0, 0.0}, Role::exact);
  }
}

void hydrostatic_sph(Case& c) {
  c.title = "Water at rest in a tank: weakly compressible SPH and its walls";
  c.source =
      "A. J. C. Crespo, M. Gomez-Gesteira, R. A. Dalrymple, Comput. Mater. Contin. 5 (2007) 173; S. Adami, X. Y. Hu, "
      "N. A. Adams, J. Comput. Phys. 231 (2012) 7057";
  c.parameters = with({real("dx", {0.025, 0.0125, 0.00625}, "m", {0.001, 0.1}, "spacing of the particles"),
                       real("time", {1, 2, 2}, "s", {0.01, 100}, "duration")},
                      sph_parameters({.alpha = 0.1, .sound = 10}, "sqrt(2 g H)"));
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::hydrostatic_sph
