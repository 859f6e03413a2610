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

#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/dispersion/frequency_roundoff.hpp"
#include "validation/instruments/dispersive_standing_mode.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::dispersion_1d {

using dispersive_shallow_water_1d::Stepping;
using dispersive_shallow_water_1d::stepping_named;
using exact::FrankDispersion;

const std::string source = "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13)";
constexpr double pi = std::numbers::pi;

/// A frequency measured and of the law.
struct Found {
  double measured = 0;
  double theory = 0;
  [[nodiscard]] double deviation() const { return measured / theory - 1; }
};

std::vector<Found> frequencies(const std::vector<StandingBox>& boxes, double periods) {
  std::vector<Found> found;
  for (const StandingBox& box : boxes) {
    found.push_back({smallest_wave_frequency(box, periods), box.linear_frequency()});
  }
  return found;
}

Worst worst_of(const std::vector<Found>& found) {
  Worst deviation;
  for (const Found& f : found) deviation.add(f.deviation());
  return deviation;
}

StandingBox own_box(const Values& values) {
  const double k = values.real("wavenumber");
  return stable({.wavenumber = k,
                 .cells = StandingBox::cells_of(k, values.real("h")),
                 .tau = values.real("tau"),
                 .scheme = {.stepping = stepping_named(values.text("scheme"))},
                 .alpha = values.real("alpha"),
                 .slope_energy = values.real("beta"),
                 .gamma = values.real("gamma")});
}

constexpr double deepest = 5;

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
  for (const Family& family : families()) {
    const std::vector<StandingBox> boxes = family.boxes();
    all.insert(all.end(), boxes.begin(), boxes.end());
  }
  return all;
}

struct Results {
  std::vector<Found> own, figure;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const double periods = values.real("periods");
  const StandingBox own = own_box(values);
  const std::vector<StandingBox> figure = boxes_of_figure();
  claims.of(&Results::own)
      .at(fmt::format("{} cells, tau = {:g}", own.cells, own.tau))
      .check("frequency",
             "The frequency of the wave of the parameters equals the exact discrete dispersion relation to round-off.",
             "relative deviation of the frequency", worst_of,
             frequency_roundoff(std::vector{own}, periods, &StandingBox::cells));
  claims.of(&Results::figure)
      .at("40 cells, 1 to 37 half-waves, tau = s/2")
      .check("figure",
             "The frequencies of all waves of the figure, up to the shortest resolved one, equal the exact dispersion "
             "relation to round-off.",
             "largest relative deviation of the frequency", worst_of,
             frequency_roundoff(figure, periods, &StandingBox::cells));
}

Results compute(const Run& run) {
  const double periods = run.real("periods");
  Results r;
  r.own = frequencies({own_box(run)}, periods);
  run.progress(0.1);
  r.figure = frequencies(boxes_of_figure(), periods);
  return r;
}

void draw(evidence::Exhibit& exhibit, const std::vector<Found>& found) {
  auto& figure =
      exhibit.figure("dispersion", "Phase speed of the discrete model",
                     "Lines: dispersion relations, discrete ones for the one-step scheme with tau = s/2, up to the "
                     "shortest resolved wave; the tuned pair is for s = 0.25. Circles: measured. The error of long "
                     "waves comes from the time step, $k^2\\tau^2/24$; the other errors from the model.",
                     {"frank-formula-13"});
  auto& speed =
      figure.panel({.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed", .y_min = 0, .y_max = 1.05});
  auto& error = figure.panel({.x = "k H",
                              .y = "relative error",
                              .title = "Error against Airy",
                              .log_x = true,
                              .log_y = true,
                              .x_min = 0.07,
                              .x_max = deepest,
                              .y_min = 1e-8,
                              .y_max = 1});
  const exact::AiryDispersion airy(1, 1);
  const auto error_of = [&](double k, double of) { return std::abs(of / airy.phase_speed(k) - 1); };
  const auto add = [&](const std::string& label, const auto& speed_of, double k_last, Role role) {
    const std::vector<double> k = evenly(0.02, k_last, 500);
    const auto error_at = [&](double at) { return error_of(at, speed_of(at)); };
    speed.line(label, k, each(k, speed_of), role);
    if (role != Role::exact) error.line(label, k, each(k, error_at), role);
  };
  add(
      "Airy", [&](double k) { return airy.phase_speed(k); }, deepest, Role::exact);
  const exact::RationalDispersion serre = exact::RationalDispersion::green_naghdi(1, 1);
  add(
      "Green-Naghdi", [&](double k) { return serre.phase_speed(k); }, deepest, Role::guide);
  for (const Family& family : families()) {
    add(
        family.label, [&](double k) { return family.speed(k); }, std::min(deepest, 0.999 * pi / family.law.spacing()),
        Role::computed);
  }
  std::size_t next = 0;
  for (const Family& family : families()) {
    std::vector<double> k, speeds, errors;
    for (const StandingBox& box : family.boxes()) {
      k.push_back(box.wavenumber);
      speeds.push_back(found[next++].measured / box.wavenumber);
      errors.push_back(error_of(k.back(), speeds.back()));
    }
    speed.points("measured", k, speeds, Role::data);
    error.points("measured", k, errors, Role::data);
  }
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("spacing_used", own_box(values).spacing());
  exhibit.measure("omega_measured", r.own.front().measured);
  exhibit.measure("omega_theory", r.own.front().theory);
  draw(exhibit, r.figure);
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
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::dispersion_1d
