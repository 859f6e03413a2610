// Where an error is, and of what kind.
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "validation/scoring/first_look.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::first_look_test {

using namespace validation;

std::vector<double> places() {
  return multiples(0.0628318530717958, 200);
}

std::vector<double> values(const std::function<double(double)>& of) {
  std::vector<double> y;
  for (const double x : places()) y.push_back(of(x));
  return y;
}

ErrorKind kind_of(const std::function<double(double)>& submitted) {
  const std::vector<double> x = places();
  const std::vector<double> y = values(submitted);
  const std::vector<double> r = values([](double at) { return std::sin(at); });
  return error_kind({x, y}, {x, r});
}

std::vector<WantedTable> wanted(evidence::Role role, const std::string& unit = "m") {
  WantedTable wave = wanted_elevation(
      "wave", WantedTable::Kind::profile, [](Place p) { return std::sin(p.abscissa); }, places());
  WantedQuantity& eta = wave.quantities.front();
  wave.abscissa->unit = eta.column.unit = unit;
  eta.requirements = {{Measure::relative_l2, Bound{0.05, "of this test"}, "The wave is right.", "this test"}};
  wave.reference_role = role;
  return {wave};
}

Submitted submitted_wave(const std::function<double(double)>& eta) {
  return {{"wave", {{.abscissa = places(), .values = {{"eta", values(eta)}}}}}};
}

std::string answer(const std::function<double(double)>& submitted, const std::string& question,
                   evidence::Role role = evidence::Role::exact, const std::optional<Ladder>& ladder = {},
                   const std::string& unit = "m") {
  evidence::Record record;
  const std::vector<WantedTable> tables = wanted(role, unit);
  const Submitted all = submitted_wave(submitted);
  score(tables, all, {}, record);
  for (const auto& [asked, said] : first_look(tables, all, record, {}, ladder)) {
    if (asked == question) return said;
  }
  return {};
}

/// Of the wave with an error of this share on three sizes, falling with the size, and one that stays.
Ladder ladder_of_errors(double falling, double staying) {
  std::vector<Rung> rungs;
  for (const double h : {4.0, 2.0, 1.0}) {
    const auto wave = [&](double x) { return std::sin(x) * (1 + falling * h + staying); };
    rungs.push_back({.size = h, .submitted = submitted_wave(wave)});
  }
  return ladder_of(wanted(evidence::Role::exact), rungs);
}

