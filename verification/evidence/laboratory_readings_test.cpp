// What is read off records of laboratories, how well it is known, and whether a record in the wrong place is told.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/registry.hpp"
#include "validation/laboratory/verdicts.hpp"
#include "verification/check.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::laboratory_readings_test {

using namespace validation;
using namespace validation::laboratory;

Measured sampled(double from, double to, int count, const std::function<double(double)>& y, double u, double u_x = 0) {
  Measured curve{.u_x = u_x};
  for (int k = 0; k <= count; ++k) {
    curve.x.push_back(from + (to - from) * k / count);
    curve.y.push_back(y(curve.x.back()));
    curve.u.push_back(u);
  }
  return curve;
}

void is(Check& check, const std::string& id, const std::string& text, double value, double expected, double limit,
        const std::string& reason) {
  check.from("validation/laboratory/reading.hpp")
      .that(id, text, "value", {.value = value, .uncertainty = 0, .resolution = "a curve that is known"},
            Bound{limit, reason, expected});
}

/// A part of an experiment.
Series part(const std::string& name, const std::string& table, const Column& abscissa, const Column& quantity) {
  return {.name = name, .table = table, .abscissa = abscissa, .quantity = quantity};
}

Values values_of(const std::string& name, const std::string& wave = {}) {
  Values values = find_case(name).values(Tier::quick);
  if (!wave.empty()) values.set("wave", wave);
  return values;
}

/// A record of a case scored with what its own reference becomes; claims that are not met, and verdicts of error.
struct Scored {
  long missed = 0, errors = 0;
  std::map<std::string, double> numbers = {};
};

/// @param stated  relative standard uncertainty of every column
Scored scored(const std::string& name, const std::function<void(SubmittedGroup&)>& change, double stated = 0) {
  const Case& one = find_case(name);
  const Values values = one.values(Tier::quick);
  const std::vector<WantedTable> wanted = one.submission.tables(values);
  SolverFacts facts;
  for (const WantedTable& table : wanted) {
    facts.uncertainty[table.quantities.front().column.name] = {.value = stated, .relative = true};
    if (table.abscissa) facts.uncertainty[table.abscissa->name] = {};
  }
  Submitted submitted = submission(wanted, [](const WantedQuantity& q, Place p) { return q.reference(p); });
  for (auto& [table, groups] : submitted) std::ranges::for_each(groups, change);
  const evidence::Record record = verification::scored(one, values, wanted, submitted, facts);
  Scored result{.numbers = record.measurements()};
  for (const evidence::JudgedClaim& claim : record.claims()) {
    if (claim.judgement.verdict != evidence::Verdict::pass) ++result.missed;
    if (claim.judgement.verdict == evidence::Verdict::error) ++result.errors;
  }
  return result;
}

