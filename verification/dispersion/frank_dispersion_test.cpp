#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/dispersive_standing_mode.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::frank_dispersion_test {

using namespace dispersive_shallow_water_1d;
using validation::StandingBox;

constexpr double pi = std::numbers::pi;
/// Elevations count from rest and are rounded relative to the amplitude, whatever it is; places to 1e-16 of the box.
const Roundoff round_off{
    150, 4.0 / 3,
    "widths of up to 25 cells are differences of positions, rounded to the part 2^-52 of the box: the error of each is "
    "the number of cells, of their mean its root, as if there were 25 cells of two positions in each of two runs; "
    "fifty roundings of the law and the fit; the extrapolation weighs a run by 4/3"};
const Bound fed_back{1e-11,
                     "volumes that are fed back bring the rounding of positions of size 1, 1e-16, into an amplitude of "
                     "1e-4, divided by phases of a step of about a tenth"};

/// Numbers in [0, 1) that fill the cube of nine dimensions evenly: additive recurrence with powers of the root of
/// x^10 = x + 1, which generalises the golden ratio.
double even_number(std::size_t dimension, int index) {
  constexpr double ratio = 1.0757660660868371;
  double whole = 0;
  return std::modf(0.5 + index * std::pow(ratio, -static_cast<double>(dimension + 1)), &whole);
}

double highest_frequency(const StandingBox& box) {
  const auto law = box.law();
  Largest highest;
  for (int i = 1; i < 100; ++i) highest.add(law.frequency(0.01 * i * pi / box.spacing()));
  return highest.value();
}

StandingBox any_box(int index, Stepping stepping) {
  StandingBox box;
  const auto within = [&](std::size_t dimension, double low, double high) {
    return low + (high - low) * even_number(dimension, index);
  };
  box.depth = within(0, 0.3, 4);
  box.gravity = within(1, 1, 20);
  box.cells = static_cast<std::size_t>(within(2, 3, 25));
  box.half_waves = 1 + static_cast<std::size_t>(within(3, 0, static_cast<double>(box.cells - 1)));
  // At ks = 2 pi/3 the markers see the second harmonic as the wave itself.
  if (3 * box.half_waves == 2 * box.cells) --box.half_waves;
  const double spacing = box.depth * within(4, 0.2, 1.2);
  box.wavenumber = pi * static_cast<double>(box.half_waves) / (static_cast<double>(box.cells) * spacing);
  box.gamma = within(5, 0, 0.1);
  box.alpha = box.gamma + within(6, 0.2, 0.5);
  box.slope_energy = within(7, 0.05, 1);
  box.tau = within(8, 0.1, 0.6) * 2 / highest_frequency(box);
  box.scheme.stepping = stepping;
  return box;
}

/// A wave that travels through a periodic channel of one wavelength, started from its surface.
double progressive_frequency(const StandingBox& box, double amplitude, double direction) {
  Channel channel = box.channel();
  channel.period = 2 * box.length();
  const std::vector<double> labels = equal_labels(channel, 0, channel.period, 2 * box.cells);
  const double k = box.wavenumber;
  const double shift = 0.5 * box.spacing() / (box.depth * std::tan(0.5 * k * box.spacing()));
  const double omega = direction * box.law().frequency(k);
  Markers start;
  for (const double x : labels) {
    start.x.push_back(x - amplitude * shift * std::sin(k * x));
    start.y.push_back(amplitude * std::cos(k * x));
    start.u.push_back(amplitude * shift * omega * std::cos(k * x));
    start.v.push_back(amplitude * omega * std::sin(k * x));
  }
  Flow flow(channel, start, box.scheme);
  std::vector<double> samples;
  const auto steps = static_cast<long>(20 * 2 * pi / (std::abs(omega) * box.tau));
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) flow.advance(box.tau);
    double sum = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) sum += flow.y()[i] * std::cos(k * labels[i]);
    samples.push_back(sum / static_cast<double>(box.cells));
  }
  return validation::fit_oscillation(samples, box.tau).frequency;
}