TEST_CASE("the summary of a score states position, kind and likely cause of an error and the next step", "[evidence]") {
  Check check("first_look", "Summary of a score",
              "A sine with errors of known kinds: two wavelengths, joined by straight lines between 201 points.");
  const auto share = [&](const std::string& text, double value) {
    check.holds(text, {value}, Bound{0.01, "differences of neighbours for the slope, and small shifts", 1});
  };
  const auto says = [&](const auto&... words) { verification::says(check, words...); };
  share("The error of a lagging wave is of type phase.", kind_of([](double x) { return std::sin(x - 0.05); }).phase);
  share("The error of a too high wave is of type amplitude.",
        kind_of([](double x) { return 1.1 * std::sin(x); }).amplitude);
  share("The error of a raised surface is of type level.", kind_of([](double x) { return std::sin(x) + 0.1; }).level);
  const auto bump = [](double x) { return std::sin(x) + 0.2 * std::exp(-std::pow((x - 4.5) / 0.2, 2)); };
  share("The error of a local bump is located at the bump.", kind_of(bump).near);
  check.holds("The position of the largest error is reported.", {kind_of(bump).where},
              Bound{0.0315, "half a distance of points", 4.5});
  says("The error of a bump is of type local shape.", kind_of(bump).words(), "local shape");
  says("The type of error is stated in the summary.", kind_of([](double x) { return std::sin(x - 0.05); }).words(),
       "phase: 100 %");

  const auto high = [](double x) { return 1.2 * std::sin(x); };
  says("The next step for a correct result is none.", answer([](double x) { return std::sin(x); }, "likely cause"),
       "all errors are within their limits");
  says("The number of claims met is in the summary.", answer(high, "result"), "1 of 2 claims are met, 1 not met");
  says("The claim missed by the largest factor is named in the summary.", answer(high, "closest limit"),
       "The wave is right. fail (eta-relative_l2: error 0.2");
  const auto place = [&](const std::string& unit) {
    return answer(bump, "largest error", evidence::Role::exact, {}, unit);
  };
  says("The position of the largest error is printed with its unit.", place("m"),
       "eta: largest at x = 4.524 m, +0.197 m; ");
  says("The position of a dimensionless error is printed without a unit.", place("1"),
       "eta: largest at x = 4.524, +0.197; ");
  says("The likely cause against an exact reference is the solver or its set-up.", answer(high, "likely cause"),
       "three cell sizes (--sizes) show which");
  says("The summary asks for several cell sizes next.", answer(high, "next step"), "--sizes");
  says("The likely cause against data without uncertainty is left open.",
       answer(high, "likely cause", evidence::Role::data), "your solver's or the data's");
  says("The likely cause of an error that falls with the cell size is the resolution.",
       answer(high, "likely cause", evidence::Role::exact, ladder_of_errors(0.2, 0)), "your resolution's");
  says("The next step for the resolution's error names a finer cell size.",
       answer(high, "next step", evidence::Role::exact, ladder_of_errors(0.2, 0)), "run dx = 0.05: 1 % of eta");
  says("An error that remains on fine cells is attributed to the model's equations.",
       answer(high, "likely cause", evidence::Role::exact, ladder_of_errors(0.001, 0.2)), "your model's or set-up's");
  says("The summary states that refinement does not remove the model's error.",
       answer(high, "next step", evidence::Role::exact, ladder_of_errors(0.001, 0.2)),
       "refinement will not remove this error");
  // Every `step`-th of the points; the last answer of the summary is the next step.
  const auto next_of = [](std::size_t step, evidence::Role role, const std::vector<Finding>& findings) {
    const std::vector<WantedTable> tables = wanted(role);
    SubmittedGroup group{.value = 0};
    for (std::size_t k = 0; k < places().size(); k += step) {
      group.abscissa.push_back(places()[k]);
      group.values["eta"].push_back(1.5 * std::sin(places()[k]));
    }
    const Submitted all{{"wave", {group}}};
    evidence::Record record;
    score(tables, all, {}, record);
    return first_look(tables, all, record, findings, {}).back().second;
  };
  const std::string finer =
      "submit wave at the points of the template: a record has 101 points where 201 were measured";
  says("The next step for records with half the measured points is more points.", next_of(2, evidence::Role::data, {}),
       finer);
  says("The next step for records with all measured points is several cell sizes.",
       next_of(1, evidence::Role::data, {}), "--sizes");
  says("The next step for few points of an exact solution is several cell sizes.",
       next_of(2, evidence::Role::exact, {}), "--sizes");
  says("The next step for few points in another unit is the unit.",
       next_of(2, evidence::Role::data, {{"eta", "is in cm", 0}}), "check the file: eta is in cm");
  evidence::Record measured;
  measured.check({"agreement", "The wave agrees with the measurement.", "height", "m", "this test"},
                 {.value = 0.5, .uncertainty = 0.01},
                 evidence::Uncertainty{.data = 0.01, .input = 0, .useful = 0.2, .reason = "of this test"});
  std::string cause;
  for (const auto& [asked, said] : first_look({}, {}, measured, {}, {})) {
    if (asked == "likely cause") cause = said;
  }
  says("A difference beyond the uncertainties is attributed to the solver.", cause,
       "an error of 0.5, which the uncertainties");
}

TEST_CASE("the claim that uses most of its limit decides, and the report's table reads as the screen", "[evidence]") {
  std::vector<WantedTable> tables = wanted(evidence::Role::exact);
  tables.front().quantities.front().requirements.push_back(
      {Measure::largest_error, Bound{1, "of this test"}, "The wave is close to the reference.", "this test"});
  // A narrow bump: its largest error, 0.2, is a fifth of its limit; its relative L2 error, 0.04, most of it.
  const Submitted all =
      submitted_wave([](double x) { return std::sin(x) + 0.2 * std::exp(-std::pow((x - 4.5) / 0.2, 2)); });
  evidence::Record record;
  score(tables, all, {}, record);
  const FirstLook look = first_look(tables, all, record, {}, {});
  show_first_look(look, record);
  const evidence::Table& table = record.tables().back();
  REQUIRE(table.rows.size() == look.size());
  for (std::size_t k = 0; k < look.size(); ++k) {
    CHECK(std::get<std::string>(table.rows[k].at(0)) == look[k].first);
    CHECK(std::get<std::string>(table.rows[k].at(1)) == look[k].second);
    if (look[k].first == "closest limit") CHECK(look[k].second.find("The wave is right.") != std::string::npos);
  }
}

