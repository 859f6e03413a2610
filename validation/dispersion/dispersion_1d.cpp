/*
Small waves in the discrete dispersive shallow-water model with node spacing $s$ have a closed-form frequency. With
depth and gravity 1, $t = \tan(ks/2)$,

$$\omega^2 = \frac{2 + \cos ks}{3}\,\frac{4t^2}{s^2 + 4\alpha t^2}, \qquad \alpha = \tfrac13,$$

Frank's formula (13). As $s \to 0$ it becomes the dispersion relation of Serre, Green and Naghdi. The factor $(2 + \cos
ks)/3$ comes from the polygon's potential energy; it cancels the error of order $s^2$ of long waves. Other energies of a
cell's slope (`beta`) and an additional energy of slopes (`gamma`) have similar relations. The time step $\tau$ turns
$\omega$ into $\Omega$:

$$\sin\frac{\Omega\tau}{2} = \frac{\omega\tau}{2}\ \text{(one-step scheme)}, \qquad
\tan\frac{\Omega\tau}{2} = \frac{\omega\tau}{2}\ \text{(conservative scheme)}.$$

**Set-up.** A standing wave between two walls, half a wavelength apart, starts from the flat surface with the velocities
of the mode. Amplitudes are $10^{-5}$ and $2\cdot10^{-5}$ of the depth.

**What is compared.** Elevations are projected on the mode. A sinusoid fitted to the series gives the frequency; the two
amplitudes give the limit of small waves, which must equal the formula digit for digit. The wave of the parameters comes
first, then all points of the figure.

**What to look at.** The figure shows the accuracy of the model. At $kH = 1$, $L/H$ about 6, the celerity is 1 to 2 %
below Airy's; at $kH = 2$ it is 7 to 20 % below, depending on the spacing. With $\alpha$ and $\gamma$ tuned to spacing
and step the error at $kH = 2$ is 0.4 %. Deviations of the measured frequencies from the relation are round-off: the
program solves the equations that the formula describes.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/dispersion/small_waves.hpp"
#include "validation/instruments/dispersive_standing_mode.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::dispersion_1d {

using exact::FrankDispersion;
using Waves = SmallWaves<StandingBox>;

constexpr double pi = std::numbers::pi;
constexpr double amplitude = 1e-5;

StandingBox own_box(const Values& values) {
  const double k = values.real("wavenumber");
  return stable({.wavenumber = k,
                 .cells = StandingBox::cells_of(k, values.real("h")),
                 .tau = values.real("tau"),
                 .scheme = {.stepping = dispersive_shallow_water_1d::stepping_named(values.text("scheme"))},
                 .alpha = values.real("alpha"),
                 .slope_energy = values.real("beta"),
                 .gamma = values.real("gamma")});
}

/// A law for one spacing, with the frequencies of the one-step scheme for tau = s/2.
struct Family {
  std::string label;
  FrankDispersion law;

  [[nodiscard]] double tau() const { return 0.5 * law.spacing(); }
  [[nodiscard]] double speed(double k) const {
    return exact::discrete_frequency(law.frequency(k), tau(), exact::TimeScheme::one_step) / k;
  }
  /// Waves of one to 37 half-waves in a box of forty cells: not a multiple of three, since at ks = 2 pi/3 the markers
  /// see the second harmonic as the wave itself.
  [[nodiscard]] std::vector<StandingBox> boxes() const {
    constexpr std::size_t cells = 40;
    std::vector<StandingBox> boxes;
    for (const std::size_t half_waves : {1, 2, 3, 5, 8, 13, 20, 25, 31, 37}) {
      const double k = pi * static_cast<double>(half_waves) / (cells * law.spacing());
      if (k > deepest) break;
      boxes.push_back({.wavenumber = k,
                       .cells = cells,
                       .half_waves = half_waves,
                       .tau = tau(),
                       .alpha = law.parameters().alpha,
                       .gamma = law.parameters().gamma});
    }
    return boxes;
  }
};

std::vector<Family> families() {
  return {{"s = 0.25", FrankDispersion(1, 1, 0.25)},
          {"s = 0.5", FrankDispersion(1, 1, 0.5)},
          {"s = 1", FrankDispersion(1, 1, 1)},
          {"tuned", FrankDispersion::tuned(1, 1, 0.25, 0.125)}};
}

std::vector<StandingBox> boxes_of_figure() {
  std::vector<StandingBox> all;
  for (const Family& family : families()) std::ranges::copy(family.boxes(), std::back_inserter(all));
  return all;
}

struct Results {
  Waves own, figure;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const double periods = values.real("periods");
  const StandingBox own = own_box(values);
  claims.of(&Results::own)
      .at(fmt::format("{} cells, tau = {:g}", own.cells, own.tau))
      .check("frequency",
             "The frequency of the wave of the parameters equals the exact discrete dispersion relation to round-off.",
             "relative deviation of the frequency", worst_deviation<StandingBox>,
             frequency_roundoff(std::vector{own}, periods, &StandingBox::cells));
  claims.of(&Results::figure)
      .at("40 cells, 1 to 37 half-waves, tau = s/2")
      .check("figure",
             "The frequencies of all waves of the figure, up to the shortest resolved one, equal the exact dispersion "
             "relation to round-off.",
             "largest relative deviation of the frequency", worst_deviation<StandingBox>,
             frequency_roundoff(boxes_of_figure(), periods, &StandingBox::cells));
}

Results compute(const Run& run) {
  const double periods = run.real("periods");
  Results r{.own = small_waves(std::vector{own_box(run)}, periods, amplitude), .figure = {}};
  run.progress(0.1);
  r.figure = small_waves(boxes_of_figure(), periods, amplitude);
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("spacing_used", own_box(values).spacing());
  exhibit.measure("omega_measured", r.own.front().frequency);
  exhibit.measure("omega_theory", r.own.front().tank.linear_frequency());
  PhaseSpeedPanels panels(
      exhibit.figure("dispersion", "Phase speed of the discrete model",
                     "Lines: dispersion relations, discrete ones for the one-step scheme with tau = s/2, up to the "
                     "shortest resolved wave; the tuned pair is for s = 0.25. Circles: measured. The error of long "
                     "waves comes from the time step, $k^2\\tau^2/24$; the other errors from the model.",
                     {"frank-formula-13"}),
      0.07, 1e-8);
  const auto add = [&](const std::string& label, const auto& speed_of, double k_last, Role role) {
    const std::vector<double> k = evenly(0.02, k_last, 500);
    panels.add(label, k, each(k, speed_of), role);
  };
  const auto speed_by = [](const auto& law) { return [law](double k) { return law.phase_speed(k); }; };
  add("Airy", speed_by(exact::AiryDispersion(1, 1)), deepest, Role::exact);
  add("Green-Naghdi", speed_by(exact::RationalDispersion::green_naghdi(1, 1)), deepest, Role::guide);
  auto next = r.figure.begin();
  for (const Family& family : families()) {
    const auto speed = [&](double k) { return family.speed(k); };
    add(family.label, speed, std::min(deepest, 0.999 * pi / family.law.spacing()), Role::computed);
  }
  for (const Family& family : families()) {
    const Waves waves(next, next + std::ssize(family.boxes()));
    next += std::ssize(waves);
    panels.add("measured", each(waves, &Waves::value_type::wavenumber),
               each(waves, [](const auto& wave) { return wave.frequency / wave.wavenumber(); }), Role::data);
  }
}

void dispersion_1d(Case& c) {
  c.title = "Frequency of small standing waves: discrete dispersion relation";
  c.source = literature::frank + ", chapter 3, formula (13)";
  c.parameters = {
      real("wavenumber", 1.0, "1/H", {1e-2, 100}, "wavelength; the walls are half a wavelength apart"),
      real("h", pi / 31, "H", {1e-3, 10}, "node spacing; adjusted to fit a whole number of times between the walls"),
      real("tau", 0.2, "sqrt(H/g)", {1e-4, 2}, "time step"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
      real("alpha", 1.0 / 3, "1", {1e-3, 10}, "factor of the vertical kinetic energy"),
      real("beta", 1.0 / 3, "1", {1e-3, 10}, "factor of a cell's slope in its potential energy; 1/3 is the polygon's"),
      real("gamma", 0.0, "1", {0, 10}, "factor of the additional energy of slopes"),
      real("periods", 20.0, "1", {2, 1000}, "length of the series"),
  };
  c.published = {{.tiles = {"frank-formula-13"}, .stated = {"alpha", "beta", "gamma", "scheme"}}};
  c.study = Study(claims, compute, show, "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13)");
}

}  // namespace seiche::validation::cases::dispersion_1d
