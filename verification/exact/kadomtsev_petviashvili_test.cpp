#include "seiche/exact/kadomtsev_petviashvili.hpp"
#include <array>

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "seiche/exact/mach_reflection.hpp"
#include "seiche/samples.hpp"
#include "verification/self_test_claims.hpp"

namespace kadomtsev_petviashvili_test {

using namespace seiche;
using exact::KadomtsevPetviashvili;
using exact::MachReflection;

const std::string source = "Kodama and Yeh, The KP theory and Mach reflection, J. Fluid Mech. 800 (2016) 766";
const std::string miles_source = "Miles, Resonantly interacting solitary waves, J. Fluid Mech. 79 (1977) 171";

double with_kappa(double kappa, double amplitude) {
  return std::atan(kappa * std::sqrt(3 * amplitude));
}

/// Place and height of the highest point along x within `reach` of a place.
struct Summit {
  double x, height;
};
Summit summit(const KadomtsevPetviashvili& waves, double x, double reach, double y, double t) {
  const auto [place, depth] = boost::math::tools::brent_find_minima([&](double s) { return -waves.elevation(s, y, t); },
                                                                    x - reach, x + reach, 50);
  return {place, -depth};
}

/// The equation in physical variables by central differences of fourth order of the elevation, over its largest term.
double differenced_defect(const KadomtsevPetviashvili& waves, double x, double y, double t, double span, double depth,
                          double gravity) {
  const double celerity = std::sqrt(gravity * depth);
  // The frame of long waves: (eta_t + c0 eta_x) is the rate of change at a fixed place in it.
  const auto eta = [&](int i, int j, int n) {
    const double later = t + n * span / celerity;
    return waves.elevation(x + i * span + celerity * (later - t), y + j * span, later);
  };
  const auto first = [&](auto f) { return (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * span); };
  const auto second = [&](auto f) { return (16 * (f(1) + f(-1)) - (f(2) + f(-2)) - 30 * f(0)) / (12 * span * span); };
  const double change = first([&](int i) { return first([&](int n) { return celerity * eta(i, 0, n); }); });
  const double steepening = 1.5 * celerity / depth * second([&](int i) { return 0.5 * eta(i, 0, 0) * eta(i, 0, 0); });
  const double dispersion =
      celerity * depth * depth / 6 * second([&](int i) { return second([&](int k) { return eta(i + k, 0, 0); }); });
  const double spreading = 0.5 * celerity * second([&](int j) { return eta(0, j, 0); });
  const double largest = std::max({std::abs(change), std::abs(steepening), std::abs(dispersion), std::abs(spreading)});
  return (change + steepening + dispersion + spreading) / largest;
}

TEST_CASE("reflected solitary waves solve the Kadomtsev-Petviashvili equation", "[exact]") {
  verification::Check check(
      "exact_kadomtsev_petviashvili", "Reflection of solitary waves by the Kadomtsev-Petviashvili equation",
      "The surface of Mach reflection ($\\kappa < 1$), of regular reflection ($\\kappa > 1$) and of the three crests "
      "at "
      "the end of a stem, from sums of exponentials. It solves the equation, by exact derivatives and by differences "
      "of "
      "the elevation in physical units; far from one another its crests are Miles's, in height, angle and place; the "
      "wall reaches $(1+\\kappa)^2 a_i$ exponentially.");
  const double amplitude = 0.1;
  const std::vector<std::pair<std::string, KadomtsevPetviashvili>> family{
      {"mach", KadomtsevPetviashvili(amplitude, with_kappa(0.6, amplitude))},
      {"near-resonance", KadomtsevPetviashvili(amplitude, with_kappa(0.95, amplitude))},
      {"regular", KadomtsevPetviashvili(amplitude, with_kappa(1.3, amplitude))},
      {"triad", KadomtsevPetviashvili(0.3 * 2.5, with_kappa(0.4, 0.3), 2.5, 9.81,
                                      KadomtsevPetviashvili::Pattern::resonant_triad)}};
  for (const auto& [name, waves] : family) {
    Worst worst;
    for (double t = 0; t <= 120; t += 30) {
      for (double y = 0; y <= 40; y += 5) {
        for (double s = -15; s <= 15; s += 3) {
          worst.add(waves.equation_defect(waves.wall().at(0, t) + s, y, t));
        }
      }
    }
    check.that({.id = "equation-" + name,
                .text = "The elevation satisfies the equation at 495 points, by exact derivatives.",
                .quantity = "largest defect over the largest term",
                .source = source},
               {.value = worst.value()},
               evidence::Roundoff{.operations = 2000,
                                  .scale = 10,
                                  .reason = "cumulants of order 6 of up to 5 terms, 400 roundings in each of 5 "
                                            "derivatives, that cancel to a tenth of their size"});
    claim_self_test(check, name, waves, source);
  }

  std::vector<double> spans;
  std::vector<double> errors;
  const double depth = 2.5;
  const double gravity = 9.81;
  const auto& triad = family.back().second;
  for (double span = 0.8; span > 0.15; span /= std::numbers::sqrt2) {
    Worst worst;
    for (const double s : {-2.0, 0.5, 1.5}) {
      for (const double y : {1.0, 8.0, 20.0}) {
        worst.add(differenced_defect(triad, triad.wall().at(0, 3) + s, y, 3, span, depth, gravity));
      }
    }
    spans.push_back(span);
    errors.push_back(worst.value());
  }
  check.that({.id = "physical-units",
              .text = "In water 2.5 m deep under 9.81 m/s^2 the equation holds by differences of the elevation.",
              .quantity = "order of the defect in the width of the differences",
              .source = "Kadomtsev and Petviashvili (1970)"},
             evidence::observed_order(spans, errors, 1e-8),
             evidence::Order{4, 0.2, "fourth-order differences of an analytic function, nothing else"});

  // What the other exponentials contribute at a crest is at most exp(-40) at these times and distances from the wall.
  const double S = std::sqrt(3 * amplitude);
  for (const double kappa : {0.3, 0.6, 0.8, 1.3, 2.0}) {
    const double angle = with_kappa(kappa, amplitude);
    const KadomtsevPetviashvili waves(amplitude, angle);
    const std::string name = fmt::format("kappa-{:02.0f}", 10 * kappa);
    const double t = waves.has_stem() ? 40 / waves.settling_rate() : 2000;
    const double y =
        (waves.has_stem() ? waves.triple_point(t).y : 0) + 40 / (S * S * kappa * (1 + std::min(kappa, 1.0)));
    const auto claim_height = [&](const std::string& crest, const KadomtsevPetviashvili::Crest& line, double at_y,
                                  double expected) {
      check.that(
          {.id = crest + "-" + name,
           .text = fmt::format("kappa = {:g}: the {} crest has Miles's height where its line says.", kappa, crest),
           .quantity = "a/a_i",
           .source = miles_source},
          {.value = waves.elevation(line.at(at_y, t), at_y, t) / amplitude},
          evidence::Roundoff{.operations = 100,
                             .scale = expected,
                             .reason = "100 roundings of the height; exponents are uncertain by some 100 eps, but a "
                                       "crest is stationary in them; the other crests reach here with exp(-40)",
                             .expected = expected});
    };
    claim_height("incident", waves.incident(), y, 1);
    claim_height("reflected", waves.reflected(), y, MachReflection::reflected_ratio(kappa));
    claim_height("wall", waves.wall(), 0, MachReflection::wall_ratio(kappa));
    check.that({.id = "angle-" + name,
                .text = fmt::format("kappa = {:g}: the reflected crest has Miles's angle.", kappa),
                .quantity = "tan psi_r",
                .source = miles_source},
               {.value = std::tan(waves.reflected().angle())},
               evidence::Roundoff{.operations = 16,
                                  .scale = 2,
                                  .reason = "16 roundings",
                                  .expected = waves.has_stem() ? std::sqrt(3 * amplitude) : std::tan(angle)});
    // Phase speed along the wall of the Korteweg-de Vries soliton in this equation: c0 (1 + a/2h + tan^2 psi/2).
    check.that({.id = "speed-" + name,
                .text = fmt::format("kappa = {:g}: incident and wall crest travel together.", kappa),
                .quantity = "speed along the wall",
                .source = miles_source},
               {.value = waves.incident().speed},
               evidence::Roundoff{.operations = 16,
                                  .scale = 2,
                                  .reason = "16 roundings",
                                  .expected = 1 + 0.5 * amplitude + 0.5 * std::tan(angle) * std::tan(angle)});
    const Summit found = summit(waves, waves.incident().at(y, t), 2, y, t);
    check.that({.id = "place-" + name,
                .text = fmt::format("kappa = {:g}: the incident crest is where its line says.", kappa),
                .quantity = "x - x of the line",
                .source = source},
               {.value = found.x - waves.incident().at(y, t)},
               evidence::Bound{.limit = 1e-6, .reason = "a maximum is found to the root of round-off of x = 2000"});
  }

  const KadomtsevPetviashvili mach(amplitude, with_kappa(0.6, amplitude));
  const KadomtsevPetviashvili::Point end = mach.triple_point(300);
  check.that({.id = "triple-point",
              .text = "Incident and reflected crest and the stem meet in one point.",
              .quantity = "largest distance along x of the three lines",
              .source = source},
             {.value = seiche::worst(
                  std::array{mach.incident().at(end.y, 300) - end.x, mach.reflected().at(end.y, 300) - end.x})},
             evidence::Roundoff{.operations = 16, .scale = 400, .reason = "16 roundings of lengths up to 400"});
  check.that(
      {.id = "stem-growth",
       .text = "The end of the stem leaves the wall at S (1 - kappa)/3, Miles's angle.",
       .quantity = "dy/dt of the triple point over c0",
       .source = miles_source},
      {.value = end.y / 300},
      evidence::Roundoff{.operations = 16, .scale = S * 0.4 / 3, .reason = "16 roundings", .expected = S * 0.4 / 3});

  // The next exponential decays twice as fast: 2 e^{-rt} + O(e^{-2rt}); between rt = 12 and 14 that is 1e-5.
  const double rate = mach.settling_rate();
  const auto missing = [&](double rt) {
    const double t = rt / rate;
    return mach.wall().amplitude - summit(mach, mach.wall().at(0, t), 2, 0, t).height;
  };
  check.that({.id = "settling",
              .text = "The wall approaches its limit exponentially with the rate S^3 kappa (1 - kappa)/3.",
              .quantity = "rate over c0/h",
              .source = source},
             {.value = std::log(missing(12) / missing(14)) / 2 * rate},
             evidence::Bound{.limit = 1e-4,
                             .reason = "the next exponential, e^{-12}, and the round-off of a height known to 1e-13 of "
                                       "which 1e-6 is left",
                             .expected = S * S * S * 0.6 * 0.4 / 3,
                             .relative = true});

  const auto refused = [](double a, double angle, double h, double g) {
    CHECK_THROWS_AS(KadomtsevPetviashvili(a, angle, h, g), std::invalid_argument);
  };
  refused(0, 0.3, 1, 1);
  refused(0.1, 0, 1, 1);
  refused(0.1, 1.6, 1, 1);
  refused(0.1, 0.3, -1, 1);
  refused(0.1, 0.3, 1, std::nan(""));
  refused(0.1, with_kappa(1, 0.1), 1, 1);
  CHECK_THROWS_AS(
      KadomtsevPetviashvili(0.1, with_kappa(1.2, 0.1), 1, 1, KadomtsevPetviashvili::Pattern::resonant_triad),
      std::invalid_argument);
  CHECK_THROWS_AS(KadomtsevPetviashvili(0.1, with_kappa(1.2, 0.1)).triple_point(1), std::logic_error);
  CHECK_THROWS_AS(mach.elevation(std::nan(""), 0, 0), std::invalid_argument);
}

}  // namespace kadomtsev_petviashvili_test