TEST_CASE("readings of a known curve equal their exact values", "[evidence]") {
  Check check("laboratory_readings", "Readings of laboratory records",
              "What is read off a record, from curves of which it is known, and the uncertainty of it.");
  constexpr double period = 2.5;
  const auto wave = [](double t) {
    const double phase = 2 * std::numbers::pi * t / period;
    return 0.001 + 0.02 * std::cos(phase) + 0.007 * std::cos(2 * phase + 1);
  };
  const Measured bar = sampled(0, 10, 400, wave, 0.001, 0.02);
  const std::string solved = "rounding of nine unknowns over 400 points";
  is(check, "harmonic", "The second harmonic, 0.007, is found beside the first.",
     harmonic(0, 2, period, {1, 8.5}, 0).expected(bar), 0.007, 1e-12, solved);
  const auto late = [&](double t) { return wave(t - 0.137); };
  is(check, "lag", "The fitted shift of a record lagging by 0.137 s is 0.137 s.",
     lag_of(sampled(0, 10, 1000, late, 0).curve(), bar, {2, 8}, period / 2), 0.137, 1e-3,
     "a tenth of the lags that are tried, 0.0125 s, as a parabola goes through their squares");
  const auto ramp = [](double t) { return t < 3 ? 0 : 0.05 * (t - 3); };
  const Measured front = sampled(0, 6, 60, ramp, 0.002, 0.03);
  is(check, "arrival", "The time at which a ramp reaches 0.02 is 3.4 s.", arrival(0, 0.02, {}).expected(front), 3.4,
     1e-12, "a straight line");
  is(check, "arrival-uncertainty",
     "The uncertainty of an arrival combines clock, level over slope, and points 0.1 s apart.",
     arrival(0, 0.02, {}).uncertainty(front), std::hypot(0.03, 0.002 / 0.05, 0.1 / 2), 1e-12,
     "a straight line, points 0.1 s apart");
  const Measured peak = sampled(
      0, 4, 8, [](double t) { return -std::abs(t - 2); }, 0.01, 0.03);
  is(check, "place-uncertainty",
     "The uncertainty of the position of a sharp crest combines abscissa and points 0.5 apart.",
     when_highest(0, {}).uncertainty(peak), std::hypot(0.03, 0.5 / 2), 1e-12, "points 0.5 apart");
  const auto slow = [](double t) { return std::sin(t - 0.2005); };
  is(check, "lag-range", "The fitted time shift is limited to its range, 0.2.",
     lag_of(sampled(0, 10, 1000, slow, 0).curve(),
            sampled(
                1, 8, 100, [](double t) { return std::sin(t); }, 0.01),
            {2, 6}, 0.2),
     0.2, 1e-12, "the record lags by 0.2005");
  is(check, "misfit-uncertainty", "The uncertainty of a misfit combines two parts: points, and slope times clock.",
     misfit(0, {3.5, 5.5}).uncertainty(front), std::hypot(0.002, 0.05 * 0.03), 1e-12, "a straight line");
  is(check, "height-uncertainty",
     "The uncertainty of a height from trough to crest is sqrt(2) times the uncertainty of a point.",
     height(0, {}).uncertainty(bar), std::sqrt(2.0) * 0.001, 1e-12, "rounding");
  is(check, "impulse", "The integral of the ramp from 3 to 5 s is exact.", impulse(0, {2.95, 5.05}).expected(front),
     0.1, 1e-12, "trapezoids of a straight line");
}

TEST_CASE("tables of laboratory data are read with the meaning of their source", "[evidence]") {
  Check check("laboratory_tables", "Tables of laboratories",
              "Repeats, percentiles, levels before arrival, and positions, against the facts of each experiment.");
  const Series runs = part("runup", "matsuyama_tanaka_2001_monai_valley_runup", {"place", "1", ""}, {"R", "m", ""});
  const Measured runup = measured(runs, values_of("monai_valley")).front();
  is(check, "repeats", "The mean run-up of six runs at the first position is 0.0896 m.", runup.y.front(), 0.0896, 5e-5,
     "half a unit of the last digit");
  is(check, "spread", "The standard deviation of the six runs is 0.0064 m.", runup.u.front(), 0.0064, 5e-5,
     "half a unit of the last digit");
  Series island = part("runup", "briggs_1995_conical_island_runup", {"angle", "deg", ""}, {"R", "m", ""});
  island.kind = WantedTable::Kind::profile;
  island.columns = {"R_nthmp", "R_liu"};
  island.rows = {{"case", 1}};
  const Measured around = measured(island, values_of("island_gauges")).front();
  is(check, "distributions",
     "The standard uncertainty from two distributions of run-up is their difference over sqrt(12).", around.u.back(),
     std::hypot(0.06 * 0.032, (0.032 - 0.0225) / std::sqrt(12.0)), 1e-5, "half a unit of the last digit");
  Series pressure = part("pressure", "lobovsky_2014_dam_break_pressure", {"T", "1", ""}, {"p", "1", ""});
  pressure.band = {"p_low", "p_high"};
  const Measured median = measured(pressure, values_of("dam_break_wall_pressure")).front();
  is(check, "band", "The standard deviation of the repeats on the plateau is 0.24 +- 0.04 over 3.92.",
     linear_at({median.x, median.u}, 4.5), 0.061, 0.0105, "0.24 +- 0.04 over 3.92");
  is(check, "median-impulse", "The impulse of the median is 1.426.", impulse(0, {2.46, 4.0}).expected(median), 1.426,
     0.01, "every twentieth row is retained: one row of 1.9 at the ends");
  Series gauges = part("gauges", "briggs_1996_composite_beach_c", {"t", "s", ""}, {"eta", "m", ""});
  gauges.group = Column{"gauge", "1", ""};
  gauges.still = Window{265, 267};
  const Measured fourth = measured(gauges, values_of("composite_beach", "C")).front();
  is(check, "level", "The wave height at gauge 4, with its level removed, is H/h = 0.681.",
     highest(4, {}).expected(fourth) / 0.218, 0.681, 0.0007, "half of the resolution, 0.3 mm, over the depth");
  Series heights = part("heights", "kleefsman_2005_dam_break_box", {"t", "s", ""}, {"h", "m", ""});
  heights.group = Column{"x", "m", ""};
  std::vector<double> wet;
  for (const Measured& one : measured(heights, values_of("dam_break_box"))) {
    wet.push_back(arrival(one.group, 0.02, {0.05, 2}).expected(one));
  }
  const bool order = wet.at(2) < wet.at(1) && wet.at(1) < wet.at(0);
  check.from("the geometry of the tank")
      .that("places", "The arrival times at the probes increase from the door to the wall.", "order of arrivals",
            {order ? 1.0 : 0.0},
            Qualitative{"arrivals at x = 1.488, 0.992, 0.496 m increase", "water runs from the door to the wall"});
}

