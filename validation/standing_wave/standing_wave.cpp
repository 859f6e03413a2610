/*
Water sloshes between two walls, half a wavelength apart or a multiple of it. Tadjbakhsh and Keller's expansion gives
the surface and the potential to second order in the amplitude and the frequency to third:

$$\frac{\omega}{\sqrt{gk}} = w + \tfrac12 (k a)^2 \omega_2, \qquad
\omega_2 = \frac{9 w^{-7} - 12 w^{-3} - 3 w - 2 w^5}{32}, \qquad w = \sqrt{\tanh kh}.$$

In deep water higher waves are slower, in shallow water faster; the sign changes at $kh = 1.05809$, where the wavelength
is 5.93822 depths.

**What is compared.** The case shows the frequency correction and the surface. It scores others: start from the surface
at rest at its highest (the template's `t = 0`), submit the elevation at the wall and the angular frequency.

**What to look at.** One amplitude tells little, since the linear frequency carries an error of its own: score two
amplitudes and compare the difference of frequencies with that of the references.
*/
#include <cmath>
#include <memory>
#include <numbers>

#include "seiche/exact/standing_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

const std::string source = "Tadjbakhsh and Keller (1960)";

exact::StandingWave wave_of(const Values& values) {
  return {values.real("amplitude"), values.real("wavelength"), values.real("depth"), values.real("gravity")};
}

struct Results {
  exact::StandingWave wave;
  exact::SelfTest identities;
};

void claims(const Values& values, const Claims<Results>& claims) {
  claim_identities(claims.of(&Results::identities), wave_of(values).self_test(), source);
}

Results compute(const Run& run) {
  const exact::StandingWave wave = wave_of(run);
  return {wave, wave.self_test()};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const exact::StandingWave& wave = r.wave;
  exhibit.measure("reference_uncertainty", wave.uncertainty());
  exhibit.measure("frequency", wave.frequency());
  exhibit.measure("critical_depth", exact::StandingWave::critical_depth());
  const std::vector<double> x = evenly(0, std::numbers::pi / wave.wavenumber(), 201);
  auto& figure = exhibit.figure("surface", "Half a wavelength at five instants",
                                "From the highest surface at the left wall to the lowest.");
  auto& panel = figure.panel({.x = "x [m]", .y = "elevation [m]"});
  for (const double phase : {0.0, 0.125, 0.25, 0.375, 0.5}) {
    std::vector<double> eta;
    for (const double at : x) eta.push_back(wave.elevation(at, phase * wave.period()));
    panel.line(phase == 0 ? "t = 0" : phase == 0.5 ? "half a period" : "", x, eta, Role::exact);
  }
}

std::vector<WantedTable> wanted(const Values& values) {
  const auto wave = std::make_shared<const exact::StandingWave>(wave_of(values));
  const double end = values.real("periods") * wave->period();
  const int count = 40 * static_cast<int>(std::ceil(values.real("periods"))) + 1;
  return {
      {.name = "wall",
       .kind = WantedTable::Kind::series,
       .abscissa = Column{"t", "s", "time since the surface was highest at x = 0"},
       .quantities = {{.column = {"eta", "m", "surface elevation at the wall x = 0"},
                       .reference = [wave](Place p) { return wave->elevation(0, p.abscissa); },
                       .requirements = {within_tolerance(Measure::relative_l2, values,
                                                         "The elevation at the wall is that of the theory.", source)}}},
       .points = [end, count](double) { return evenly(0, end, count); }},
      {.name = "numbers",
       .quantities = {wanted_number({"omega", "1/s", "angular frequency"}, wave->frequency(), values,
                                    "The frequency is that of the theory.", source)}}};
}

}  // namespace

Case standing_wave() {
  Case c;
  c.title = "A standing wave between walls, and its frequency";
  c.source = "I. Tadjbakhsh, J. B. Keller, Standing surface waves of finite amplitude, J. Fluid Mech. 8 (1960) 442";
  c.parameters = {
      real("amplitude", 0.05, "m", {1e-12, 1e6}, "first-order coefficient of cos k x"),
      real("wavelength", 2 * std::numbers::pi, "m", {1e-6, 1e6}, "wavelength: the walls are half of it apart"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth at rest"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("periods", 5.0, "1", {1, 1e3}, "periods of the series that is asked for"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show);
  c.submission = {.tables = wanted};
  return c;
}

}  // namespace seiche::validation::cases
