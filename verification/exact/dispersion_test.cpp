#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/exact/wavemaker.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersion_test {

using namespace exact;
using validation::each;
using validation::evenly;

constexpr double infinite = std::numeric_limits<double>::infinity();
const std::string laws_source = "Airy (1845); Green and Naghdi (1976); Madsen and Sorensen (1992); Nwogu (1993)";
const std::string frank_source = "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13)";

const AiryDispersion airy(1, 1);

/// Relative error against Airy of the frequency of the one-step scheme.
double error_in_time(const FrankDispersion& law, double k, double time_step) {
  return exact::discrete_frequency(law.frequency(k), time_step, TimeScheme::one_step) / airy.frequency(k) - 1;
}

void draw_laws(Check& check) {
  auto& figure = check.figure("phase-speed", "Phase speed of the models",
                              "Long waves agree; the error against Airy grows as $(kH)^4$ for Green-Naghdi and as "
                              "$(kH)^6$ for the equations tuned to him.");
  const auto k = evenly(0.05, 6, 240);
  auto& speed = figure.panel({.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed", .y_min = 0});
  auto& error = figure.panel({.x = "k H",
                              .y = "|omega/omega_Airy - 1|",
                              .title = "Error against Airy",
                              .log_x = true,
                              .log_y = true,
                              .y_min = 1e-10});
  speed.line("Airy", k, each(k, [](double q) { return airy.phase_speed(q); }), Role::exact);
  const auto add = [&](const std::string& name, const auto& law, Role role) {
    speed.line(name, k, each(k, [&](double q) { return law.phase_speed(q); }), role);
    error.line(name, k, each(k, [&](double q) { return std::abs(law.phase_speed(q) / airy.phase_speed(q) - 1); }),
               role);
  };
  add("Green-Naghdi, Serre, Peregrine", RationalDispersion::green_naghdi(1, 1), Role::computed);
  add("Nwogu", RationalDispersion::nwogu(1, 1), Role::peer);
  add("Madsen-Sorensen", RationalDispersion::madsen_sorensen(1, 1), Role::peer);
  add("tuned nodes, h = 0.25", FrankDispersion::tuned(1, 1, 0.25, 0), Role::computed);
}

void draw_formula_13(Check& check) {
  auto& figure = check.figure("formula-13", "Formula (13) for several spacings",
                              "The discrete model follows Green-Naghdi to second order in the spacing $s$ and slows "
                              "the waves that the nodes barely resolve; the curves end at $k s = \\pi$.",
                              {});
  auto& speed = figure.panel({.x = "k H", .y = "phase speed/sqrt(g H)", .title = "Phase speed", .y_min = 0});
  const auto k = evenly(0.02, 6, 300);
  const auto limit = RationalDispersion::green_naghdi(1, 1);
  speed.line("Airy", k, each(k, [](double q) { return airy.phase_speed(q); }), Role::exact);
  speed.line("Green-Naghdi", k, each(k, [&](double q) { return limit.phase_speed(q); }), Role::guide);
  auto& error = figure.panel({.x = "s/H",
                              .y = "|omega/omega_GN - 1|",
                              .title = "Distance from Green-Naghdi at k H = 1",
                              .log_x = true,
                              .log_y = true});
  for (const double s : {0.25, 0.5, 1.0, 2.0}) {
    const FrankDispersion law(1, 1, s);
    const auto resolved = evenly(0.02, std::min(6.0, 0.999 * std::numbers::pi / s), 300);
    speed.line("s/H = " + std::to_string(s).substr(0, 4), resolved,
               each(resolved, [&](double q) { return law.phase_speed(q); }));
  }
  const std::vector<double> spacings{0.0625, 0.125, 0.25, 0.5, 1, 2};
  error.points("formula (13)", spacings, each(spacings, [&](double s) {
                 return std::abs(FrankDispersion(1, 1, s).frequency(1) / limit.frequency(1) - 1);
               }));
  error.line("(s/H)^2/48", spacings, each(spacings, [](double s) { return s * s / 48; }), Role::guide);
}

TEST_CASE("the laws of dispersion have the digits known, and their inverses", "[exact]") {
  Check check("exact_dispersion", "Dispersion of small waves",
              "The order in $kH$ at "
              "which each leaves Airy's; the identities of each law.");
  const auto gn = RationalDispersion::green_naghdi(1, 1);
  const auto ms = RationalDispersion::madsen_sorensen(1, 1);
  const auto nwogu = RationalDispersion::nwogu(1, 1);
  const auto leaves_airy = [](const std::string& id, const std::string& name, double order) {
    return Refined{id,
                   name + " leaves Airy's law with the power of kH that it was built for.",
                   {order, 0.1, "first term of the expansions that differs; the next is (kH)^2 <= 0.16 of it"}};
  };
  check.source(laws_source);
  refine(check, {.axis = "k H", .sizes = falling(0.4, 7, std::numbers::sqrt2), .title = {}, .floor = 1e-14},
         {leaves_airy("order-green-naghdi", "Green-Naghdi", 4), leaves_airy("order-nwogu", "Nwogu's law", 4),
          leaves_airy("order-madsen-sorensen", "Madsen and Sorensen's law", 6)},
         [&](double k) {
           const auto error = [&](const auto& law) { return std::abs(law.frequency(k) / airy.frequency(k) - 1); };
           return std::array{error(gn), error(nwogu), error(ms)};
         });
  draw_laws(check);
  CHECK(std::abs(AiryDispersion(9.81, 1e3).wavenumber(2) - 4 / 9.81) < 1e-15);
  CHECK_THROWS_AS(airy.wavenumber(-1), std::invalid_argument);
  CHECK_THROWS_AS(airy.wavenumber(std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(gn.wavenumber(gn.highest_frequency()), std::invalid_argument);
}

TEST_CASE("the discrete dispersion law converges to Green-Naghdi and can be tuned to Airy", "[exact]") {
  Check check("exact_frank_dispersion", "Dispersion of a chain of nodes",
              "Second order in the spacing against Green-Naghdi, with its leading "
              "term; the frequencies of the two time schemes; the pair $(\\alpha, \\gamma)$ that follows Airy's law "
              "through $(kH)^4$ at a given spacing and time step.");
  const FrankDispersion fine(1, 1, 0.1);
  const auto quarter = FrankDispersion::tuned(1, 1, 0.25, 0.125);
  const auto gn = fine.limit();
  check.source(frank_source);
  const auto leading = [&](double s) {
    return (FrankDispersion(1, 1, s).frequency(1) / gn.frequency(1) - 1) / (s * s);
  };
  check.that("leading-term",
             "Formula (13) tends to Green-Naghdi with the square of the spacing: the distance is -alpha (kH)^4 "
             "(s/H)^2/(12 (1 + alpha (kH)^2)) to leading order.",
             "(omega/omega_GN - 1)/h^2 at k H = 1, s/H = 1/128", {leading(1.0 / 128)},
             Bound{1.0 / 16384, "the next term of the expansion is of relative size h^2 = 1/16384", -1.0 / 48, true});
  refine(check, {.axis = "k H", .sizes = falling(0.6, 6, std::numbers::sqrt2), .title = {}, .floor = 1e-14},
         {{"order-tuned",
           "The tuned pair follows Airy's law through (kH)^4: the first error is (kH)^6.",
           {6, 0.3, "two coefficients of the expansion in (kH)^2 are matched; next term (kH)^2 of it"}}},
         [&](double k) { return std::abs(error_in_time(quarter, k, 0.125)); });
  for (const auto scheme : {TimeScheme::one_step, TimeScheme::conservative}) {
    const bool one_step = scheme == TimeScheme::one_step;
    check.holds(one_step ? "The one-step scheme raises the frequency by omega^2 tau^2/24."
                         : "The conservative scheme lowers the frequency by omega^2 tau^2/12.",
                {(exact::discrete_frequency(2, 0.01, scheme) / 2 - 1) / 4e-4},
                Bound{4e-4, "the next term of the series is (omega tau)^2 = 4e-4 of it",
                      one_step ? 1.0 / 24 : -1.0 / 12, true});
  }
  draw_formula_13(check);
  CHECK_THROWS_AS(exact::discrete_frequency(2.01, 1, TimeScheme::one_step), std::invalid_argument);
  CHECK_THROWS_AS(exact::discrete_frequency(0, 1, TimeScheme::conservative), std::invalid_argument);
  CHECK_NOTHROW(exact::discrete_frequency(5, 1, TimeScheme::conservative));
  CHECK(std::abs(FrankDispersion(9.81, 2, 0.2).frequency(0.5) / (std::sqrt(9.81 / 2) * fine.frequency(1)) - 1) < 2e-15);
}

TEST_CASE("a wave is the same by wavelength, period and frequency", "[exact]") {
  Check check("exact_wave_scale", "One wave, known by three numbers",
              "A wave of 12 m in water 3 m deep is given by its wavelength, period and angular frequency, "
              "as a progressive wave and to a piston and a flap.");
  const exact::Water water{.gravity = 9.81, .depth = 3};
  const exact::AiryWave wave(0.1, exact::Wavelength{12}, water);
  CHECK_THROWS_AS(wave.elevation(std::numeric_limits<double>::quiet_NaN(), 0), std::invalid_argument);
  CHECK_THROWS_AS(wave.elevation(0, std::numeric_limits<double>::infinity()), std::invalid_argument);
  Worst apart;
  for (const exact::WaveScale& given :
       {exact::WaveScale(exact::Period{wave.period()}), exact::WaveScale(exact::AngularFrequency{wave.frequency()})}) {
    apart.add(exact::AiryWave(0.1, given, water).wavenumber() / wave.wavenumber() - 1);
    for (const auto paddle : {exact::Paddle::piston, exact::Paddle::flap}) {
      apart.add(exact::Wavemaker(paddle, water, given).height_per_stroke() /
                    exact::Wavemaker(paddle, water, exact::Wavelength{12}).height_per_stroke() -
                1);
    }
  }
  check.from(laws_source)
      .that("same", "The wavenumber and the height per stroke are the same, whatever the wave is known by.",
            "largest relative difference", {apart.value()},
            Roundoff{.operations = 60, .reason = "30 roundings there and back, twice in a quotient"});
}

}  // namespace seiche::verification::dispersion_test