TEST_CASE("the metric of two readings follows from their covariance", "[evidence]") {
  Check check("laboratory_metric", "The multivariate metric of an experiment",
              "Two values of 1 of one gauge, known to 0.05, of a wave whose amplitude is known to 0.1: half of the "
              "variance of the gauge is shared, the amplitude is.");
  Series gauge = part("gauge", "", {"t", "s", ""}, {"eta", "m", ""});
  gauge.input = 0.1;
  const auto record =
      std::make_shared<const Measured>(Measured{.group = 0, .x = {0, 1}, .y = {1, 1}, .u = {0.05, 0.05}});
  const std::vector<Question> two{{gauge, at(0, 0, Kind::height), record}, {gauge, at(0, 1, Kind::height), record}};
  const auto of = [&](double first, double second, const Sources& sources = {}) {
    return metric(two, {{"gauge", {{.value = 0, .abscissa = {0, 1}, .values = {{"eta", {first, second}}}}}}}, sources);
  };
  const std::string exact = "rounding of two equations";
  is(check, "data", "The uncertainty of a common factor from the data is 0.05 sqrt(3/4).", of(1, 1).data,
     0.05 * std::sqrt(0.75), 1e-12, exact);
  is(check, "input", "The uncertainty of a common factor from the incident amplitude is 0.1.", of(1, 1).input, 0.1,
     1e-12, exact);
  is(check, "numerical",
     "The uncertainty of a common factor from independent numerical errors of 0.06 is 0.06/sqrt(2).",
     of(1, 1, {.numerical = {0.06, 0.06}}).numerical, 0.06 / std::sqrt(2.0), 1e-12, exact);
  is(check, "parameter", "A parameter that changes both readings by 0.03 counts as one source.",
     of(1, 1, {.shared = {{0.03, 0.03}}}).input, std::hypot(0.1, 0.03), 1e-12, exact);
  is(check, "common", "The common factor of two readings 20 % too high is 1.2.", of(1.2, 1.2).difference, 0.2, 1e-12,
     exact);
  Largest off;  // nothing is left beside the factor, and what rounding leaves may be negative
  for (int k = 1; k <= 100; ++k) off.add(std::abs(of(1 + 0.01 * k, 1 + 0.01 * k).difference - 0.01 * k));
  is(check, "factors", "The estimated common factor is exact from 1.01 to 2.", off.value(), 0, 1e-7,
     "the root of the rounding that is left beside the factor");
  const Metric apart = of(1.2, 0.8);  // E^T V^-1 E = 2 0.2^2/(0.05^2/2) = 64 with one degree of freedom
  is(check, "apart", "The distance of readings 20 % too high and 20 % too low is 8 standard deviations.",
     apart.difference / apart.noticed(), 8 / 2.2365, 2e-4, "five digits of the quantile of sqrt(0.95)");
  is(check, "shared",
     "A common error of 20 % within the amplitude's uncertainty passes, the same of opposite signs fails.",
     (of(1.2, 1.2).passes() ? 1 : 0) + (apart.passes() ? 2 : 0), 1, 0, "definition of a shared source");
  Series run_up = part("runup", "", {"t", "s", ""}, {"R", "m", ""});
  run_up.telling = 0.2;
  Series many = run_up;
  many.name = "gauges";
  many.group = Column{"gauge", "1", ""};
  std::vector<Question> all{{run_up, at(0, 0, Kind::run_up), record}};
  Submitted computed{{"runup", {{.value = 0, .abscissa = {0, 1}, .values = {{"R", {1.2, 1.2}}}}}}};
  for (double k = 1; k <= 30; ++k) {
    all.emplace_back(many, at(k, 0, Kind::height), record);
    computed["gauges"].push_back({.value = k, .abscissa = {0, 1}, .values = {{"R", {1, 1}}}});
  }
  const Metric one_part = metric(all, computed, {});
  is(check, "part", "A run-up 4 standard uncertainties too high is detected among thirty heights that agree.",
     one_part.difference / one_part.noticed(), 4 / std::sqrt(-2 * std::log(1 - std::sqrt(0.95))), 1e-9,
     "rounding; chi-square of two degrees of freedom is exponential");
  const auto decides = [&](double height, double when, double factor = 1) {
    Submitted of_all = computed;
    for (auto& [part, groups] : of_all) {
      for (SubmittedGroup& group : groups) group.values.at("R") = {factor, factor};
    }
    std::vector<Question> asked = all;
    const Measured dense = sampled(
        0, 1, 20, [](double) { return 1; }, 0.05);
    asked.emplace_back(run_up, arrival(0, 0.1, {}), std::make_shared<const Measured>(dense));
    Sources sources{.numerical = std::vector<double>(31, height)};
    sources.numerical.push_back(when);
    return numerical_uncertainty(asked, of_all, sources, 0.2) ? 1.0 : 0.0;
  };
  is(check, "vague",
     "Heights known to 7 % and a time known to 0.09 s have a numerical uncertainty; heights known to 30 % each, or a "
     "time known to 0.11 s where 0.2 s is the most, have none.",
     decides(0.07, 0.09) + 2 * decides(0.3, 0.09) + 4 * decides(0.07, 0.11), 1, 0, "2.712 times 0.07 is below 0.2");
  is(check, "clear",
     "Heights known to 30 % each have a numerical uncertainty where they are wrong by a factor of 2, and none by 1.5.",
     decides(0.3, 0.09, 2) + 2 * decides(0.3, 0.09, 1.5), 1, 0,
     "2.712 times 0.3 is 0.81: such an error, common, explains 1.5");
}

