// Scoring by declaration: profiles at several times, and single numbers with uncertainties.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "validation/scoring/submitted.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"
#include "verification/message_of.hpp"

namespace seiche::verification::score_test {

using namespace validation;

/// A wave sin(x - t) at two times, and one measured height 2.0 +- 0.1 m.
std::vector<WantedTable> wanted_tables() {
  WantedTable wave =
      wanted_elevation("profiles", WantedTable::Kind::profile, [](Place p) { return std::sin(p.abscissa - p.group); },
                       multiples(0.2, 50), {1, 2});
  wave.quantities.front().requirements = {
      {Measure::relative_l2, Bound{0.05, "of this test"}, "The wave equals the exact wave.", "this test"}};
  const evidence::Uncertainty gauge{
      .expected = 2.0, .data = 0.1, .useful = 0.5, .reason = "gauge's stated uncertainty"};
  return {
      wave,
      {.name = "heights",
       .quantities = {{{"runup", "m", "run-up"},
                       [](Place) { return 2.0; },
                       {{Measure::value, gauge, "The maximum run-up agrees with the measurements.", "this test"}}}}}};
}

std::string profiles(double error_at_two, double error_at_one = 0) {
  std::string text = "t [s],x [m],eta [m]\n";
  for (const double t : {0.0, 1.0, 2.0}) {  // the first is not asked for
    for (int k = 0; k <= 50; ++k) {
      const double factor = t == 2 ? 1 + error_at_two : 1 + error_at_one;
      text += fmt::format("{},{:.17g},{:.17g}\n", t, 0.2 * k, factor * std::sin(0.2 * k - t));
    }
  }
  return text;
}

/// The record of another solver's result.
evidence::Record scored(const std::vector<WantedTable>& wanted, const Submitted& submitted,
                        const std::map<std::string, StatedUncertainty>& uncertainty = {}) {
  evidence::Record record;
  record.name = "scored";
  record.solver = "other";
  score(wanted, submitted, uncertainty, record);
  return record;
}

/// The same of files for `wanted_tables`.
evidence::Record scored(const std::vector<io::Table>& files, const std::string& uncertainty = "",
                        const std::vector<WantedTable>& wanted = wanted_tables()) {
  std::map<std::string, StatedUncertainty> stated;
  if (!uncertainty.empty()) stated["runup"] = uncertainty_from("runup", uncertainty);
  Understanding understood;
  return scored(wanted, submitted_from(files, wanted, understood), stated);
}

std::string refusal(const std::string& text) {
  return message_of([&] { scored({file_of(text, "mine.csv")}); });
}

TEST_CASE("a declared submission is measured and evaluated in every group", "[evidence]") {
  Check check("declared_submission", "Scoring by declaration",
              "A case that only declares its requirements gets templates, measures, claims and errors. Here: profiles "
              "at two times and a measured number.");
  const auto is = [&](const auto&... words) { says(check, words..., "stated in the interface"); };
  const evidence::Record good = scored({file_of(profiles(0), "p.csv"), file_of("runup\n2.05\n", "r.csv")});
  is("Exact profiles with a stated uncertainty pass the score.", verdict_of(good, "eta-relative_l2"), "pass");
  const evidence::Record bad = scored({file_of(profiles(0.1), "p.csv")});
  is("Wrong profiles at one of two times fail the claim.", verdict_of(bad, "eta-relative_l2"), "fail");
  const evidence::Record both = scored({file_of(profiles(0.1, 0.06), "p.csv")});
  const auto wave = std::ranges::find(both.claims(), "eta-relative_l2", [](const auto& c) { return c.claim.id; });
  is("The failing time with the larger error is shown.", wave->judgement.resolution, "t = 2");
  is("A missing table fails its coverage claim.", verdict_of(bad, "heights-coverage"), "fail");
  is("The quantities of a missing table are not scored.", verdict_of(bad, "runup-value"), "no such claim");
  const auto drawn = [&](evidence::Role role) {
    std::vector<WantedTable> wanted = wanted_tables();
    for (WantedTable& one : wanted) one.reference_role = role;
    const evidence::Record record = scored({file_of(profiles(0), "p.csv")}, "", wanted);
    return static_cast<double>(record.figures().front().panels().front().series().front().x.size());
  };
  check.holds("An exact reference is drawn between the points.", {drawn(Role::exact)},
              Bound{0, "601 positions, and the points asked for", 601 + 51});
  check.holds("A measured reference is drawn at its points only.", {drawn(Role::data)}, Bound{0, "its points", 51});
  check.holds("Each instant is measured separately.", {bad.measurements().at("eta_relative_l2_t_2")},
              Roundoff{2 * 51, 0.1, "a rounded term and a rounded sum for each of 51 points", 0.1});

  // |E| = 0.25 beside u_data = 0.1: fails alone, passes with u_num = 0.1 (2 sqrt(0.02) = 0.283), and says nothing where
  // u_num = 0.5 makes the expanded uncertainty 1.02 > 0.5.
  const auto run_up = [](const std::string& uncertainty) {
    return verdict_of(scored({file_of("runup [m]\n2.25\n", "r")}, uncertainty), "runup-value");
  };
  is("A comparison without a stated uncertainty is inconclusive.", run_up(""), "inconclusive");
  is("A stated uncertainty of 0 gives the strictest comparison.", run_up("0"), "fail");
  is("A stated absolute uncertainty enters the comparison.", run_up("0.1"), "pass");
  is("A stated relative uncertainty enters the comparison.", run_up("5%"), "pass");
  is("A stated uncertainty beyond its ceiling does not turn a failure into a pass.", run_up("0.5"), "inconclusive");

  is("A result without one of the instants fails its coverage claim.",
     verdict_of(scored({file_of("t,x,eta\n1,0,0\n1,10,0\n", "mine.csv")}), "profiles-given"), "fail");
  const std::string in_order = profiles(0);
  std::istringstream lines(in_order.substr(in_order.find('\n') + 1));
  std::string reversed;
  for (std::string line; std::getline(lines, line);) reversed = line + "\n" + reversed;
  is("Rows in the reverse order are sorted.",
     verdict_of(scored({file_of("t,x,eta\n" + reversed, "mine.csv")}), "eta-relative_l2"), "pass");
  is("The column in which the rows differ is named in the message.",
     refusal("t,x,y,eta\n1,0,0,0\n1,1,0,0\n1,0,3,0\n1,1,3,0\n2,0,0,0\n2,1,0,0\n"), "holds y = 0 and 3, and one alone");
  is("Several rows of single numbers are rejected.", refusal("runup\n1\n2\n"),
     "mine.csv: column runup: 2 rows, must be exactly one");
  is("A file without any quantity of the case is rejected.", refusal("a,b\n1,2\n"), "is missing: the file has a, b");
  is("The template has a row per point and time.", template_of(wanted_tables().front(), "# opening\n"),
     "t [s],x [m],eta [m]\n1,0,\n1,0.2");
}

TEST_CASE("quantities without a reference need not be submitted", "[evidence]") {
  const WantedTable gauge = wanted_elevation(
      "gauge", WantedTable::Kind::series, [](Place p) { return p.abscissa > 0 ? std::sin(p.abscissa) : std::nan(""); },
      multiples(1, 4));
  SubmittedGroup later{.abscissa = {1, 2, 3, 4}};
  for (const double t : later.abscissa) later.values["eta"].push_back(std::sin(t));
  CHECK(verdict_of(scored({gauge}, {{"gauge", {later}}}), "gauge-coverage") == "pass");
}

TEST_CASE("an arrival is measured where something arrives", "[evidence]") {
  Check check("measured_arrival", "The arrival of a series",
              "A gauge that rises from rest has an arrival; a wall whose water falls from its highest has none.");
  const auto measured = [&](double phase) {
    const auto eta = [phase](double time) { return std::sin(time + phase); };
    const WantedTable gauge = wanted_elevation(
        "gauge", WantedTable::Kind::series, [eta](Place p) { return eta(p.abscissa); }, multiples(0.1, 100));
    const Submitted late = submission({gauge}, [&](const auto&, Place p) { return eta(p.abscissa - 0.2); });
    return scored({gauge}, late).measurements();
  };
  const double pi = std::acos(-1.0);
  check.holds("The arrival error of a rise lagging by 0.2 s is 0.2 s.", {measured(-0.5 * pi).at("eta_arrival_error")},
              Bound{0.002, "lines between points 0.1 apart miss a sine by 0.1^2/8", 0.2});
  check.holds("A falling series has no arrival time.",
              {static_cast<double>(measured(0.5 * pi).count("eta_arrival_error"))},
              Qualitative{"a measurement eta_arrival_error", "nothing arrives", false});
}

TEST_CASE("every measure of a curve follows by hand, with the uncertainty that is stated of its column", "[evidence]") {
  const std::vector<double> x{0, 1, 2, 3}, r{0, 2, -1, 1}, s{0, 2.5, -1, 1.25};
  struct Row {
    Measure measure;
    std::string id, name, unit;
    double value, uncertainty;
  };
  const double u = 0.1, u_x = 0.25, l2 = std::sqrt(6);
  const std::vector<Row> rows{
      {Measure::largest_error, "largest_error", "largest error", "m", 0.5, u},
      {Measure::relative_l1, "relative_l1", "relative L1 error", "1", 0.75 / 4, u / (4.0 / 4)},
      {Measure::relative_l2, "relative_l2", "relative L2 error", "1", std::sqrt(0.3125) / l2, u / (l2 / 2)},
      {Measure::relative_linf, "relative_linf", "relative Linf error", "1", 0.5 / 2, u / 2},
      {Measure::amplitude_ratio, "amplitude_ratio", "amplitude ratio", "1", 3.5 / 3, std::sqrt(2) * u / 3},
      {Measure::peak_error, "peak_error", "error of the peak", "m", 0.5, u},
      {Measure::peak_shift, "peak_shift", "shift of the peak", "s", 0, u_x},
      {Measure::arrival_error, "arrival_error", "error of arrival", "s", 0.2 / 2.5 - 0.2 / 2, u_x},
      {Measure::skill, "skill", "Willmott's index of agreement", "1", 1 - 0.3125 / 23.8125, 0}};
  WantedTable gauge = wanted_elevation(
      "gauge", WantedTable::Kind::series, [r](Place p) { return r[static_cast<std::size_t>(p.abscissa)]; }, x);
  gauge.reference_role = Role::data;
  for (const Row& row : rows) {
    gauge.quantities.front().requirements.push_back(
        {row.measure,
         evidence::Uncertainty{.expected = 7, .data = 1, .useful = 99, .reason = "of this test", .coverage = 3},
         "text of " + row.id, "source of " + row.id});
  }
  const Submitted all{{"gauge", {{.value = 0, .abscissa = x, .values = {{"eta", s}}}}}};
  const std::vector<std::map<std::string, StatedUncertainty>> alike{
      {{"eta", {u}}, {"t", {u_x}}},
      {{"eta", uncertainty_from("eta", "5%")}, {"t", {.value = u_x / 3, .relative = true}}},
      {{"eta", {.value = 0.06, .scatter = 0.08}}, {"t", {.value = 0, .scatter = u_x}}}};
  for (const auto& uncertainty : alike) {
    const evidence::Record record = scored({gauge}, all, uncertainty);
    REQUIRE(record.claims().size() == rows.size() + 1);
    CHECK((record.claims()[0].claim.id == "gauge-coverage" && record.claims()[0].judgement.measured == 1));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto& [claim, criterion, judgement, known] = record.claims()[k + 1];
      const Row& row = rows[k];
      INFO(row.id);
      CHECK((claim.id == "eta-" + row.id && claim.quantity == row.name + " of eta" && claim.unit == row.unit));
      CHECK((claim.text == "text of " + row.id && claim.source == "source of " + row.id));
      CHECK(judgement.measured == Approx(row.value).margin(1e-14));
      CHECK(judgement.uncertainty.value() == Approx(3 * row.uncertainty).epsilon(1e-14));
      CHECK(judgement.limit == Approx(3 * std::hypot(1, row.uncertainty)).epsilon(1e-14));
      CHECK(record.measurements().at("eta_" + row.id) == judgement.measured);
    }
    const evidence::Table& table = record.tables().front();
    CHECK(table.id == "gauge-measures");
    const auto& row = table.rows.front();
    std::size_t column = 2;
    for (const auto& [name, value] :
         {std::pair("points", 4.0), std::pair("coverage", 1.0), std::pair("relative L1", rows[1].value),
          std::pair("relative L2", rows[2].value), std::pair("relative Linf", 0.25), std::pair("skill", rows[8].value),
          std::pair("amplitude ratio", rows[4].value)}) {
      CHECK((table.columns.at(column).first == name && std::get<double>(row.at(column)) == Approx(value)));
      ++column;
    }
    CHECK((table.columns.back().first == "error of the peak" && std::get<double>(row.back()) == 0.5));
    const evidence::Panel& panel = record.figures().front().panels().front();
    CHECK(
        (panel.axes().x == "t [s]" && panel.axes().y == "elevation eta [m]" && record.figures().front().id == "gauge"));
    REQUIRE(panel.series().size() == 2);
    CHECK((panel.series()[0].label == "reference" && panel.series()[0].x == x && panel.series()[0].y == r));
    CHECK((panel.series()[1].label == "submitted" && panel.series()[1].x == x && panel.series()[1].y == s));
  }
  const evidence::Record unstated = scored({gauge}, all);
  for (const auto& one : unstated.claims()) {
    if (one.claim.id != "eta-skill") CHECK_FALSE(one.judgement.uncertainty.has_value());
  }
}

TEST_CASE("six groups at most are drawn, each in a panel with its own curve", "[evidence]") {
  const std::vector<double> x{0, 1};
  WantedTable wave = wanted_elevation("wave", WantedTable::Kind::profile,
                                      [](Place p) { return 10 * p.group + p.abscissa; }, x, {1, 2, 3, 4, 5, 6, 7});
  wave.reference_role = Role::data;
  const evidence::Record record =
      scored({wave}, submission({wave}, [](const auto&, Place p) { return p.group + 0.5 * p.abscissa; }));
  REQUIRE(record.figures().size() == 1);
  CHECK((record.figures().front().id == "wave-eta" && record.figures().front().panels().size() == 6));
  for (std::size_t k = 0; k < 6; ++k) {
    const evidence::Panel& panel = record.figures().front().panels()[k];
    const double t = static_cast<double>(k) + 1;
    CHECK(panel.axes().title == fmt::format("t = {:g} s", t));
    CHECK((panel.series()[0].y == std::vector<double>{10 * t, 10 * t + 1}));
    CHECK((panel.series()[1].y == std::vector<double>{t, t + 0.5}));
  }
  CHECK(record.measurements().at("eta_largest_error_t_7") == 71 - 7.5);
}

}  // namespace seiche::verification::score_test
