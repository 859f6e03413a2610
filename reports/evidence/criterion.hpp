/// When does a measurement support its claim? Every criterion carries the reason for its limit.
#pragma once

#include <limits>
#include <string>
#include <variant>

namespace seiche::evidence {

/// A number of a criterion: stated beforehand or told by the run, and then at most so large. Beyond that cap the claim
/// says nothing: its verdict is inconclusive.
class Amount {
 public:
  Amount(double stated) : value_(stated) {}  // NOLINT(google-explicit-constructor): most criteria state numbers

  /// Known beforehand, but growing with a resolution that the user may set. @param cap  of its absolute value
  static Amount at_most(double stated, double cap) {
    Amount amount(stated);
    amount.cap_ = cap;
    return amount;
  }
  /// Counted, summed or extrapolated in the run; its measurement tells it. @param cap  of its absolute value
  static Amount told_by_run(double cap) {
    Amount amount = at_most(std::numeric_limits<double>::quiet_NaN(), cap);
    amount.to_be_told_ = true;
    return amount;
  }

  [[nodiscard]] bool stated() const { return !to_be_told_; }
  [[nodiscard]] bool capped() const { return cap_ < std::numeric_limits<double>::infinity(); }
  /// NaN while it is not told.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double cap() const { return cap_; }
  /// The same with the run's number.
  [[nodiscard]] Amount with(double told) const {
    Amount amount = *this;
    amount.value_ = told;
    return amount;
  }

 private:
  double value_;
  double cap_ = std::numeric_limits<double>::infinity();
  bool to_be_told_ = false;
};

/// |value - expected| <= 4 eps sqrt(operations) scale: four standard deviations of a random walk of rounding errors.
struct Roundoff {
  Amount operations = 1;  ///< rounded operations that contribute
  Amount scale = 1;       ///< magnitude of the numbers that are rounded, in the claim's unit
  std::string reason;     ///< how operations and scale were counted
  Amount expected = 0;
};

/// The observed order lies inside theory +- tolerance, and its interval excludes the orders theory +- 1.
struct Order {
  double theory = 2;
  double tolerance = 0.1;
  std::string reason;
};

/// |value - expected| <= limit; relative to |expected| if `relative`.
struct Bound {
  Amount limit = 0;
  std::string reason;  ///< where the limit comes from
  Amount expected = 0;
  bool relative = false;
};

/// |value - expected| <= coverage sqrt(u_num^2 + u_input^2 + u_data^2) (ASME V&V 20-2009). Agreement is inconclusive
/// when that uncertainty exceeds `useful`, for agreement within an uncertainty that large says nothing; a larger
/// difference is one whatever its uncertainty. Where u_num was not estimated, it is inconclusive, unless the difference
/// exceeds the rest by more than `useful`: then no u_num that decides anything explains it.
struct Uncertainty {
  Amount expected = 0;
  Amount data = 0;    ///< standard uncertainty of the reference
  Amount input = 0;   ///< standard uncertainty from inexactly known inputs
  double useful = 0;  ///< largest expanded uncertainty that still decides
  std::string reason;
  double coverage = 2;
};

/// A named feature is present (measured value 1) or absent (0).
struct Qualitative {
  std::string detector;  ///< how presence is decided
  std::string reason;
  bool expected = true;
};

using Criterion = std::variant<Roundoff, Order, Bound, Uncertainty, Qualitative>;

/// A claim that the method is known not to meet: it fails, and fails by so much. Met after all, or failing by another
/// amount, it is as unexpected as a failure elsewhere.
struct KnownFailure {
  double value = 0;  ///< what is measured
  double width = 0;  ///< measured values lie within value +- width; infinite where no cause gives a band
  std::string reason;

  [[nodiscard]] bool holds(double measured) const { return measured >= value - width && measured <= value + width; }
};

}  // namespace seiche::evidence
