// The limit of a wall amplitude that still grows, on series whose limit is known.
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "seiche/samples.hpp"
#include "validation/instruments/plan/wall_history.hpp"
#include "verification/check.hpp"
#include "verification/evidence/reflection_problems.hpp"

namespace seiche::verification::wall_history_test {

using namespace validation;

constexpr double incident = 0.3;  // amplitude, depth 1

struct History {
  std::vector<double> time, amplitude;
};

History sampled(double end, const std::function<double(double)>& amplitude, double noise = 0) {
  History history;
  std::mt19937 random(1977);
  std::normal_distribution<double> error;
  constexpr int values = 300;
  for (int k = 1; k <= values; ++k) {
    history.time.push_back(end * k / values);
    history.amplitude.push_back(amplitude(history.time.back()) + noise * error(random));
  }
  return history;
}

/// Of an exact stem, in units of the incident amplitude.
History stem(double kappa, double settling_times) {
  const ExactReflection waves(incident, kappa);
  return sampled(settling_times / waves.settling_rate(), [waves](double t) {
    const double crest = waves.wall().at(0, t);
    return -boost::math::tools::brent_find_minima([&](double x) { return -waves.elevation(x, 0, t); }, crest - 1,
                                                  crest + 1, 40)
                .second /
           incident;
  });
}

evidence::Uncertainty stated(double limit, const std::string& why) {
  return {.expected = limit, .useful = 0.25 * limit, .reason = "uncertainty stated by the fits; " + why};
}

/// Next to resonance an exact stem halts on its way, once, where it is about to leave the state it had at t < 0: at
/// kappa = 0.98 near t = 1/r, a sixth below its limit.
void claim_coverage(Check& check) {
  Count outside;
  Largest widest;
  for (const double kappa : {0.3, 0.6, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995}) {
    for (const double settling_times : {0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0}) {
      const History history = stem(kappa, settling_times);
      const double rate = ExactReflection(incident, kappa).settling_rate();
      const evidence::Measurement found = wall_limit(history.time, history.amplitude, rate).amplitude;
      const double limit = (1 + kappa) * (1 + kappa);
      outside.add(std::abs(found.value - limit) - found.half_width(), [](double beyond) { return beyond > 0; });
      if (settling_times == 8) widest.add(found.half_width() / limit, kappa);
    }
  }
  check.holds(
      "The limit of every exact stem lies within the stated interval, however short it was watched: kappa from 0.3 to "
      "0.995, from t = 0.25/r to 8/r, also where it halts on its way (kappa = 0.98, t = 1/r).",
      {outside.value()},
      Bound{0,
            "the remaining deficit of a stem at t is at most a_inf exp(-r t) with the rate r = S^3 kappa (1 - kappa)/3 "
            "of the theory, and the interval reaches as far"});
  check.holds("The interval at t = 8/r is closed to exp(-8).",
              {.value = widest.value(), .where = fmt::format("kappa = {:g}", widest.where())},
              Bound{3 * std::exp(-8.0),
                    "exp(-8) by the law of the rate, and the fits may differ from each other by twice that: the "
                    "slowest exponential is all that is left"});
}

TEST_CASE("the limit of a growing wall amplitude is known within its stated uncertainty", "[evidence]") {
  Check check(
      "wall_history", "The limit of the wall amplitude",
      "A Mach stem next to resonance grows for thousands of $h/c_0$. The limit from an exponential through the last "
      "half of its history, and the uncertainty from the fits to other parts and by a power of time, and from the rate "
      "of the theory, on exact stems of the Kadomtsev-Petviashvili equation and on other series that are known.");
  const auto claim = [&](const std::string& text, const History& history, double limit, const std::string& why,
                         std::optional<double> rate = {}) {
    const WallLimit found = wall_limit(history.time, history.amplitude, rate);
    check.holds(text, found.amplitude, stated(limit, why));
    return found;
  };
  for (const double kappa : {0.6, 0.9, 0.95}) {
    for (const double settling_times : {4.0, 8.0}) {
      const WallLimit found =
          claim(fmt::format("An exact stem with kappa = {:g}, until t = {:g}/r.", kappa, settling_times),
                stem(kappa, settling_times), (1 + kappa) * (1 + kappa), "several exponentials",
                ExactReflection(incident, kappa).settling_rate());
      CHECK(found.steady() == (settling_times > 4));
    }
  }
  check.holds("The fitted rate of a nearly settled exact stem is accurate.", {[] {
                const History history = stem(0.6, 8);
                return wall_limit(history.time, history.amplitude).exponential.rate /
                       ExactReflection(0.3, 0.6).settling_rate();
              }()},
              Bound{2 * std::exp(-4.0), "the next exponential is exp(-4) of this one where the fit begins", 1});

  const auto growing = [](double t) { return 1 - 0.3 * std::exp(-t / 100); };
  claim("An exponential with noise of 1e-3, until four times its time.", sampled(400, growing, 1e-3), 1, "noise");
  claim("Two exponentials of which the fast one fades.",
        sampled(
            400, [](double t) { return 1 - 0.2 * std::exp(-t / 100) - 0.15 * std::exp(-t / 30); }, 1e-5),
        1, "another exponential");
  claim("A series that approaches its limit like 1/t.",
        sampled(
            600, [](double t) { return 1 - 0.3 / (1 + t / 50); }, 1e-5),
        1, "not an exponential");
  claim("The limit of an exponential with fading ripples is found.",
        sampled(400, [&](double t) { return growing(t) + 0.01 * std::cos(t / 5) / std::sqrt(1 + t / 5); }), 1,
        "ripples");
  claim("A steady series with noise of 1e-4.",
        sampled(
            600, [](double) { return 1.0; }, 1e-4),
        1, "noise");

  const History line = sampled(600, [](double t) { return t / 600; });
  const WallLimit none = wall_limit(line.time, line.amplitude);
  check.holds("A series that grows like a straight line has no limit that could be stated.",
              {none.amplitude.uncertainty > 0.5 ? 1.0 : 0.0},
              Qualitative{"uncertainty larger than half of the last value", "no curvature to extrapolate"});
  check.holds("A straight series is reported as straight.",
              {exponential_approach(line.time, line.amplitude).bends ? 1.0 : 0.0},
              Qualitative{"the best rate is not the slowest of those tried",
                          "the misfit falls towards the straight line", false});
  check.holds(
      "The growth of the series over its last fifth is found.", {growth_of_last_fifth(line.time, line.amplitude)},
      Roundoff{10, 1, "(600 - (2 + 0.8 598))/600; interpolation is exact for a line: ten roundings of values up to 1",
               0.2 * 598 / 600});
  CHECK_FALSE(none.steady());
  const History late = sampled(600, [](double t) { return t < 60 ? 0.5 : 1; });
  check.holds("The initial part of a steady series does not widen the uncertainty of its limit.",
              {wall_limit(late.time, late.amplitude).amplitude.uncertainty.value()},
              Bound{1e-9, "fits of a constant, to round-off of sums over 200 values"});

  CHECK_FALSE(wall_limit(line.time, line.amplitude, 0).amplitude.uncertainty.has_value());

  claim_coverage(check);

  auto& figure = check.figure("histories", "Wall amplitudes and their limits",
                              "Exact stems of the Kadomtsev-Petviashvili equation until four settling times: the "
                              "amplitude, the limit found with its uncertainty, and Miles's $(1+\\kappa)^2$.");
  auto& panel = figure.panel({.x = "time times settling rate", .y = "a_w/a_i"});
  std::vector<double> limits, uncertainties, miles;
  for (const double kappa : {0.6, 0.9, 0.95}) {
    const double rate = ExactReflection(0.3, kappa).settling_rate();
    const History history = stem(kappa, 4);
    std::vector<double> time;
    for (const double t : history.time) time.push_back(t * rate);
    panel.line(fmt::format("kappa = {:g}", kappa), time, history.amplitude, Role::computed);
    const WallLimit found = wall_limit(history.time, history.amplitude, rate);
    limits.push_back(found.amplitude.value);
    uncertainties.push_back(found.amplitude.half_width());
    miles.push_back((1 + kappa) * (1 + kappa));
  }
  panel.points("limit found", std::vector<double>(3, 4.2), limits, Role::computed, uncertainties);
  panel.points("Miles", std::vector<double>(3, 4.4), miles, Role::exact);

  CHECK_THROWS_AS(wall_limit(std::vector<double>(19), std::vector<double>(19)), std::invalid_argument);
  CHECK_THROWS_AS(wall_limit(std::vector<double>(20), std::vector<double>(20)), std::invalid_argument);
  CHECK_THROWS_AS(wall_limit(line.time, std::vector<double>(20)), std::invalid_argument);
  CHECK(stem_angle(std::vector<double>{0, 10}, std::vector<double>{1, 2}).value == std::atan(0.1));
  CHECK(stem_angle(std::vector<double>{0, 10}, std::vector<double>{2, 1}).value == std::atan(-0.1));
}

}  // namespace seiche::verification::wall_history_test
