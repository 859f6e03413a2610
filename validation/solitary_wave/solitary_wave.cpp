/*
A solitary wave of the full Euler equations travels over a flat bed without change of shape. The conformal solution of
`seiche exact solitary` gives surface, speed and velocities to round-off at every amplitude up to the limiting one.

**What is compared.** The case shows the wave and the identities between its integrals, $2 T = F (I - C)$ and $3 V =
(F^2 - 1) M$. It accepts external results: start a solver from the exact surface and velocities (`seiche exact solitary
--grid ...`) with the crest at $x = 0$, run it, and submit the surface at the given times and the crest speed.

**What to look at.** A too dissipative solver loses amplitude; a too dispersive one, or one of Boussinesq type, has the
wrong speed: the phase shift at the last time measures it.
*/

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::solitary_wave {

const std::string source = "Longuet-Higgins and Fenton (1974); Dutykh and Clamond (2014)";

exact::SolitaryWave wave_of(const Values& values) {
  return exact::SolitaryWave(values.real("amplitude"), values.real("depth"), values.real("gravity"));
}

void show(const exact::SolitaryWave& wave, const Values& /*values*/, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", wave.uncertainty());
  exhibit.measure("speed", wave.speed());
  exhibit.measure("mass", wave.mass());
  exhibit.measure("kinetic_energy", wave.kinetic_energy());
  exhibit.measure("potential_energy", wave.potential_energy());

  const double depth = wave.depth();
  const std::vector<double> x = evenly(-8 * depth, 8 * depth, 401);
  const exact::SerreSolitary model(wave.amplitude(), depth, wave.gravity());
  auto& figure = exhibit.figure("wave", "The solitary wave",
                                "Surface beside Rayleigh's (exact for Serre's equations), and horizontal velocity over "
                                "the depth at three sections.");
  auto& profile = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  profile.line("Euler", x, each(x, [&](double at) { return wave.elevation(at); }), Role::exact);
  profile.line("Rayleigh, Serre", x, each(x, [&](double at) { return model.elevation(at); }), Role::guide);
  auto& velocity = figure.panel({.x = "u [m/s]", .y = "y [m]"});
  for (const double at : {0.0, 1.0, 2.0}) {
    const std::vector<double> y = evenly(-depth, wave.elevation(at * depth), 81);
    const auto u = each(y, [&](double level) { return wave.velocity(at * depth, level).u; });
    velocity.line(at == 0 ? "x = 0" : at == 1 ? "x = depth" : "x = 2 depth", u, y, Role::exact);
  }
}

std::vector<WantedTable> wanted(const Values& values) {
  const Lazy<exact::SolitaryWave> wave([values] { return wave_of(values); });
  const double time = values.real("time");
  const double depth = values.real("depth");
  const double reach = 6 * depth;
  const std::string command = fmt::format("seiche exact solitary --set amplitude={},depth={},gravity={}",
                                          values.real("amplitude"), depth, values.real("gravity"));
  const auto surface = [=](double t) {
    return fmt::format("{} --grid x={}:{}:121,t={}", command, wave->speed() * t - reach, wave->speed() * t + reach, t);
  };
  const std::function<double()> speed = [wave] { return wave->speed(); };
  return {
      {.name = "surface",
       .kind = WantedTable::Kind::profile,
       .group = Column{"t", "s", "time since the crest was at x = 0"},
       .abscissa = Column{"x", "m", "position"},
       .quantities =
           {{.column = {"eta", "m", "surface elevation above still water"},
             .reference = [wave](Place p) { return wave->elevation(p.abscissa, p.group); },
             .requirements =
                 {within_tolerance(Measure::relative_l2, values,
                                   "The surface elevation agrees with the exact wave within the tolerance.", source),
                  within_tolerance(Measure::amplitude_ratio, values,
                                   "The wave height equals its initial value within the tolerance, by default 3.5 %.",
                                   source, 1)}}},
       .groups = {0.5 * time, time},
       .points = [wave, reach](double t) { return evenly(wave->speed() * t - reach, wave->speed() * t + reach, 121); },
       .exact =
           [=] {
             return std::vector{surface(0.5 * time), surface(time)};
           }},
      {.name = "numbers",
       .quantities = {wanted_number({"speed", "m/s", "speed of the crest"}, speed, values,
                                    "The crest speed agrees with the exact wave within the tolerance.", source)},
       .exact = {command + " --integrals"}}};
}

void solitary_wave(Case& c) {
  c.title = "Solitary wave of the Euler equations";
  c.source = "M. S. Longuet-Higgins, J. D. Fenton, Proc. R. Soc. A 340 (1974) 471; " + literature::dutykh_clamond;
  c.parameters = {
      real("amplitude", 0.3, "m", {1e-6, 1e6}, "crest above still water, up to 0.8331 depth"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("time", 10.0, "s", {1e-6, 1e6}, "last time at which a surface is requested"),
      tolerance_parameter(),
  };
  c.study = exact_study<wave_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::solitary_wave
