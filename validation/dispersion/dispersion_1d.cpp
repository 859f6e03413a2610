/*
Small waves on level water, carried by the markers of the discrete dispersive shallow-water model at spacing $s$, have a
frequency in closed form. With depth and gravity 1, $t = \tan(ks/2)$,

$$\omega^2 = \frac{2 + \cos ks}{3}\,\frac{4t^2}{s^2 + 4\alpha t^2}, \qquad \alpha = \tfrac13,$$

Frank's formula (13). As $s \to 0$ it is the law of Serre, Green and Naghdi. The factor $(2 + \cos ks)/3$ comes from the
polygon's potential energy; it cancels the error of order $s^2$ of long waves. Other energies of a cell's slope (`beta`)
and an added energy of slopes (`gamma`) have similar laws. The time step $\tau$ turns $\omega$ into $\Omega$:

$$\sin\frac{\Omega\tau}{2} = \frac{\omega\tau}{2}\ \text{(one-step scheme)}, \qquad
\tan\frac{\Omega\tau}{2} = \frac{\omega\tau}{2}\ \text{(conservative scheme)}.$$

**Set-up.** A standing wave between two walls, half a wavelength apart. It starts from the flat surface with the
velocities of the mode. Its amplitude is $10^{-5}$ depths, then twice that.

**What is compared.** The elevations are projected on the mode. A sinusoid fitted to the series gives the frequency; the
two amplitudes give its limit for small waves. It must be the formula's, digit for digit. The wave of the parameters
comes first, then twelve others with both schemes, then other energies.

**What to look at.** The figure shows what the model is worth. At $kH = 1$, a wave of six depths, it is one to two per
cent slower than Airy's; at $kH = 2$ it is 7 to 20 per cent slower, depending on the spacing. With $\alpha$ and $\gamma$
tuned to spacing and step the error at $kH = 2$ is 0.4 per cent. The deviations of the measured frequencies from the law
are roundings: the program solves what the formula describes.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/dispersive_standing_mode.hpp"

namespace seiche::validation::cases {
namespace {

using dispersive_shallow_water_1d::Stepping;
using dispersive_shallow_water_1d::stepping_named;
using evidence::Bound;
using evidence::Role;
using exact::FrankDispersion;

const std::string source = "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13)";
constexpr double limit = 1e-11;
const std::string limit_reason = "positions of size 1 are rounded to 1e-16, that is 1e-11 of the amplitude 1e-5";

struct Deviation {
  double measured;
  double theory;
  [[nodiscard]] double relative() const { return std::abs(measured / theory - 1); }
};

Deviation deviation_of(const StandingBox& box, double periods) {
  return {smallest_wave_frequency(box, periods), box.linear_frequency()};
}

void claim_own_wave(Running& run) {
  const double k = run.real("wavenumber");
  const StandingBox box{.wavenumber = k,
                        .cells = StandingBox::cells_of(k, run.real("h")),
                        .tau = run.real("tau"),
                        .scheme = {.stepping = stepping_named(run.text("scheme"))},
                        .alpha = run.real("alpha"),
                        .slope_energy = run.real("beta"),
                        .gamma = run.real("gamma")};
  const Deviation deviation = deviation_of(box, run.real("periods"));
  run.record.measure("spacing_used", box.spacing());
  run.record.measure("omega_measured", deviation.measured);
  run.record.measure("omega_theory", deviation.theory);
  run.record.check(
      {.id = "frequency",
       .text = "The wave of the parameters has the frequency of the discrete model's law.",
       .quantity = "relative deviation of the frequency",
       .source = source},
      {.value = deviation.relative(), .resolution = fmt::format("{} cells, tau = {:g}", box.cells, box.tau)},
      Bound{limit, limit_reason});
}

/// Twelve waves from long and resolved to short and hardly so.
void claim_twelve_waves(Running& run) {
  constexpr double pi = std::numbers::pi;
  struct Wave {
    double k, spacing, tau;
  };
  const std::vector<Wave> waves = {{0.5, pi / 62, 0.05}, {0.5, pi / 12, 0.2}, {0.5, pi / 6, 0.3}, {1, pi / 31, 0.2},
                                   {1, pi / 31, 0.05},   {1, pi / 12, 0.1},   {1, pi / 3, 0.3},   {2, pi / 31, 0.05},
                                   {2, pi / 12, 0.1},    {2, pi / 6, 0.2},    {3, pi / 30, 0.05}, {3, pi / 12, 0.3}};
  evidence::Table table{.id = "waves",
                        .title = "Frequencies measured and of the law",
                        .caption = "Depth and gravity are 1; deviations are relative to the law.",
                        .columns = {{"wavenumber", ""},
                                    {"cells", ""},
                                    {"tau", ""},
                                    {"one-step: measured", ""},
                                    {"deviation", ""},
                                    {"conservative: measured", ""},
                                    {"deviation", ""}}};
  double worst_one_step = 0;
  double worst_conservative = 0;
  for (const Wave& wave : waves) {
    StandingBox box{.wavenumber = wave.k, .cells = StandingBox::cells_of(wave.k, wave.spacing), .tau = wave.tau};
    const Deviation one_step = deviation_of(box, run.real("periods"));
    box.scheme.stepping = Stepping::conservative;
    const Deviation conservative = deviation_of(box, run.real("periods"));
    worst_one_step = std::max(worst_one_step, one_step.relative());
    worst_conservative = std::max(worst_conservative, conservative.relative());
    table.rows.push_back({wave.k, static_cast<double>(box.cells), wave.tau, fmt::format("{:.13f}", one_step.measured),
                          one_step.relative(), fmt::format("{:.13f}", conservative.measured), conservative.relative()});
  }
  const auto claim = [&](const std::string& id, const std::string& scheme, double worst) {
    run.record.check({.id = id,
                      .text = fmt::format("Twelve waves have the law's frequency with the {} scheme.", scheme),
                      .quantity = "largest relative deviation of the frequency",
                      .source = source},
                     {.value = worst, .resolution = "3 to 124 cells, tau = 0.05 to 0.3"}, Bound{limit, limit_reason});
  };
  claim("one-step", "one-step", worst_one_step);
  claim("conservative", "conservative", worst_conservative);
  run.record.table(std::move(table));
}

void claim_other_energies(Running& run) {
  const FrankDispersion::Parameters tuned = FrankDispersion::tuned(1, 1, 0.25, 0.125).parameters();
  struct Variant {
    std::string id, text;
    double alpha, slope_energy, gamma;
  };
  const std::vector<Variant> variants = {
      {"gamma", "with the added energy of slopes, gamma = 1/15, alpha = 2/5", 0.4, 1.0 / 3, 1.0 / 15},
      {"tuned", "with alpha and gamma tuned to spacing and step", tuned.alpha, 1.0 / 3, tuned.gamma},
      {"beta", "with another energy of a cell's slope, beta = 3/5", 1.0 / 3, 0.6, 0},
      {"together", "with alpha, beta and gamma all changed", 0.35, 0.2, 0.05}};
  for (const Variant& variant : variants) {
    double worst = 0;
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      for (const double k : {0.7, 1.5, 3.0}) {
        const StandingBox box{.wavenumber = k,
                              .cells = StandingBox::cells_of(k, 0.25),
                              .tau = 0.125,
                              .scheme = {.stepping = stepping},
                              .alpha = variant.alpha,
                              .slope_energy = variant.slope_energy,
                              .gamma = variant.gamma};
        worst = std::max(worst, deviation_of(box, run.real("periods")).relative());
      }
    }
    run.record.check({.id = variant.id,
                      .text = "The law holds " + variant.text + ".",
                      .quantity = "largest relative deviation of the frequency",
                      .source = "the law of formula (13) with general alpha, beta, gamma"},
                     {.value = worst, .resolution = "kH = 0.7, 1.5, 3; s = 0.25, tau = 0.125, both schemes"},
                     Bound{limit, limit_reason});
  }
}

/// A law for one spacing, with the frequencies of the one-step scheme for tau = s/2.
struct Family {
  std::string label;
  FrankDispersion law;

  [[nodiscard]] double tau() const { return 0.5 * law.spacing(); }
  [[nodiscard]] double speed(double k) const {
    return exact::discrete_frequency(law.frequency(k), tau(), exact::TimeScheme::one_step) / k;
  }
};

struct Measured {
  std::vector<double> k, speed, deviation;
};

constexpr double deepest = 5;

/// Waves of one to 37 half-waves in a box of forty cells: not a multiple of three, since at ks = 2 pi/3 the markers see
/// the second harmonic as the wave itself.
Measured measure(const Family& family, double periods) {
  constexpr std::size_t cells = 40;
  Measured measured;
  for (const std::size_t half_waves : {1, 2, 3, 5, 8, 13, 20, 25, 31, 37}) {
    const double k = std::numbers::pi * static_cast<double>(half_waves) / (cells * family.law.spacing());
    if (k > deepest) break;
    const Deviation deviation = deviation_of({.wavenumber = k,
                                              .cells = cells,
                                              .half_waves = half_waves,
                                              .tau = family.tau(),
                                              .alpha = family.law.parameters().alpha,
                                              .gamma = family.law.parameters().gamma},
                                             periods);
    measured.k.push_back(k);
    measured.speed.push_back(deviation.measured / k);
    measured.deviation.push_back(deviation.relative());
  }
  return measured;
}

void draw(Running& run) {
  auto& figure = run.record.figure(
      "dispersion", "Phase speed of the discrete model",
      "Lines: the laws, the discrete ones for the one-step scheme with tau = s/2, up to the shortest wave that the "
      "markers resolve; the tuned pair is for s = 0.25. Circles: measured. The error of long waves is that of the time "
      "step, $k^2\\tau^2/24$; of the others that of the model.",
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
    std::vector<double> speeds;
    std::vector<double> errors;
    for (const double at : k) {
      speeds.push_back(speed_of(at));
      errors.push_back(error_of(at, speeds.back()));
    }
    speed.line(label, k, speeds, role);
    if (role != Role::exact) error.line(label, k, errors, role);
  };
  add(
      "Airy", [&](double k) { return airy.phase_speed(k); }, deepest, Role::exact);
  const exact::RationalDispersion serre = exact::RationalDispersion::green_naghdi(1, 1);
  add(
      "Green-Naghdi", [&](double k) { return serre.phase_speed(k); }, deepest, Role::guide);
  const std::vector<Family> families = {{"s = 0.25", FrankDispersion(1, 1, 0.25)},
                                        {"s = 0.5", FrankDispersion(1, 1, 0.5)},
                                        {"s = 1", FrankDispersion(1, 1, 1)},
                                        {"tuned", FrankDispersion::tuned(1, 1, 0.25, 0.125)}};
  for (const Family& family : families) {
    add(
        family.label, [&](double k) { return family.speed(k); },
        std::min(deepest, 0.999 * std::numbers::pi / family.law.spacing()), Role::computed);
  }
  double worst = 0;
  for (const Family& family : families) {
    const Measured measured = measure(family, run.real("periods"));
    std::vector<double> errors;
    for (std::size_t i = 0; i < measured.k.size(); ++i) errors.push_back(error_of(measured.k[i], measured.speed[i]));
    speed.points("measured", measured.k, measured.speed, Role::data);
    error.points("measured", measured.k, errors, Role::data);
    worst = std::max(worst, *std::max_element(measured.deviation.begin(), measured.deviation.end()));
  }
  run.record.check({.id = "figure",
                    .text = "So do all waves of the figure, up to the shortest that the markers resolve.",
                    .quantity = "largest relative deviation of the frequency",
                    .source = source},
                   {.value = worst, .resolution = "40 cells, 1 to 37 half-waves, tau = s/2"},
                   Bound{limit, limit_reason});
}

void run(Running& run) {
  claim_own_wave(run);
  run.progress(0.1);
  claim_twelve_waves(run);
  run.progress(0.5);
  claim_other_energies(run);
  run.progress(0.7);
  draw(run);
}

}  // namespace

Case dispersion_1d() {
  Case c;
  c.title = "Small standing waves have the frequency of the discrete dispersion law";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 3, formula (13)";
  c.parameters = {
      real("wavenumber", 1.0, "1/H", {1e-2, 100}, "of the wave; the walls are half a wavelength apart"),
      real("h", std::numbers::pi / 31, "H", {1e-3, 10},
           "of the markers; changed to fit a whole number of times between the walls"),
      real("tau", 0.2, "sqrt(H/g)", {1e-4, 2}, "time step"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
      real("alpha", 1.0 / 3, "1", {1e-3, 10}, "factor of the vertical kinetic energy"),
      real("beta", 1.0 / 3, "1", {1e-3, 10}, "factor of a cell's slope in its potential energy; 1/3 is the polygon's"),
      real("gamma", 0.0, "1", {0, 10}, "factor of the added energy of slopes"),
      real("periods", 20.0, "1", {2, 1000}, "length of the series"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
