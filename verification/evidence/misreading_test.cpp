// What a submitted curve may have been misread as: every change that is planted is found, and nothing where none is.
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/scoring/diagnosis.hpp"
#include "validation/scoring/misreading.hpp"
#include "verification/check.hpp"
#include "verification/evidence/known_curve.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::misreading_test {

using namespace validation;
using Kind = Misreading::Kind;

constexpr double spacing = 0.05;

/// A gauge that no change but the planted one maps onto itself: two waves of different period above a level.
double gauge(double t) {
  return 0.3 + 0.1 * std::sin(t) + 0.04 * std::cos(0.37 * t + 0.5);
}

/// Every 0.05 s.
template <class Function>
Points sampled(const Function& f, double last = 20) {
  return verification::sampled(0, last, static_cast<int>(std::lround(last / spacing)), f);
}

TEST_CASE("a misreading of a curve is found, with its factor or shift", "[evidence]") {
  Check check(
      "misreading", "What a difference looks like",
      "A gauge is shifted, lifted, turned, slowed, scaled, smeared or written in other units; each is recognised. "
      "Noise, a small difference and the reference itself are not explained.");
  const Points reference = sampled(gauge);
  const auto found = [&](const std::string& id, const Points& submitted, Kind kind, double amount, double accuracy,
                         const std::string& why) {
    const std::optional<Misreading> misread = misreading(submitted.curve(), reference.curve());
    check.holds(id + ": The kind of misreading is recognised.", {misread && misread->kind == kind ? 1.0 : 0.0},
                Qualitative{"the kind of the change", "it was planted"});
    check.holds(id + "-amount: The factor or shift is found.", {misread ? misread->amount : std::nan("")},
                Bound{accuracy, why, amount});
  };
  // Straight lines between points miss a curve of second derivative 0.1 by 0.1 spacing^2/8; over its slopes of 0.07 in
  // the mean that is a time.
  const double line = 0.1 * spacing * spacing / 8 / 0.07;
  const std::string lines = "straight lines between points 0.05 apart, over the mean slope";
  found("late", sampled([](double t) { return gauge(t - 0.3); }), Kind::shift, 0.3, line, lines);
  found("early", sampled([](double t) { return gauge(t + 1.1); }), Kind::shift, -1.1, line, lines);
  found("datum", sampled([](double t) { return gauge(t) + 0.02; }), Kind::level, 0.02, 1e-12, "round-off of a mean");
  found("low", sampled([](double t) { return gauge(t) - 1; }), Kind::level, -1, 1e-12, "round-off of a mean");
  found("inverted", sampled([](double t) { return -gauge(t); }), Kind::inverted, 0, 0, "it has no number");
  found("mirrored", sampled([](double t) { return gauge(20 - t); }), Kind::backwards, 0, 0, "it has no number");
  found("centimetres", sampled([](double t) { return 100 * gauge(t); }), Kind::unit, 100, 0, "a given factor");
  found("feet", sampled([](double t) { return 3.28084 * gauge(t); }), Kind::unit, 3.28084, 0, "a given factor");
  Points milliseconds = reference;
  for (double& t : milliseconds.x) t *= 1000;
  found("milliseconds", milliseconds, Kind::abscissa, 1000, 0, "a given factor");
  found("amplitude", sampled([](double t) { return 0.82 * gauge(t); }), Kind::scaled, 0.82, 1e-12,
        "round-off of two sums");
  found("slow", sampled([](double t) { return gauge(0.95 * t); }), Kind::slow, 1 / 0.95 - 1, line / 10,
        "a time at the middle of the series, 10 s from its beginning, " + lines);
  const auto sum = [](double t) { return 0.3 * t - 0.1 * std::cos(t) + 0.04 / 0.37 * std::sin(0.37 * t + 0.5); };
  const auto mean = [&](double t) {  // over 4 s, a fifth of the series
    const double from = std::max(t - 2, 0.0), to = std::min(t + 2, 20.0);
    return (sum(to) - sum(from)) / (to - from);
  };
  found("smeared", sampled(mean), Kind::smeared, 0.2, 3 * line / 20,
        "a width w takes w/12 of the curvature per unit of it, 4 s in 20 s, " + lines);
  Points dying = reference;
  double middle = 0;
  for (const double y : reference.y) middle += y / static_cast<double>(reference.y.size());
  for (std::size_t i = 0; i < dying.y.size(); ++i) {
    dying.y[i] = middle + (reference.y[i] - middle) * std::exp(-0.8 * dying.x[i] / dying.x.back());
  }
  found("dying", dying, Kind::dying, 0.8, 1e-9, "thirty halvings of 3/250, and round-off of the mean");
  Points noisy = reference;
  for (std::size_t i = 0; i < noisy.y.size(); ++i)
    noisy.y[i] += 0.03 * std::sin(1e4 * static_cast<double>(i * i % 977));
  const auto nothing = [&](const std::string& text, const Points& submitted) {
    check.holds(text, {misreading(submitted.curve(), reference.curve()) ? 1.0 : 0.0},
                Qualitative{"misreading()", "no single change was planted", false});
  };
  nothing("The diagnosis of the reference itself is empty.", reference);
  nothing("A difference below 1 % of the range is not diagnosed.", sampled([](double t) { return gauge(t) + 0.002; }));
  nothing("Noise is not attributed to a single change.", noisy);
}

