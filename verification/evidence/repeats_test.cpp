// Several runs of one set-up: their mean and their scatter.
#include <cmath>

#include "validation/scoring/repeats.hpp"
#include "verification/check.hpp"

namespace seiche::verification::repeats_test {

using namespace validation;

/// A table of one group: a straight line, higher by `above`, on points `step` apart.
Submitted line(double above, double step) {
  SubmittedGroup group;
  for (double x = 0; x <= 4; x += step) {
    group.abscissa.push_back(x);
    group.values["eta"].push_back(1 + 0.5 * x + above);
  }
  return {{"wave", {group}}};
}

TEST_CASE("of several runs the mean is evaluated, and the scatter is known", "[evidence]") {
  Check check("repeats", "Runs of one set-up",
              "Three straight lines, 0.01 below, on and above one another, the second on other points.");
  const Repeats repeats = repeats_of({line(-0.01, 0.5), line(0, 0.25), line(0.01, 0.5)});
  const auto is = [&](const std::string& text, double got, double expected) {
    check.holds(text, {got}, Roundoff{30, 3, "three numbers up to 3 at 9 points", expected});
  };
  const SubmittedGroup& mean = repeats.mean.at("wave").front();
  is("The mean of the repeats is given at the points of the first run.", static_cast<double>(mean.abscissa.size()), 9);
  is("The mean of the repeats is the mean at every point.", mean.values.at("eta").back(), 3);
  is("The scatter is the standard deviation of single runs.", repeats.scatter.at("eta"), 0.01);

  std::map<std::string, StatedUncertainty> stated{{"eta", {.value = 0.01}}};
  add_scatter(repeats, stated);
  is("The uncertainty of the mean is added to the stated uncertainty.", stated.at("eta").of(3),
     std::sqrt(1e-4 + 1e-4 / 3));
  std::map<std::string, StatedUncertainty> share{{"eta", {.value = 0, .relative = true}}};
  add_scatter(repeats, share);
  is("The uncertainty of the mean is added to a relative uncertainty, however small the reference.",
     share.at("eta").of(0.1), 0.01 / std::sqrt(3.0));
  std::map<std::string, StatedUncertainty> nothing;
  add_scatter(repeats, nothing);
  is("The uncertainty of the mean is unknown if no uncertainty is stated.", static_cast<double>(nothing.size()), 0);

  CHECK_THROWS_WITH(repeats_of({line(0, 0.5)}), "--repeats 1: must be at least 2");
  Submitted other = line(0, 0.5);
  other["wave"].front().value = 2;
  CHECK_THROWS_WITH(repeats_of({line(0, 0.5), other}), "--repeats: the runs differ in the groups of table wave");
  Submitted elsewhere = line(0, 0.5);
  for (double& x : elsewhere["wave"].front().abscissa) x += 10;
  CHECK_THROWS_WITH(repeats_of({line(0, 0.5), elsewhere}),
                    "--repeats: the runs have 0 points of table wave in common, needed: 2");
}

}  // namespace seiche::verification::repeats_test
