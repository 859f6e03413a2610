#include <cmath>
#include <numbers>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/samples.hpp"
#include "verification/digits_table.hpp"
#include "verification/self_test_claims.hpp"

namespace solitary_asymptotic_test {

using namespace seiche;
using exact::AsymptoticSolitary;
using exact::BoussinesqSolitary;
using exact::GrimshawSolitary;
using exact::LaitoneSolitary;
using exact::SerreSolitary;
using exact::SolitaryWave;
using namespace seiche::verification;

const std::string series_source =
    "Boussinesq (1872); Rayleigh (1876); Laitone, J. Fluid Mech. 9 (1960) 430; Grimshaw, J. Fluid Mech. 46 (1971) 611";
const std::string serre_source = "Serre, Houille Blanche 8 (1953) 374; Green and Naghdi, J. Fluid Mech. 78 (1976) 237";

/// Residual of the steady Serre equations (w u' + g eta' + (alpha/h) (h^2 D^2 h)' = 0, w = u - c, D = w d/dx) at x by
/// nested fourth-order differences of half-width `span`.
double serre_residual(const SerreSolitary& wave, double alpha, double x, double span) {
  const auto difference = [span](const auto& f, double at) {
    return (8 * (f(at + 0.5 * span) - f(at - 0.5 * span)) - (f(at + span) - f(at - span))) / (6 * span);
  };
  const auto depth = [&](double p) { return wave.depth() + wave.elevation(p); };
  const auto relative = [&](double p) { return wave.depth_averaged_velocity(p) - wave.speed(); };
  const auto rate = [&](double p) { return relative(p) * difference(depth, p); };
  const auto dynamic = [&](double p) { return depth(p) * depth(p) * relative(p) * difference(rate, p); };
  return relative(x) * difference(relative, x) + wave.gravity() * difference(depth, x) +
         alpha / depth(x) * difference(dynamic, x);
}

/// Largest distance of two elevations over the wave.
double profile_error(const AsymptoticSolitary& wave, const SolitaryWave& truth) {
  Worst largest;
  const double width = 12 / std::sqrt(0.75 * truth.amplitude());
  for (int i = 0; i <= 400; ++i) {
    const double x = width * i * i / 160000;  // dense near the crest
    largest.add(wave.elevation(x) - truth.elevation(x));
  }
  return largest.value();
}

const std::vector<double> amplitudes{0.2, 0.1414, 0.1, 0.0707, 0.05};

struct Errors {
  std::vector<double> profile;
  std::vector<double> speed;
};

template <class Wave>
Errors errors_against(const std::vector<SolitaryWave>& waves) {
  Errors errors;
  for (const SolitaryWave& truth : waves) {
    const Wave wave(truth.amplitude());
    errors.profile.push_back(profile_error(wave, truth));
    errors.speed.push_back(std::abs(wave.speed() - truth.speed()));
  }
  return errors;
}

void draw(Check& check, const std::vector<std::pair<std::string, Errors>>& series) {
  auto& profiles =
      check.figure("profiles", "Solitary waves: series against the exact one",
                   "At a third of the depth the third-order profile is within the line width of the exact one; "
                   "at 0.6 none of the series is.");
  for (const double a : {0.3, 0.6}) {
    auto& panel =
        profiles.panel({.x = "x/depth", .y = "elevation/depth", .title = "a = " + std::to_string(a).substr(0, 3)});
    const SolitaryWave truth(a);
    const BoussinesqSolitary boussinesq(a);
    const SerreSolitary serre(a);
    const LaitoneSolitary laitone(a);
    const GrimshawSolitary grimshaw(a);
    std::vector<double> x;
    std::vector<double> exact_eta;
    for (int i = 0; i <= 240; ++i) {
      x.push_back(0.025 * i);
      exact_eta.push_back(truth.elevation(x.back()));
    }
    panel.line("Euler equations", x, exact_eta, Role::exact);
    const auto add = [&](const std::string& name, const AsymptoticSolitary& wave) {
      std::vector<double> eta;
      for (const double p : x) eta.push_back(wave.elevation(p));
      panel.line(name, x, eta, Role::peer);
    };
    add("Boussinesq", boussinesq);
    add("Rayleigh, Serre", serre);
    add("Laitone", laitone);
    add("Grimshaw", grimshaw);
  }
  auto& convergence = check.figure("errors", "Error of the series against amplitude",
                                   "Largest error of the profile against the exact wave, crest on crest.");
  auto& panel = convergence.panel(
      {.x = "amplitude/depth", .y = "largest error of the elevation/depth", .log_x = true, .log_y = true});
  for (const auto& [name, errors] : series) panel.points(name, amplitudes, errors.profile, Role::computed);
  for (const int order : {2, 3, 4}) {
    std::vector<double> slope;
    for (const double a : amplitudes) slope.push_back(0.2 * std::pow(a, order));
    panel.line("slope " + std::to_string(order), amplitudes, slope, Role::guide);
  }
}

TEST_CASE("the series for the solitary wave have the speeds and identities known", "[exact]") {
  Check check(
      "exact_solitary_series", "Solitary waves as series in amplitude",
      "Speeds of Grimshaw's wave to the digits known; excess mass in closed form against the profiles; "
      "$3V = (F^2-1)M$ where it holds exactly; the wave of Serre satisfies the equations of Serre at any amplitude, "
      "for "
      "any factor $\\alpha$ of the vertical kinetic energy.");
  check_table(check, "grimshaw-speed", "speeds of Grimshaw's wave, a = 0.1, 0.3, 0.5",
              {{GrimshawSolitary(0.1).speed(), "1.0485500192442623"},
               {GrimshawSolitary(0.3).speed(), "1.13769189904071"},
               {GrimshawSolitary(0.5).speed(), "1.2174328963613794"}},
              series_source);
  for (const double alpha : {1.0 / 3, 0.4}) {
    const SerreSolitary wave(1, 2, 9.81, alpha);
    Convergence residuals;
    for (double span = 0.8; span > 0.13; span /= std::numbers::sqrt2) {
      Worst largest;
      for (double x = 0.2; x < 8; x += 0.3) largest.add(serre_residual(wave, alpha, x, span));
      residuals.add(span, largest.value());
    }
    check.that({.id = alpha < 0.35 ? "serre" : "serre-alpha",
                .text = alpha < 0.35 ? "Rayleigh's wave satisfies the Serre equations."
                                     : "The wave with alpha = 0.4 satisfies the equations with alpha = 0.4.",
                .quantity = "order of the residual in the width of the differences, a = depth/2",
                .source = serre_source},
               residuals.order(1e-10), Order{4, 0.2, "fourth-order differences of an analytic solution"});
  }
  const SerreSolitary wave(0.6, 2, 9.81);
  Worst inverse;
  for (double x = -15; x < 15; x += 0.7) inverse.add(wave.place_of(wave.water_up_to(x)) - x);
  check.that({.id = "particles",
              .text = "The place of an amount of water is the inverse of the amount up to a place.",
              .quantity = "error of the place",
              .unit = "m",
              .source = serre_source},
             {.value = inverse.value()}, Roundoff{15, 17, "15 roundings of lengths up to 17 m"});
  self_test_holds(check, "boussinesq", BoussinesqSolitary(0.3, 2, 9.81));
  self_test_holds(check, "serre", wave);
  self_test_holds(check, "laitone", LaitoneSolitary(0.3, 2, 9.81));
  self_test_holds(check, "grimshaw", GrimshawSolitary(0.3, 2, 9.81));
  CHECK(std::abs(wave.elevation(3, 2) - wave.elevation(3 - 2 * wave.speed())) == 0);
  CHECK_THROWS_AS(BoussinesqSolitary(0), std::invalid_argument);
  CHECK_THROWS_AS(LaitoneSolitary(0.84), std::invalid_argument);
  CHECK_THROWS_AS(GrimshawSolitary(0.1, -1), std::invalid_argument);
  CHECK_THROWS_AS(SerreSolitary(0.1, 1, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(GrimshawSolitary(std::nan("")), std::invalid_argument);
  CHECK_NOTHROW(SerreSolitary(3));
}

TEST_CASE("the series leave the exact solitary wave with their orders in amplitude", "[exact]") {
  Check check(
      "exact_solitary_orders", "Order of the series for the solitary wave",
      "Profile and speed against the wave of the full Euler equations at amplitudes from 0.05 to 0.2 of the depth: the "
      "first "
      "term that a series neglects decides. This verifies the series and the exact solver by each other.");
  std::vector<SolitaryWave> waves;
  for (const double a : amplitudes) waves.emplace_back(a);
  const auto boussinesq = errors_against<BoussinesqSolitary>(waves);
  const auto serre = errors_against<SerreSolitary>(waves);
  const auto laitone = errors_against<LaitoneSolitary>(waves);
  const auto grimshaw = errors_against<GrimshawSolitary>(waves);
  const auto order = [&](const std::string& id, const std::string& text, const std::string& quantity,
                         const std::vector<double>& errors, double theory) {
    check.that({.id = id, .text = text, .quantity = quantity, .source = series_source},
               observed_order(amplitudes, errors, 1e-13),
               Order{theory, 0.25, "first neglected power of the amplitude; the next is 0.05 to 0.2 of it"});
  };
  const std::string profile = "order in amplitude/depth of the largest error of the elevation";
  order("boussinesq", "Boussinesq's profile is right to first order.", profile, boussinesq.profile, 2);
  order("rayleigh", "Rayleigh's profile is right to first order.", profile, serre.profile, 2);
  order("laitone", "Laitone's profile is right to second order.", profile, laitone.profile, 3);
  order("grimshaw", "Grimshaw's profile is right to third order.", profile, grimshaw.profile, 4);
  const std::string speed = "order in amplitude/depth of the error of the speed";
  order("speed-rayleigh", "c^2 = 1 + a is right to first order.", speed, serre.speed, 2);
  order("speed-laitone", "Laitone's speed is right to second order.", speed, laitone.speed, 3);
  order("speed-grimshaw", "Grimshaw's speed is right to third order.", speed, grimshaw.speed, 4);
  const std::string known = "regression: an earlier program for the exact wave and the series";
  check_table(
      check, "profile-errors", "largest errors of the profiles at a = 0.2 and 0.1",
      {{boussinesq.profile[0], "0.007117"},
       {boussinesq.profile[2], "0.002006"},
       {serre.profile[0], "0.005242"},
       {serre.profile[2], "0.001197"},
       {laitone.profile[0], "0.002912"},
       {laitone.profile[2], "0.0003559"},
       {grimshaw.profile[0], "0.0002761"},
       {grimshaw.profile[2], "0.00001825"}},
      series_source,
      {.relative = 1e-3, .reason = "1e-3, to which the places of the largest error were sampled by an " + known});
  check_table(check, "speed-errors", "errors of Grimshaw's speed at a = 0.1, 0.3, 0.5",
              {{GrimshawSolitary(0.1).speed() - SolitaryWave(0.1).speed(), "0.0000018"},
               {GrimshawSolitary(0.3).speed() - SolitaryWave(0.3).speed(), "0.00017"},
               {GrimshawSolitary(0.5).speed() - SolitaryWave(0.5).speed(), "0.0017"}},
              series_source, {.relative = 1e-14, .reason = "1e-14 of it; computed once by an " + known});
  draw(check, {{"Boussinesq", boussinesq}, {"Rayleigh, Serre", serre}, {"Laitone", laitone}, {"Grimshaw", grimshaw}});
}

}  // namespace solitary_asymptotic_test
