// A result on several sizes: order, limit, cost, and what one per cent needs.
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "validation/scoring/ladder.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"
#include "verification/message_of.hpp"

namespace seiche::verification::ladder_test {

using namespace validation;

const std::vector<double> sizes{0.1, 0.05, 0.025};

/// sin x over a period at two times, and a number 2.
std::vector<WantedTable> wanted_of(evidence::Role role) {
  std::vector<WantedTable> wanted{
      wanted_elevation("wave", WantedTable::Kind::profile, [](Place p) { return std::sin(p.abscissa) + 0.1 * p.group; },
                       multiples(0.15, 40), {1, 2}),
      {.name = "number",
       .quantities = {{.column = {"height", "m", "a height"}, .reference = [](Place) { return 2.0; }}}}};
  for (WantedTable& table : wanted) table.reference_role = role;
  return wanted;
}

/// The reference with an error a h^p of the shape of a cosine, and a constant that no size takes away.
Submitted submitted(double h, double p, double wrong) {
  const double error = 3 * std::pow(h, p);
  return submission(wanted_of(evidence::Role::exact), [&](const WantedQuantity& quantity, Place at) {
    const bool number = quantity.column.name == "height";
    return (number ? 2 * (1 + error) : quantity.reference(at) + error * std::cos(at.abscissa)) + wrong;
  });
}

/// Results on several sizes, in whatever order.
std::vector<Rung> rungs_of(const std::vector<double>& all, const std::function<Submitted(double h)>& result) {
  std::vector<Rung> rungs;
  for (const double h : all) rungs.push_back({.size = h, .submitted = result(h)});
  return rungs;
}

Ladder ladder(double p, double wrong = 0, evidence::Role role = evidence::Role::exact) {
  std::vector<Rung> rungs = rungs_of({0.05, 0.1, 0.025}, [&](double h) { return submitted(h, p, wrong); });
  for (Rung& rung : rungs) rung.seconds = 0.001 / (rung.size * rung.size * rung.size);
  return ladder_of(wanted_of(role), rungs);
}

std::string refusal(const std::vector<Rung>& rungs) {
  return message_of([&] { ladder_of(wanted_of(evidence::Role::exact), rungs); });
}

TEST_CASE("a grid-refinement series reports order, limit, and size and cost for 1 % error", "[evidence]") {
  Check check("score_ladder", "How fast somebody else's solver converges",
              "Made-up results with an error of a known power of the size, on three sizes: the score must return the "
              "values they were made with.");
  const auto close = [&](const std::string& text, double value, double expected, double limit, const std::string& why) {
    check.holds(text, {value / expected - 1}, Bound{limit, why});
  };
  const auto is = [&](const std::string& text, bool holds, const std::string& shown = {}) {
    INFO(shown);
    check.holds(text, {holds ? 1.0 : 0.0}, Qualitative{"comparison", "it was made so"});
  };
  const std::string rounding = "powers of a few digits, a dozen roundings";
  const Ladder first = ladder(1);
  const LadderQuantity& eta = first.quantities.at(0);
  const LadderQuantity& height = first.quantities.at(1);
  is("The cell sizes are sorted, coarse first.", first.size == std::vector{0.1, 0.05, 0.025});
  close("The reported order of a first-order result is 1.", eta.order.order, 1, 1e-9, rounding);
  close("The order of a result that is one number is 1.", height.order.order, 1, 1e-9, rounding);
  close("The reported error on the finest cells is exact.", height.error.back(), 0.075, 1e-12, rounding);
  close("The reported order of a second-order result is 2.", ladder(2).quantities.at(0).order.order, 2, 1e-9, rounding);
  const auto reach = first.reach(height, 0.01);
  close("The reported cell size for 1 % of an error 3 h is h = 1/300.", reach ? reach->size : 0, 1.0 / 300, 1e-9,
        rounding);
  close("The reported time for 1 % at cubic cost is 27 s.", reach && reach->seconds ? *reach->seconds : 0, 27000, 1e-9,
        rounding);
  const Ladder second = ladder(2);
  const auto sooner = second.reach(second.quantities.at(1), 0.01);
  close("The reported cell size for 1 % of an error 3 h^2 is h = sqrt(1/300).", sooner ? sooner->size : 0,
        std::sqrt(1.0 / 300), 1e-9, rounding);
  // A scalar with error a h has 1.25 a h for its half-width: the safety factor of Roache.
  close("The reported numerical error is 1.25 times the finest error.", height.numerical, 1.25 * 0.075, 1e-3,
        "the scan for the order has steps of 0.005");
  is("The printed line states order, error and reach.",
     first.line(height).find("your order is 1 (") != std::string::npos &&
         first.line(height).find("1 % needs dx = 0.0033 and 2.7e+04 s") != std::string::npos,
     first.line(height));

  // The error of the middle size is that of another, in units of `scale`.
  const auto scattered = [](double middle, double scale) {
    return ladder_of(wanted_of(evidence::Role::exact),
                     rungs_of(sizes, [&](double h) { return submitted(scale * (h == 0.05 ? middle : h), 1, 0); }));
  };
  const Ladder rough = scattered(0.09, 1);
  says(check, "The scatter of three cell sizes is reported.", rough.line(rough.quantities.at(1)),
       "but 3 sizes leave the order uncertain");
  int ranges = 0, outside = 0;
  for (const double scale : {1e-3, 0.05, 0.1, 1.0}) {  // errors of the finest from 0.0075 to 7.5 per cent
    for (const double middle : {0.0255, 0.03, 0.05, 0.09, 0.3}) {
      const Ladder one = scattered(middle, scale);
      const std::optional<Reach> range = one.reach(one.quantities.at(1), 0.01);
      if (!range) continue;
      ++ranges;
      outside += range->least <= range->size && range->size <= range->most ? 0 : 1;
    }
  }
  is("The range of the size for 1 % holds that size, whatever the order's interval.", outside == 0 && ranges >= 12,
     fmt::format("{} of {} without", outside, ranges));
  const Ladder wrong = ladder(1, 0.5);
  says(check, "An error that does not converge to zero is reported.", wrong.line(wrong.quantities.at(1)),
       "not to zero");
  is("The reported cell size for 1 % is empty if the error does not converge to zero.",
     !wrong.reach(wrong.quantities.at(1), 0.01).has_value());

  // Against data, what converges is the distance from the result's own limit, wherever that is.
  const Ladder measured = ladder(1, 0.5, evidence::Role::data);
  close("Against data the order agrees with the result's own convergence.", measured.quantities.at(1).order.order, 1,
        0.02, "the scan for the limit has steps of 0.005 in the order");
  std::map<std::string, StatedUncertainty> uncertainty{{"height", {.value = 0.7}}};
  add_numerical(measured, uncertainty);
  close("A stated uncertainty is reported beside the uncertainty of the series.", uncertainty.at("height").value, 0.7,
        0, "the same number");
  close("An uncertainty that was not stated comes from the series, as a standard uncertainty.",
        uncertainty.at("eta").value, measured.quantities.at(0).typical / 2, 1e-15, "the same number");
  std::map<std::string, StatedUncertainty> none;
  add_numerical(first, none);
  is("The added uncertainty against an exact reference is zero.", none.empty());

  says(check, "A series of two cell sizes is rejected.", refusal({{.size = 1}, {.size = 2}}), "three or more");
  says(check, "A series of equal cell sizes is rejected.", refusal({{.size = 1}, {.size = 1}, {.size = 2}}),
       "all different");
  std::vector<Rung> untimed = rungs_of(sizes, [](double h) { return submitted(h, 1, 0); });
  untimed.back().seconds = 3;
  says(check, "Run times for some of the cell sizes alone are rejected.", refusal(untimed), "1 times for 3 sizes");
}

}  // namespace seiche::verification::ladder_test
