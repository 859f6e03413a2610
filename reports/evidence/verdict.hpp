#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reports/evidence/claim.hpp"
#include "reports/evidence/criterion.hpp"

namespace seiche::evidence {

/// Ordered from best to worst, so that the worse of two verdicts is the larger.
enum class Verdict { pass, inconclusive, fail, error };

std::string_view name(Verdict verdict);
Verdict verdict_from(std::string_view name);

/// A verdict with the limit it was judged by, in the claim's unit (in orders for Order), and what a reader should know.
struct Judgement {
  Verdict verdict = Verdict::error;
  double measured = 0;
  std::optional<double> uncertainty = {};  ///< none: not estimated
  double expected = 0;
  double limit = 0;
  std::string resolution = {};
  std::string note = {};
};

/// A criterion with what the run told of it. @throws std::invalid_argument naming what the run had to tell and did not
Criterion settled(const Criterion& criterion, const Told& told);

/// Judges a number by a settled criterion. A value, an uncertainty or a limit that is not a finite number is an error.
/// Where the measurement has an uncertainty that straddles the limit of a Bound, and where the run told more than the
/// cap of an amount, the verdict is inconclusive. Throws std::invalid_argument for a criterion without a reason, or for
/// Order.
Judgement judge(const Measurement& measurement, const Criterion& criterion);

/// Judges an observed order: fail with its interval disjoint from the allowed one, inconclusive where that interval
/// holds theory +- 1 or there are fewer than four usable points, an error where an error norm is not a finite number.
Judgement judge(const ObservedOrder& observed, const Order& criterion);

/// The judgement of a claim whose measurement failed.
Judgement error(const std::string& what);

}  // namespace seiche::evidence
