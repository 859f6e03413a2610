#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/standing_wave.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::standing_wave_test {

using exact::StandingWave;
using validation::each;
using validation::evenly;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
const std::string source = "Tadjbakhsh and Keller, J. Fluid Mech. 8 (1960) 442";

/// A nonlinear standing wave found by shooting for time-periodic solutions of the full equations.
struct Exact {
  double depth, e, frequency;
  double second_harmonic;  ///< coefficient of cos 2x over e^2 when the surface is at rest
};

const std::vector<Exact> shallow{{0.8, 0.02, 0.8149617862391, 1.36302058}, {0.8, 0.04, 0.8151923676711, 1.36089734}};
const std::vector<Exact> deep{{3, 0.02, 0.9974749289387, 0.50494069}, {3, 0.04, 0.9973266767598, 0.50476016}};

double order_between(double coarse, double fine) {
  return std::log2(std::abs(coarse / fine));
}

/// Wave with k = g = 1.
StandingWave wave(double e, double depth) {
  return {e, 2 * pi, depth, 1};
}

/// Largest residuals of eta_t + u eta_x - v and of the surface pressure over half a wave and a period.
std::array<double, 2> free_surface(const StandingWave& w) {
  constexpr double span = 2e-2;
  Worst kinematic, dynamic;
  for (int i = 0; i <= 12; ++i) {
    for (int j = 0; j < 16; ++j) {
      const double x = pi * i / 12, t = w.period() * (j + 0.3) / 16;
      const double eta = w.elevation(x, t);
      const auto [u, v] = w.velocity(x, eta, t);
      const double rise = difference([&](double d) { return w.elevation(x, t + d); }, span);
      const double slope = difference([&](double d) { return w.elevation(x + d, t); }, span);
      kinematic.add(rise + u * slope - v);
      dynamic.add(w.pressure(x, eta, t));
    }
  }
  return {kinematic.value(), dynamic.value()};
}

void draw(Check& check) {
  auto& figure = check.figure(
      "frequency", "Frequency of a standing wave against depth",
      "Amplitude raises the frequency in shallow water and lowers it in deep water; the sign changes at $kh = 1.0581$, "
      "a wavelength of 5.938 h. Points: frequencies of the full equations, extrapolated to zero amplitude.");
  auto& panel =
      figure.panel({.x = "k h", .y = "omega_2", .title = "omega = w + e^2 omega_2/2", .y_min = -0.4, .y_max = 1});
  const std::vector<double> depths = evenly(0.5, 3.5, 241);
  panel.line("Tadjbakhsh and Keller", depths, each(depths, StandingWave::frequency_correction), Role::exact);
  const std::vector<double> ends{0.5, 3.5};
  panel.line("infinite depth, -1/4", ends, std::vector<double>{-0.25, -0.25}, Role::guide);
  panel.vertical("k h = 1.0581", std::vector<double>{StandingWave::critical_depth()});
  const std::vector<double> measured_depths{0.8, 1.0577, 1.5, 3};
  panel.points("full equations", measured_depths, std::vector<double>{0.386879, 0.000311, -0.174740, -0.246875},
               Role::peer);
}

TEST_CASE("the standing wave of Tadjbakhsh and Keller has the digits and frequencies known", "[exact]") {
  Check check("exact_standing_wave", "Second-order standing wave",
              "Residual of the two conditions at the free surface, evaluated at the displaced surface: third order in "
              "the steepness. "
              "Frequencies of the full nonlinear equations (time-periodic solutions found by shooting with 32 surface "
              "nodes): the formula leaves them with the fourth power of the steepness.",
              source);
  for (const double depth : {0.8, 2.0, infinite}) {
    const std::string name = depth == infinite ? "infinite" : depth < 1 ? "0-8" : "2";
    const Order third{3, 0.1, "first neglected order; the next is e <= 0.04 of it times numbers of order 1"};
    refine(check, {.axis = "steepness", .sizes = falling(0.04, 4), .title = {}, .floor = 1e-12},
           {{"kinematic-" + name, "The surface moves with the water to third order, k h = " + name + ".", third},
            {"dynamic-" + name, "The pressure at the surface is constant to third order, k h = " + name + ".", third}},
           [&](double e) { return free_surface(wave(e, depth)); });
  }
  for (const auto* cases : {&shallow, &deep}) {
    const Exact& fine = cases->front();
    const Exact& coarse = cases->back();
    const std::string name = fine.depth < 1 ? "0-8" : "3";
    const auto frequency_error = [](const Exact& c) { return c.frequency - wave(c.e, c.depth).frequency(); };
    const auto harmonic_error = [](const Exact& c) {
      return c.second_harmonic - StandingWave::second_harmonic(c.depth);
    };
    check.holds("The frequency differs from the full equations by the fourth power of e, k h = " + name + ".",
                {order_between(frequency_error(coarse), frequency_error(fine))},
                Bound{0.1,
                      "the next term is e^2 <= 0.0016 of it times a ratio of coefficients, which would have to exceed "
                      "40; frequencies known to 1e-13, 1e-5 of the difference",
                      4});
    check.holds("The second harmonic differs from the full equations by e^2 relative, k h = " + name + ".",
                {order_between(harmonic_error(coarse), harmonic_error(fine))},
                Bound{0.1,
                      "the next term is e^2 <= 0.0016 of it times a ratio of coefficients, which would have to exceed "
                      "40; a_2/e^2 known to 1e-8, 2e-4 of the difference",
                      2});
  }
  for (const Exact& c : {shallow.back(), Exact{1.5, 0.04, 0.9512527309968, 0.61850029}, deep.back()}) {
    const double change = c.frequency - StandingWave::linear_frequency(c.depth);
    const bool shallower = c.depth < StandingWave::critical_depth();
    const bool agree = (change > 0) == shallower && (StandingWave::frequency_correction(c.depth) > 0) == shallower;
    check.holds(shallower ? "Amplitude raises the frequency in water shallower than the critical depth."
                          : "Amplitude lowers the frequency in water deeper than the critical depth.",
                {agree ? 1.0 : 0.0},
                Qualitative{"signs of the frequency change at e = 0.04 and of omega_2",
                            "the critical depth k h = 1.0581 lies between k h = 0.8 and 1.5"});
  }
  draw(check);
}

}  // namespace seiche::verification::standing_wave_test