TEST_CASE("a change is looked for in ten points or more that differ by more than 1 % of the range", "[evidence]") {
  const Points reference = sampled(gauge);
  const double range = largest(reference.y) - smallest(reference.y);
  for (const auto& [share, found] : {std::pair(0.0099, false), std::pair(0.0101, true)}) {
    CHECK(misreading(sampled([&, by = share * range](double t) { return gauge(t) + by; }).curve(), reference.curve())
              .has_value() == found);
  }
  for (const auto& [last, found] : {std::pair(8 * spacing, false), std::pair(9 * spacing, true)}) {
    const Points few = sampled([](double t) { return std::sin(10 * t); }, last);
    const Points turned = sampled([](double t) { return -std::sin(10 * t); }, last);
    CHECK(misreading(turned.curve(), few.curve()).has_value() == found);
  }
  // As many where the reference is known but the submitted curve ends.
  const Points turned = sampled([](double t) { return -gauge(t); }, 8 * spacing);
  CHECK_FALSE(misreading(turned.curve(), reference.curve()));
  CHECK(misfit(sampled([](double t) { return gauge(t) + 0.25; }).curve(), reference.curve()) ==
        Approx(0.25).epsilon(1e-12));
}

TEST_CASE("every misreading is said in words, with its number, its unit and its sense", "[evidence]") {
  const auto words = [](Kind kind, double amount, const std::string& unit = "m", const std::string& abscissa = "s") {
    return Misreading{kind, amount, 0.1}.words(unit, abscissa);
  };
  for (const auto& [factor, unit, name] :
       {std::tuple(1000.0, "m", "millimetres for metres"), std::tuple(100.0, "m", "centimetres for metres"),
        std::tuple(3.28084, "m", "feet for metres"), std::tuple(0.001, "m", "kilometres for metres"),
        std::tuple(100.0, "m/s", "centimetres per second for metres per second"),
        std::tuple(0.001, "Pa", "kilopascals for pascals"), std::tuple(0.01, "Pa", "hectopascals for pascals"),
        std::tuple(1000.0, "s", "milliseconds for seconds"), std::tuple(10.0, "m", "a unit that is 10 times smaller"),
        std::tuple(9.81, "m/s", "a unit that is 9.81 times smaller"),
        std::tuple(0.1, "Pa", "a unit that is 0.1 times smaller"),
        std::tuple(1000.0, "Pa", "a unit that is 1000 times smaller"),
        std::tuple(0.01, "s", "a unit that is 0.01 times smaller")}) {
    CHECK(unit_mistaken(factor, unit) == name);
    CHECK(words(Kind::unit, factor, unit) == fmt::format("fits the reference divided by {:g}: {}?", factor, name));
  }
  CHECK(unit_mistaken(104.9, "m") == "centimetres for metres");
  CHECK(unit_mistaken(95.1, "m") == "centimetres for metres");
  for (const double no_unit : {105.1, 94.9, 1.0, 60.0}) CHECK(unit_mistaken(no_unit, "m").empty());
  CHECK(words(Kind::abscissa, 1.0 / 60) ==
        "fits the reference with its abscissa divided by 0.0166667: minutes for seconds?");
  CHECK(words(Kind::abscissa, 1000, "Pa", "m") ==
        "fits the reference with its abscissa divided by 1000: millimetres for metres?");
  CHECK(words(Kind::inverted, 0) == "fits the reference with reversed sign");
  CHECK(words(Kind::backwards, 0) == "fits the reference read backwards: its axis points the other way");
  CHECK(words(Kind::level, 0.5, "Pa") == "lies 0.5 Pa higher than the reference everywhere: another datum?");
  CHECK(words(Kind::level, -0.5, "1") == "lies 0.5 lower than the reference everywhere: another datum?");
  CHECK(words(Kind::shift, 0.5) == "fits the reference 0.5 s earlier: another origin?");
  CHECK(words(Kind::shift, -0.5, "Pa", "m") == "fits the reference 0.5 m later: another origin?");
  CHECK(words(Kind::slow, 0.125) ==
        "runs 12.5 % slower than the reference: it fits with its abscissa divided by 1.125");
  CHECK(words(Kind::slow, -0.125) ==
        "runs 12.5 % faster than the reference: it fits with its abscissa divided by 0.875");
  CHECK(words(Kind::scaled, 1.25) == "fits the reference divided by 1.25: its amplitude is wrong");
  CHECK(words(Kind::smeared, -0.12) == "is the reference smeared over 12 % of its length: too coarse, or too viscous");
  CHECK(words(Kind::dying, 1) == "dies away along the way: by a factor of 0.368 from beginning to end");
  CHECK(words(Kind::dying, -1) == "grows along the way: by a factor of 2.72 from beginning to end");
}