TEST_CASE("correct records pass and wrong records fail, in every laboratory case", "[evidence]") {
  Check check("laboratory_right_and_wrong", "Right and wrong records of every laboratory case",
              "Each case's own reference is submitted, as it is, with every second sample, times 1.2 known to 10 %, "
              "and times 0.7 and 1.3 in turn known to 30 %.");
  const auto times = [](double factor, const std::string& one = "") {
    return [=](SubmittedGroup& group) {
      for (auto& [column, values] : group.values) {
        for (double& value : values) value *= one.empty() || column == one ? factor : 1;
      }
    };
  };
  const auto thinned = [](SubmittedGroup& group) {
    const auto every_second = [](std::vector<double>& values) {
      for (std::size_t k = 0; 2 * k < values.size(); ++k) values[k] = values[2 * k];
      values.resize((values.size() + 1) / 2);
    };
    if (group.abscissa.size() < 60) return;  // a table of points, no record
    every_second(group.abscissa);
    for (auto& [column, values] : group.values) every_second(values);
  };
  const auto uneven = [](SubmittedGroup& group) {
    for (auto& [column, values] : group.values) {
      for (std::size_t k = 0; k < values.size(); ++k) values[k] *= k % 2 == 0 ? 0.7 : 1.3;
    }
  };
  std::vector<std::string> own, halved, vague, vaguer;  // cases that are judged wrongly
  long cases = 0;
  for (const Case& one : all_cases()) {
    if (one.phenomenon != "laboratory" || !one.submission) continue;
    ++cases;
    if (scored(one.name, times(1)).missed > 0) own.push_back(one.name);
    if (scored(one.name, thinned).errors > 0) halved.push_back(one.name);
    if (scored(one.name, times(1.2), 0.1).missed == 0) vague.push_back(one.name);
    const Scored uncertain = scored(one.name, uneven, 0.3);
    if (uncertain.missed == 0 || uncertain.errors > 0) vaguer.push_back(one.name);
  }
  const auto none = [&](const std::string& id, const std::string& text, const std::vector<std::string>& cases_of,
                        const std::string& reason) {
    check.from("definition of scoring")
        .that(id, text, "cases with another verdict",
              {.value = static_cast<double>(cases_of.size()),
               .resolution = std::to_string(cases) + " cases",
               .where = fmt::format("{}", fmt::join(cases_of, ", "))},
              Bound{0, reason});
  };
  none("own", "The measured records meet every claim of their own experiment.", own, "every error is zero");
  none("thinned", "Every second sample of the measured records can be scored.", halved,
       "half of the samples are no error");
  none("vague", "The measured records times 1.2 with a stated uncertainty of 10 % of the range do not pass.", vague,
       "such an uncertainty hides a factor of 1.2: inconclusive at best");
  none("vaguer",
       "The measured records times 0.7 and 1.3 in turn with a stated uncertainty of 30 % of the range neither pass nor "
       "give an error.",
       vaguer, "uncertainties of many readings do not cancel unless they are known to be independent");
  std::vector<std::string> alone;
  for (const auto& [name, column] :
       {std::pair{"composite_beach", "R"}, {"island_gauges", "R"}, {"gated_dam_break", "front"}}) {
    for (const double factor : {0.8, 1.2}) {
      if (scored(name, times(factor, column)).missed == 0) alone.push_back(name);
    }
  }
  none("alone",
       "Run-ups of a composite beach and an island, and the front of a gated dam break on its fitted clock, times 0.8 "
       "and 1.2 beside right records do not pass.",
       alone, "the front is known to 1 %, the run-ups to 6 %");
}