TEST_CASE("each line of the summary follows from the verdicts, the findings and the grids", "[evidence]") {
  using evidence::Verdict;
  using Look = std::map<std::string, std::string>;
  const evidence::Criterion bound = Bound{1, "of this test"};
  const evidence::Criterion measured =
      evidence::Uncertainty{.data = 0.25, .input = 0, .useful = 1, .reason = "of this test"};
  const auto claim = [](const std::string& id, const evidence::Criterion& criterion, Verdict verdict, double value,
                        double limit, std::optional<double> uncertainty = {}) {
    return evidence::JudgedClaim{{id, "It holds.", "depth", "m", "this test"},
                                 criterion,
                                 {verdict, value, uncertainty, 1, limit, "resolution of " + id, "note of " + id}};
  };
  const auto look = [](const std::vector<evidence::JudgedClaim>& claims, const std::vector<Finding>& findings = {},
                       const std::optional<Ladder>& ladder = {}) {
    evidence::Record record;
    for (const evidence::JudgedClaim& one : claims) record.keep(one);
    const FirstLook lines = first_look({}, {}, record, findings, ladder);
    return Look(lines.begin(), lines.end());
  };
  const auto pass = claim("good", bound, Verdict::pass, 1.25, 1);
  const auto close = claim("close", bound, Verdict::pass, 1.75, 1);
  const auto fail = claim("bad", bound, Verdict::fail, -2, 1);
  const auto open = claim("open", bound, Verdict::inconclusive, 1, 1);
  const auto error = claim("lost", bound, Verdict::error, std::nan(""), 1);

  const auto all = look({pass, fail, open, error});
  CHECK(all.at("result") == "1 of 4 claims are met, 1 not met, 1 undecided, 1 in error");
  CHECK(all.at("closest limit") == "It holds. error (lost: not found in the result)");
  CHECK(all.at("likely cause") == "your result: the measured quantity is missing (resolution of lost)");
  CHECK(look({pass, open, fail}).at("closest limit") == "It holds. fail (bad: error -3 m, limit 1 m)");
  CHECK(look({close, open}).at("closest limit") == "It holds. inconclusive (open: error 0 m, limit 1 m)");
  CHECK(look({pass, close}).at("closest limit") == "It holds. pass (close: error 0.75 m, limit 1 m)");
  // Where nothing may differ, the difference itself.
  for (const auto& [value, decides] : {std::pair(5.0, "zero"), std::pair(3.5, "bad")}) {
    CHECK_THAT(look({fail, claim("zero", bound, Verdict::fail, value, 0)}).at("closest limit"),
               Catch::Contains(decides));
  }
  CHECK(look({pass}).at("result") == "1 of 1 claims are met");

  // What was not submitted.
  const auto given = claim("wave-given", bound, Verdict::fail, 0.5, 0);
  CHECK(look({pass, given}).at("result") == "1 of 2 claims are met, 1 not met, resolution of wave-given");
  CHECK(look({fail, given}).at("next step") == "submit the rest: wave-given (resolution of wave-given)");
  const auto covered = [&](Verdict verdict, double value) {
    return look({pass, claim("wave-coverage", bound, verdict, value, 1)});
  };
  CHECK_THAT(covered(Verdict::fail, 0.5).at("result"), Catch::EndsWith("1 not met, resolution of wave-coverage"));
  CHECK_THAT(covered(Verdict::fail, 0).at("result"), Catch::EndsWith("1 not met"));
  CHECK(covered(Verdict::pass, 1).at("result") == "2 of 2 claims are met");
  CHECK_THAT(covered(Verdict::fail, 0).at("next step"), Catch::StartsWith("submit the rest: wave-coverage"));

  const auto cause = [&](const evidence::JudgedClaim& one, const std::vector<Finding>& findings = {}) {
    return look({one}, findings).at("likely cause");
  };
  const std::vector<Finding> late{{"eta", "is late", 0.1}, {"u", "is early", 0.2}};
  const std::string sizes = "run three or more cell sizes";
  CHECK(cause(pass) == "none, all errors are within their limits");
  CHECK(cause(pass, late) == "none within the limits of the scored claims");
  CHECK(cause(open) == "undecided: note of open");
  CHECK_THAT(cause(fail), Catch::StartsWith("your solver's or its set-up's, as the reference is exact"));
  CHECK(cause(claim("a", measured, Verdict::pass, 1, 0.5, 0.1)) ==
        "none: within the uncertainties of the data and of your result, 0.5 together");
  CHECK(cause(claim("a", measured, Verdict::inconclusive, 1, 0.5, 0.1)) == "undecided: note of a");
  CHECK(cause(claim("a", measured, Verdict::fail, 0, 0.5)) == "your solver's: note of a");
  CHECK(cause(claim("a", measured, Verdict::fail, 0, 0.5, 0.1)) ==
        "your solver's: an error of -1, which the uncertainties of the data and of your result (0.5 together) do not "
        "explain");

  CHECK(look({pass}).at("next step") == sizes + " (--sizes) to obtain the order of accuracy and the cost of 1 % error");
  CHECK(look({pass}, {}, Ladder{}).at("next step") == "none, all claims are met");
  CHECK(look({fail}).at("next step") == sizes + " and pass them with --sizes");
  CHECK(look({pass}, late).at("next step") == "check the file: eta is late");
  CHECK(look({pass}, late).at("start with") == "eta: your result is late");
  CHECK(look({fail}, {}, Ladder{}).at("next step") == "inspect the figure of the quantity above");
  CHECK_THAT(look({claim("a", measured, Verdict::inconclusive, 1, 0.5)}).at("next step"),
             Catch::StartsWith("state an uncertainty small enough") && Catch::EndsWith("resolution of a"));
  CHECK_THAT(look({claim("a", measured, Verdict::inconclusive, 1, 0.5, 0.1)}).at("next step"),
             Catch::StartsWith(sizes));
}