TEST_CASE("small waves have the frequency of the discrete law for any parameters", "[dispersion]") {
  Check check(
      "dispersion_frank", "Dispersion of the discrete dispersive shallow-water model",
      "Standing waves between walls, for 60 sets of depth, gravity, spacing, wavenumber up to the shortest that nodes "
      "resolve, time step, and factors alpha, beta, gamma of the energies, spread evenly over their ranges. The "
      "frequency, fitted to the series and extrapolated to zero amplitude, agrees with the closed form.");
  auto& figure = check.figure("deviation", "Deviation of measured frequencies from the law",
                              "60 sets of parameters; a deviation of zero is drawn as $10^{-17}$.");
  auto& panel = figure.panel({.x = "k s/pi", .y = "relative deviation", .log_y = true, .y_max = 1e-7});
  for (const auto& [stepping, label] : {std::pair{Stepping::one_step, "one-step"},
                                        {Stepping::one_step_feedback, "one-step with volume feedback"},
                                        {Stepping::conservative, "conservative"}}) {
    std::vector<double> resolution, deviation;
    Largest worst;
    // Fed back volumes bring their own rounding into the velocities, divided by the time step.
    const double amplitude = stepping == Stepping::one_step_feedback ? 1e-4 : 1e-5;
    for (int index = 1; index <= 60; ++index) {
      const StandingBox box = any_box(index, stepping);
      const double measured = validation::smallest_wave_frequency(box, 12, amplitude);
      const double relative = std::abs(measured / box.linear_frequency() - 1);
      worst.add(relative);
      resolution.push_back(box.wavenumber * box.spacing() / pi);
      deviation.push_back(std::max(relative, 1e-17));
    }
    panel.points(label, resolution, deviation);
    check.holds(
        fmt::format("The frequencies of small waves agree with the discrete dispersion relation ({} scheme).", label),
        {worst.value()},
        stepping == Stepping::one_step_feedback ? evidence::Criterion(fed_back) : evidence::Criterion(round_off));
  }
  panel.line("limit with volume feedback", std::vector{0.0, 1.0}, std::vector(2, fed_back.limit.value()), Role::guide);
}

TEST_CASE("progressive waves have the frequency of standing waves", "[dispersion]") {
  Check check("dispersion_progressive", "Progressive waves in a periodic channel",
              "The matrix of a periodic channel is cyclic and there are no walls: another program path, the same law.");
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    for (const double direction : {1.0, -1.0}) {
      Worst worst;
      for (const double k : {0.6, 1.3, 2.9}) {
        const StandingBox box{.wavenumber = k, .cells = 10, .tau = 0.15, .scheme = {.stepping = stepping}};
        const double once = progressive_frequency(box, 1e-5, direction);
        const double twice = progressive_frequency(box, 2e-5, direction);
        worst.add((once + (once - twice) / 3) / box.linear_frequency() - 1);
      }
      check.holds(fmt::format("{}-{}", stepping == Stepping::one_step ? "one-step" : "conservative",
                              direction > 0 ? "right" : "left") +
                      ": Progressive waves have the frequency of standing waves, in both directions.",
                  {worst.value()}, round_off);
    }
  }
}

TEST_CASE("compositions converge to the dispersion of continuous time at fourth order in the step", "[dispersion]") {
  Check check("dispersion_compositions", "Frequencies of the fourth-order compositions",
              "Triple jump and Suzuki's composition, of both schemes: the frequency departs from its value in "
              "continuous time as $\\tau^4$.",
              "Yoshida (1990); Suzuki (1990)");
  std::vector<double> steps;
  for (double tau = 0.32; tau > 0.03; tau /= std::numbers::sqrt2) steps.push_back(tau);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    for (const TimeComposition composition : {TimeComposition::triple_jump, TimeComposition::suzuki}) {
      const std::string id = fmt::format("{}-{}", stepping == Stepping::one_step ? "one-step" : "conservative",
                                         composition == TimeComposition::suzuki ? "suzuki" : "triple-jump");
      refine(check, {"tau", steps, id, "Frequency, " + id, 1e-12},
             {{id,
               "The frequency of the composition is fourth-order accurate:  " + id + ".",
               {4, 0.1, "errors in even powers: the next is (omega tau)^2 = 0.1 of it at most"}}},
             [&](double tau) {
               const StandingBox box{.wavenumber = 1.5,
                                     .cells = 10,
                                     .tau = tau,
                                     .scheme = {.stepping = stepping, .composition = composition}};
               return std::abs(validation::smallest_wave_frequency(box, 12) / box.law().frequency(1.5) - 1);
             });
    }
  }
}

}  // namespace seiche::verification::frank_dispersion_test
