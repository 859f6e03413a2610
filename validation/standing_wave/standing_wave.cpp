/*
Water oscillates between two walls, half a wavelength or a multiple of it apart. Tadjbakhsh and Keller's expansion gives
surface and potential to second order in the amplitude and the frequency to third:

$$\frac{\omega}{\sqrt{gk}} = w + \tfrac12 (k a)^2 \omega_2, \qquad
\omega_2 = \frac{9 w^{-7} - 12 w^{-3} - 3 w - 2 w^5}{32}, \qquad w = \sqrt{\tanh kh}.$$

In deep water higher waves are slower, in shallow water faster; the sign changes at $kh = 1.05809$, $L/h = 5.93822$.

**What is compared.** The case shows the frequency correction and the surface. It accepts external results: start from
rest at maximum elevation (the template's `t = 0`), submit the elevation at the wall and the angular frequency.

**What to look at.** The limits follow from this wave: they exclude linear theory, and a depth 2 % too small. One
amplitude is insufficient for the frequency correction, since the linear frequency has a numerical error of its own:
score two amplitudes and compare the difference of frequencies with the references.
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/standing_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::standing_wave {

const std::string source = "Tadjbakhsh and Keller (1960)";

exact::StandingWave wave_of(const Values& values) {
  return {values.real("amplitude"), values.real("wavelength"), values.real("depth"), values.real("gravity")};
}

void show(const exact::StandingWave& wave, const Values& /*values*/, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", wave.uncertainty());
  exhibit.measure("frequency", wave.frequency());
  exhibit.measure("critical_depth", exact::StandingWave::critical_depth());
  const std::vector<double> x = evenly(0, std::numbers::pi / wave.wavenumber(), 201);
  auto& panel = add_panel(exhibit, "surface", "Half a wavelength at five instants",
                          "From maximum to minimum elevation at the left wall.", {.x = "x [m]", .y = "elevation [m]"});
  for (const double phase : {0.0, 0.125, 0.25, 0.375, 0.5}) {
    std::vector<double> eta = each(x, [&](const double at) { return wave.elevation(at, phase * wave.period()); });
    panel.line(phase == 0 ? "t = 0" : phase == 0.5 ? "half a period" : "", x, eta, Role::exact);
  }
}

/// How sharply the elevation at the wall can be judged, as relative L2 norms over the series that is asked for.
struct Sharpness {
  double linear = 0;     ///< by which the linear wave misses the theory
  double neglected = 0;  ///< pressure at the theory's surface, in elevation: what its expansion leaves out
};

Sharpness sharpness_of(const exact::StandingWave& wave, const Values& values, const std::vector<double>& times) {
  const double gravity = values.real("gravity");
  const double frequency = std::sqrt(gravity * wave.wavenumber()) *
                           exact::StandingWave::linear_frequency(wave.wavenumber() * values.real("depth"));
  double linear = 0;
  double neglected = 0;
  double size = 0;
  for (const double t : times) {
    const double eta = wave.elevation(0, t);
    linear += std::pow(values.real("amplitude") * std::cos(frequency * t) - eta, 2);
    neglected += std::pow(wave.pressure(0, eta, t) / gravity, 2);
    size += eta * eta;
  }
  return {std::sqrt(linear / size), std::sqrt(neglected / size)};
}

std::vector<WantedTable> wanted(const Values& values) {
  const auto wave = std::make_shared<const exact::StandingWave>(wave_of(values));
  const double periods = values.real("periods");
  const double end = periods * wave->period();
  const std::vector<double> times = evenly(0, end, 40 * static_cast<int>(std::ceil(periods)) + 1);
  const Sharpness sharpness = sharpness_of(*wave, values, times);
  constexpr double drawn = 0.01;
  const double limit = std::max(0.5 * sharpness.linear, drawn) + sharpness.neglected;
  const double useful = std::max(sharpness.linear, 2 * drawn);
  const std::string reason = fmt::format(
      "half of the difference of theory and linear wave, {:.2g}, at least 0.01, three times the error of linear "
      "interpolation between forty points per period; and the error of the expansion, the pressure at its surface, "
      "{:.2g}. Inconclusive beyond {:.2g}",
      sharpness.linear, sharpness.neglected, useful);
  // Of a phase that drifts evenly the mean square is a third of the last.
  const double drift = std::numbers::sqrt3 / (2 * std::numbers::pi * periods);
  const std::string command =
      fmt::format("seiche exact standing --set amplitude={:.17g},wavelength={:.17g},depth={:.17g},gravity={:.17g}",
                  values.real("amplitude"), values.real("wavelength"), values.real("depth"), values.real("gravity"));
  return {
      {.name = "wall",
       .kind = WantedTable::Kind::series,
       .abscissa = Column{"t", "s", "time since the surface was highest at x = 0"},
       .quantities = {{.column = {"eta", "m", "surface elevation at the wall x = 0"},
                       .reference = [wave](Place p) { return wave->elevation(0, p.abscissa); },
                       .requirements = {{.measure = Measure::relative_l2,
                                         .criterion = Bound{.limit = Amount::at_most(limit, useful), .reason = reason},
                                         .text = "The elevation at the wall agrees with finite-amplitude theory within "
                                                 "half its distance from the linear wave.",
                                         .source = source}}}},
       .points = [times](double) { return times; },
       .exact = {fmt::format("{} --grid x=0,t=0:{:.17g}:{}", command, end, times.size())}},
      {.name = "numbers",
       .quantities =
           {{.column = {"omega", "1/s", "angular frequency"},
             .reference = [wave](Place) { return wave->frequency(); },
             .requirements = {{.measure = Measure::value,
                               .criterion = Bound{.limit = Amount::at_most(drift * limit, drift * useful),
                                                  .reason = "a frequency whose drift equals the elevation limit: the "
                                                            "rms of 2 pi (periods) d/sqrt(3) over the series;  " +
                                                            reason,
                                                  .expected = wave->frequency(),
                                                  .relative = true},
                               .text = "The frequency agrees with finite-amplitude theory within the drift that the "
                                       "limit of the elevation allows.",
                               .source = source}}}},
       .exact = {command + " --integrals"}}};
}

void standing_wave(Case& c) {
  c.title = "A standing wave between walls, and its frequency";
  c.source = "I. Tadjbakhsh, J. B. Keller, Standing surface waves of finite amplitude, J. Fluid Mech. 8 (1960) 442";
  c.parameters = {
      real("amplitude", 0.05, "m", {1e-12, 1e6}, "first-order coefficient of cos k x"),
      real("wavelength", 2 * std::numbers::pi, "m", {1e-6, 1e6}, "wavelength; the walls are half a wavelength apart"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth at rest"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("periods", 5.0, "1", {1, 1e3}, "length of the requested series in periods"),
  };
  c.study = exact_study<wave_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::standing_wave