TEST_CASE("the summary shows the group with the largest error over its reference", "[evidence]") {
  std::vector<WantedTable> tables = wanted(evidence::Role::data);
  tables.front().group = Column{"t", "s", "time"};
  tables.front().groups = std::vector<double>{2, 3, 4};
  tables.front().quantities.front().reference = [](Place p) { return p.group * std::sin(p.abscissa); };
  const auto group = [](double t, double factor, std::size_t left_out = 0) {
    SubmittedGroup one{.value = t};
    for (std::size_t k = 0; k < places().size(); ++k) {
      if (k % 2 == 1 && k <= 2 * left_out) continue;
      one.abscissa.push_back(places()[k]);
      one.values["eta"].push_back(factor * t * std::sin(places()[k]));
    }
    return one;
  };
  const auto look = [&](const std::vector<SubmittedGroup>& groups) {
    evidence::Record record;
    const Submitted all{{"wave", groups}};
    score(tables, all, {}, record);
    const FirstLook lines = first_look(tables, all, record, {}, {});
    return std::map<std::string, std::string>(lines.begin(), lines.end());
  };
  // Of the largest error in m, 0.6 at t = 4, less is left over the reference than of 0.5 at t = 2.
  const auto lines = look({group(2, 1.25), group(3, 1.1), group(4, 1.15)});
  CHECK(lines.at("start with") == "figure wave-eta");
  CHECK_THAT(lines.at("largest error"), Catch::StartsWith("eta, t = 2 s: largest at x = ") && Catch::Contains(" m, ") &&
                                            Catch::Contains("0.5 m; "));
  CHECK(lines.at("type of error") == "amplitude: 100 % of the squared error");
  // Three quarters of the 201 points are 150.75.
  for (const auto& [left_out, finer] : {std::pair(50, false), std::pair(51, true)}) {
    const auto fewer = group(3, 1.1, static_cast<std::size_t>(left_out));
    const std::string next = look({group(2, 1.25), fewer, group(4, 1)}).at("next step");
    CHECK((next.find("a record has 150 points where 201 were measured") != std::string::npos) == finer);
  }
}

}  // namespace seiche::verification::first_look_test
