// The front of a collapsing column whose clock is wrong: what is fitted to it.
#include <cmath>
#include <string>
#include <vector>

#include "validation/dam_break/submitted_front.hpp"
#include "verification/check.hpp"
#include "verification/evidence/known_curve.hpp"

namespace seiche::verification::front_fit_test {

using namespace validation;
using evidence::Bound;
using evidence::Qualitative;

TEST_CASE("the rate of a front is found beside its shift", "[evidence]") {
  Check check("front_fit", "Shift and rate of a front",
              "Points of a known front, read from a clock with a lag and a slow rate: both are found, and the stated "
              "uncertainty of the front is propagated to its rate.",
              "linear propagation");
  const auto front = [](double T) { return 1 + T * T / (1 + 0.55 * T); };
  const auto [T, X] = sampled(0, 10, 2000, front);
  ColumnFront data{.uncertainty = 0.05, .time_uncertainty = 0.05};
  constexpr double shift = 0.17, rate = 1.054;
  for (int k = 2; k <= 15; ++k) {
    data.T.push_back(0.55 * k);
    data.X.push_back(front(rate * (data.T.back() - shift)));
  }
  const FrontFit fit = front_fit({T, X}, data, 100, 0.02);
  const auto close = [&](const std::string& id, double value, double expected) {
    check.from("definition of the fit")
        .that(id, "The " + id + " of a front that is moved by 0.17 and 1.054 is found.", id, {value},
              Bound{6.25e-6,
                    "straight lines between points 0.005 apart miss a front of second derivative 2 at most by "
                    "0.005^2/4 = 6.25e-6",
                    expected});
  };
  close("shift", fit.shift, shift);
  close("rate", fit.rate, rate);
  // From T = 1.2 on, where X = 1.87: the first two of the points may be before that, and say nothing.
  const std::vector<double> late_T(T.begin() + 240, T.end());
  const std::vector<double> late_X(X.begin() + 240, X.end());
  const FrontFit late = front_fit({late_T, late_X}, data, 100, 0.02);
  close("late-shift", late.shift, shift);
  close("late-rate", late.rate, rate);
  const FrontFit exact = front_fit({T, X}, data, 100, 0.0);
  const FrontFit twice = front_fit({T, X}, data, 100, 0.04);
  check.that("uncertainty", "Twice the uncertainty of the front gives twice the uncertainty of the rate.", "ratio",
             {*twice.rate_numerical / *fit.rate_numerical}, Bound{1e-12, "round-off", 2});
  check.that("certain", "The uncertainty added by an exact front is zero.", "numerical uncertainty of the rate",
             {*exact.rate_numerical}, Bound{0, "no uncertainty was stated"});
  check.that("unstated", "The returned uncertainty is empty if none is stated.", "an uncertainty is given",
             {front_fit({T, X}, data, 100, std::nullopt).rate_numerical ? 1.0 : 0.0},
             Qualitative{"an uncertainty", "none was stated", false});
  // An X that is wrong by 0.02 with the sign of the weights moves the rate by as much as is said, to first order.
  std::vector<double> farther = X;
  for (double& x : farther) x += 0.02;
  check.from("triangle inequality")
      .that("bound", "The stated bound covers the change of the rate by a front 0.02 too far.",
            "change of the rate over its bound",
            {std::abs(front_fit({T, farther}, data, 100, 0.02).rate - fit.rate) / *fit.rate_numerical},
            Bound{1, "a bound of errors of every sign, to first order"});
}

}  // namespace seiche::verification::front_fit_test
