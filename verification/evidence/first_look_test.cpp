// Where an error is, and of what kind.
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "validation/scoring/first_look.hpp"
#include "validation/scoring/score.hpp"
#include "verification/check.hpp"

namespace first_look_test {

using namespace seiche;
using namespace seiche::validation;
using namespace seiche::verification;

std::vector<double> places() {
  std::vector<double> x;
  for (int k = 0; k <= 200; ++k) x.push_back(0.0628318530717958 * k);
  return x;
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
  return {{.name = "wave",
           .kind = WantedTable::Kind::profile,
           .abscissa = Column{"x", unit, "place"},
           .quantities = {{.column = {"eta", unit, "elevation"},
                           .reference = [](Place p) { return std::sin(p.abscissa); },
                           .requirements = {{.measure = Measure::relative_l2,
                                             .criterion = Bound{0.05, "of this test"},
                                             .text = "The wave is right.",
                                             .source = "this test"}}}},
           .points = [](double) { return places(); },
           .reference_role = role}};
}

std::string answer(const std::function<double(double)>& submitted, const std::string& question,
                   evidence::Role role = evidence::Role::exact, const std::optional<Ladder>& ladder = {},
                   const std::string& unit = "m") {
  evidence::Record record;
  const std::vector<WantedTable> tables = wanted(role, unit);
  const Submitted all{{"wave", {{.value = 0, .abscissa = places(), .values = {{"eta", values(submitted)}}}}}};
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
    const auto y = values([&](double x) { return std::sin(x) * (1 + falling * h + staying); });
    rungs.push_back({.size = h, .submitted = {{"wave", {{.value = 0, .abscissa = places(), .values = {{"eta", y}}}}}}});
  }
  return ladder_of(wanted(evidence::Role::exact), rungs);
}

TEST_CASE("the first screen says where an error is, of what kind, whose it is and what to do", "[evidence]") {
  Check check("first_look", "A score at first sight",
              "A sine with errors of known kinds: two wavelengths, joined by straight lines between 201 points.");
  const auto share = [&](const std::string& id, const std::string& text, double value) {
    check.holds(id + ": " + text, {value}, Bound{0.01, "differences of neighbours for the slope, and small shifts", 1});
  };
  const auto says = [&](const std::string& id, const std::string& text, const std::string& got,
                        const std::string& expected) {
    check.holds(id + ": " + text, {got.find(expected) != std::string::npos ? 1.0 : 0.0},
                Qualitative{"\"" + expected + "\"", "it was made so"});
  };
  share("phase", "A wave that is late has an error of phase.",
        kind_of([](double x) { return std::sin(x - 0.05); }).phase);
  share("amplitude", "One too high an error of amplitude.",
        kind_of([](double x) { return 1.1 * std::sin(x); }).amplitude);
  share("level", "One that stands too high an error of level.",
        kind_of([](double x) { return std::sin(x) + 0.1; }).level);
  const auto bump = [](double x) { return std::sin(x) + 0.2 * std::exp(-std::pow((x - 4.5) / 0.2, 2)); };
  share("place", "A bump has its error where it is.", kind_of(bump).near);
  check.holds("The place of the largest error is named.", {kind_of(bump).where},
              Bound{0.0315, "half a distance of points", 4.5});
  says("shape", "No single number explains a bump.", kind_of(bump).words(), "shape");
  says("words", "What it is is said.", kind_of([](double x) { return std::sin(x - 0.05); }).words(), "phase: 100 %");

  const auto high = [](double x) { return 1.2 * std::sin(x); };
  says("right", "Of a right result nothing is to be mended.",
       answer([](double x) { return std::sin(x); }, "whose it is"), "within every limit");
  says("verdict", "Claims are counted.", answer(high, "verdict"), "1 of 2 claims are met, 1 not met");
  says("line", "The worst is named.", answer(high, "in one line"),
       "The wave is right. fail (eta-relative_l2: off by 0.2");
  const auto place = [&](const std::string& unit) {
    return answer(bump, "where the error is", evidence::Role::exact, {}, unit);
  };
  says("unit", "Where it is has a unit.", place("m"), "eta: largest at x = 4.524 m, +0.197 m; ");
  says("dimensionless", "What has no dimension has none.", place("1"), "eta: largest at x = 4.524, +0.197; ");
  says("solver", "Against an exact reference it is the solver's or its set-up's.", answer(high, "whose it is"),
       "three sizes tell which");
  says("next", "And sizes are asked for.", answer(high, "next step"), "--sizes");
  says("data", "Against data without uncertainty nobody knows.", answer(high, "whose it is", evidence::Role::data),
       "your solver's or the data's");
  says("resolution", "An error that falls with the size is the resolution's.",
       answer(high, "whose it is", evidence::Role::exact, ladder_of_errors(0.2, 0)), "your resolution's");
  says("finer", "Then a finer size is named.",
       answer(high, "next step", evidence::Role::exact, ladder_of_errors(0.2, 0)), "run dx = 0.05: 1 % of eta");
  says("model", "One that stays is the model's.",
       answer(high, "whose it is", evidence::Role::exact, ladder_of_errors(0.001, 0.2)), "your model's or set-up's");
  says("model-next", "Then finer cells do not mend it.",
       answer(high, "next step", evidence::Role::exact, ladder_of_errors(0.001, 0.2)), "finer cells do not mend it");
}

}  // namespace first_look_test