TEST_CASE("a shift of time or zero common to all gauges is no error of a record, a shift of one gauge is",
          "[evidence]") {
  Check check("laboratory_scores", "Clocks and zeros of gauges",
              "The measured records are submitted with one thing changed.");
  const auto shift = [](double by) {
    return [by](SubmittedGroup& one) {
      for (double& x : one.abscissa) x += by;
    };
  };
  const auto raised = [](double by) {
    return [by](SubmittedGroup& one) {
      if (!one.values.contains("eta")) return;
      for (double& y : one.values.at("eta")) y += by;
    };
  };
  const Scored late = scored("dingemans_bar", shift(0.3));
  is(check, "clock", "The fitted common shift is 0.3 s if the origin of time is unknown.",
     late.numbers.at("gauges_time_shift"), 0.3, 0.005, "a parabola through lags 0.007 s apart");
  check.from("definition of scoring")
      .that("clock-passes", "The number of claims missed through a common shift of the clock is zero.",
            "claims that are missed", {static_cast<double>(late.missed)}, Bound{0, "the shift is common"});
  const Scored near = scored("henderson_collision", raised(0.0002));
  check.from("ASME V&V 20-2009")
      .that("within-data", "The number of claims missed through errors below the uncertainty of the data is zero.",
            "claims that are missed", {static_cast<double>(near.missed)},
            Bound{0, "0.2 mm, of points that are known to 0.25 mm"});
  is(check, "zero", "The zero level of a gauge has no effect if its level before the wave is removed.",
     static_cast<double>(scored("island_gauges", raised(0.003)).missed), 0, 0,
     "it is taken off the submitted record as off the measured one");
  const Scored late_alone = scored("dingemans_bar", [&](SubmittedGroup& one) {
    if (one.value == 37.04) shift(0.3)(one);
  });
  is(check, "own-clock", "A delay of one gauge alone is detected.", static_cast<double>(late_alone.missed), 1, 0,
     "one claim for all readings");
}

}  // namespace seiche::verification::laboratory_readings_test