TEST_CASE("the diagnosis names gauges that are exchanged or cut short, and says one thing once", "[evidence]") {
  Check check("diagnosis", "What is said of a submission",
              "Two gauges exchanged, a truncated series, the same lag at both gauges, a number in another unit.");
  const std::vector<double> times = multiples(0.1, 200);
  const auto reference = [](Place p) { return std::sin(p.abscissa - 2 * p.group) + 0.3 * p.group; };
  const std::vector<WantedTable> wanted{
      wanted_elevation("gauges", WantedTable::Kind::series, reference, times, {1, 2}),
      {.name = "numbers",
       .quantities = {{.column = {"runup", "m", "run-up"}, .reference = [](Place) { return 0.25; }}}}};
  const auto series = [&](double x, const auto& value, double last = 20) {
    SubmittedGroup group{.value = x};
    for (const double t : times) {
      if (t > last) break;
      group.abscissa.push_back(t);
      group.values["eta"].push_back(value(t));
    }
    return group;
  };
  const auto says = [&](const std::string& id, const Submitted& submitted, std::size_t count, const std::string& words,
                        bool shift_fitted = false) {
    const std::vector<Finding> findings = diagnosis(wanted, submitted, shift_fitted);
    check.holds(id + ": The number of findings is exact.", {static_cast<double>(findings.size())},
                Bound{0, "by hand", static_cast<double>(count)});
    bool said = count == 0;
    for (const Finding& one : findings) said = said || (one.where + " " + one.words).find(words) != std::string::npos;
    check.holds(id + "-words: \"" + words + "\" is said.", {said ? 1.0 : 0.0},
                Qualitative{"the sentence holds the words", "they name the seeded error"});
  };
  const auto at = [&](double x) { return [&, x](double t) { return reference({x, t}); }; };
  const auto late = [&](double x) { return [&, x](double t) { return reference({x, t - 0.5}); }; };
  says("right", {{"gauges", {series(1, at(1)), series(2, at(2))}}}, 0, "");
  says("exchanged", {{"gauges", {series(1, at(2)), series(2, at(1))}}}, 2, "is the reference of x = 2 m");
  says("cut", {{"gauges", {series(1, at(1), 12), series(2, at(2))}}}, 1, "ends at t = 12 s, the reference at 20");
  says("late", {{"gauges", {series(1, late(1)), series(2, late(2))}}}, 1, "every x fits the reference 0.5 s earlier");
  says("fitted", {{"gauges", {series(1, late(1)), series(2, late(2))}}}, 0, "", true);
  const auto large = [&](double x) { return [&, x](double t) { return 1.2 * reference({x, t}); }; };
  says("scaled", {{"gauges", {series(1, large(1)), series(2, large(2))}}}, 1, "amplitude");
  says("fitted-scaled", {{"gauges", {series(1, large(1)), series(2, large(2))}}}, 0, "", true);
  says("number", {{"numbers", {{.values = {{"runup", {25}}}}}}}, 1, "centimetres for metres");
}

TEST_CASE("findings are shown with their place, their sentence and what they leave of the misfit", "[evidence]") {
  evidence::Record record;
  show_diagnosis({}, record);
  CHECK(record.tables().empty());
  show_diagnosis({{"eta, x = 2 m", "late", 0.25}, {"depth", "high", 0.5}}, record);
  REQUIRE(record.tables().size() == 1);
  const auto& rows = record.tables().front().rows;
  REQUIRE(rows.size() == 2);
  CHECK((std::get<std::string>(rows[0][0]) == "eta, x = 2 m" && std::get<std::string>(rows[0][1]) == "late"));
  CHECK((std::get<double>(rows[0][2]) == 0.25 && std::get<std::string>(rows[1][0]) == "depth"));
}

}  // namespace seiche::verification::misreading_test
