/*
A steep periodic wave of the full Euler equations travels over a flat bed, or over deep water, without change of shape.
The conformal solution of `seiche exact stokes` gives surface, phase speed and velocities to round-off up to nearly
breaking waves.

**What is compared.** The case shows the wave and the identity $2 T = c I$. It accepts external results: start from the
exact surface and velocities with a crest at $x = 0$, in a periodic domain of one wavelength, and submit the surface at
the given times and the phase speed.

**What to look at.** Near the limiting steepness the crest sharpens towards 120 degrees and the speed falls again:
particle methods round it off, spectral ones ring.
*/
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/stokes_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::stokes_wave {

const std::string source = "Schwartz (1974); Cokelet (1977); Longuet-Higgins (1975)";

exact::StokesWave wave_of(const Values& values) {
  const double depth = values.real("depth");
  return {0.5 * values.real("height"), values.real("wavelength"), depth > 0 ? depth : exact::StokesWave::deep,
          values.real("gravity")};
}

void show(const exact::StokesWave& wave, const Values& /*values*/, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", wave.uncertainty());
  exhibit.measure("phase_speed", wave.phase_speed());
  exhibit.measure("crest_elevation", wave.crest_elevation());
  exhibit.measure("trough_elevation", wave.trough_elevation());
  exhibit.measure("crest_velocity", wave.crest_velocity());

  const std::vector<double> x = evenly(-wave.wavelength(), wave.wavelength(), 401);
  const auto surface = [&](double at) { return wave.elevation(at); };
  const auto linear = [&](double at) { return wave.amplitude() * std::cos(wave.wavenumber() * at); };
  const auto velocity = [&](double at) { return wave.velocity(at, surface(at)).u; };
  auto& figure = exhibit.figure("wave", "Two wavelengths of the wave",
                                "Surface beside a cosine of the same height; horizontal velocity of the surface.");
  auto& profile = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  profile.line("Euler", x, each(x, surface), Role::exact);
  profile.line("cosine", x, each(x, linear), Role::guide);
  figure.panel({.x = "x [m]", .y = "u at the surface [m/s]"}).line("Euler", x, each(x, velocity), Role::exact);
}

std::vector<WantedTable> wanted(const Values& values) {
  const Lazy<exact::StokesWave> wave([values] { return wave_of(values); });
  const double length = values.real("wavelength");
  const Lazy<double> last(
      [wave, length, periods = values.real("periods")] { return periods * (length / wave->phase_speed()); });
  const std::function<double()> speed = [wave] { return wave->phase_speed(); };
  const double depth = values.real("depth");
  const std::string command = fmt::format(
      "seiche exact stokes --set amplitude={:.17g},wavelength={:.17g},depth={:.17g},gravity={:.17g}",
      0.5 * values.real("height"), length, depth > 0 ? depth : exact::StokesWave::deep, values.real("gravity"));
  return {
      {.name = "surface",
       .kind = WantedTable::Kind::profile,
       .group = Column{"t", "s", "time since a crest was at x = 0"},
       .abscissa = Column{"x", "m", "position, over one wavelength"},
       .quantities =
           {{.column = {"eta", "m", "surface elevation above the mean level"},
             .reference = [wave](Place p) { return wave->elevation(p.abscissa, p.group); },
             .requirements =
                 {within_tolerance(Measure::relative_l2, values,
                                   "The surface elevation agrees with the exact wave within the tolerance.", source),
                  within_tolerance(Measure::amplitude_ratio, values,
                                   "The wave height equals its initial value within the tolerance, by default 3.5 %.",
                                   source, 1)}}},
       .groups =
           [last] {
             return std::vector{0.5 * *last, *last};
           },
       .points = [length](double) { return evenly(0, length, 129); },
       .exact =
           [=] {
             return std::vector{
                 fmt::format("{} --grid x=0:{:.17g}:129,t={:.17g}:{:.17g}:2", command, length, 0.5 * *last, *last)};
           }},
      {.name = "numbers",
       .quantities = {wanted_number({"phase_speed", "m/s", "phase speed, mean velocity at depth zero"}, speed, values,
                                    "The phase speed agrees with the exact wave within the tolerance.", source)},
       .exact = {command + " --integrals"}}};
}

void stokes_wave(Case& c) {
  c.title = "Steep periodic wave of the Euler equations";
  c.source = "L. W. Schwartz, J. Fluid Mech. 62 (1974) 553; E. D. Cokelet, Phil. Trans. R. Soc. A 286 (1977) 183";
  c.parameters = {
      real("height", 0.6, "m", {1e-6, 1e6}, "from trough to crest"),
      real("wavelength", 2 * std::numbers::pi, "m", {1e-6, 1e6}, "wavelength"),
      real("depth", 0.0, "m", {0, 1e6}, "mean depth; 0 is infinitely deep water"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("periods", 9.75, "1", {1e-3, 1e6},
           "periods until the last requested surface; after whole periods a stationary wave would look correct"),
      tolerance_parameter(),
  };
  c.study = exact_study<wave_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::stokes_wave
