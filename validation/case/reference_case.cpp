#include "validation/case/reference_case.hpp"

#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

constexpr const char* tolerance_reason =
    "the case's parameter `tolerance`; by default 5 %/sqrt(2): the limit of tsunami benchmarks against exact solutions "
    "(Synolakis et al. 2008), 5 %, shared in quadrature by height and phase, so that 5 % of either is detected";

}  // namespace

void claim_identities(const Claims<exact::SelfTest>& claims, const exact::SelfTest& declared) {
  for (std::size_t k = 0; k < declared.size(); ++k) {
    const exact::Identity& identity = declared[k];
    claims.check(
        fmt::format("identity-{}", k + 1),
        fmt::format("The residual of the reference solution's identity is within its accuracy: {}.", identity.name),
        "relative defect", [k](const exact::SelfTest& test) { return test.at(k).defect; },
        Bound{.limit = identity.accuracy, .reason = identity.reason});
  }
}

Amount to_be_told() {
  return Amount::told_by_run(std::numeric_limits<double>::infinity());
}

Parameter tolerance_parameter() {
  return real("tolerance", 0.05 / std::numbers::sqrt2, "1", {1e-12, 1},
              "relative error that still passes a submitted result");
}

Requirement within_tolerance(Measure measure, const Values& values, const std::string& text, const std::string& source,
                             double expected) {
  return {.measure = measure,
          .criterion = Bound{.limit = values.real("tolerance"),
                             .reason = tolerance_reason,
                             .expected = expected,
                             .relative = expected != 0},
          .text = text,
          .source = source};
}

WantedQuantity wanted_number(const Column& column, double reference, const Values& values, const std::string& text,
                             const std::string& source) {
  return {.column = column,
          .reference = [reference](Place) { return reference; },
          .requirements = {within_tolerance(Measure::value, values, text, source, reference)}};
}

WantedQuantity wanted_number(const Column& column, std::function<double()> reference, const Values& values,
                             const std::string& text, const std::string& source) {
  Requirement close = within_tolerance(Measure::value, values, text, source, 1);
  std::get<Bound>(close.criterion).expected = to_be_told();
  return {.column = column,
          .reference = [kept = Lazy<double>(std::move(reference))](Place) { return *kept; },
          .requirements = {close}};
}

std::vector<double> evenly(double first, double last, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(first + (last - first) * k / (count - 1));
  return values;
}

}  // namespace seiche::validation
