#include "reports/evidence/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::evidence {
namespace {

constexpr std::array<std::string_view, 4> verdict_names{"pass", "inconclusive", "fail", "error"};

void require_reason(const std::string& reason) {
  if (reason.empty()) throw std::invalid_argument("criterion: reason is empty, must say where the limit comes from");
}

/// Judges |value - expected| <= limit for a value known to +- uncertainty.
Judgement within(const Measurement& m, double expected, double limit) {
  Judgement j{.measured = m.value,
              .uncertainty = m.uncertainty,
              .expected = expected,
              .limit = limit,
              .resolution = m.resolution,
              .note = {}};
  const double distance = std::abs(m.value - expected);
  if (!std::isfinite(distance) || std::isnan(limit)) {
    j.verdict = Verdict::fail;
    j.note = "the measured value is not a finite number";
  } else if (std::isfinite(m.uncertainty) && distance + m.uncertainty <= limit) {
    j.verdict = Verdict::pass;
  } else if (distance - m.uncertainty > limit) {
    j.verdict = Verdict::fail;
  } else {
    j.verdict = Verdict::inconclusive;
    j.note = "the numerical uncertainty straddles the limit";
  }
  return j;
}

Judgement apply(const Measurement& m, const Roundoff& c) {
  require_reason(c.reason);
  constexpr double standard_deviations = 4;
  const double limit = standard_deviations * std::numeric_limits<double>::epsilon() * std::sqrt(c.operations) * c.scale;
  return within(m, c.expected, limit);
}

Judgement apply(const Measurement& m, const Bound& c) {
  require_reason(c.reason);
  return within(m, c.expected, c.relative ? c.limit * std::abs(c.expected) : c.limit);
}

Judgement apply(const Measurement& m, const Uncertainty& c) {
  require_reason(c.reason);
  // m.uncertainty is an expanded (95 %) half-width; the criterion combines standard uncertainties.
  const double numerical = m.uncertainty / c.coverage;
  const double expanded = c.coverage * std::hypot(numerical, c.input, c.data);
  Judgement j = within({.value = m.value, .uncertainty = 0, .resolution = m.resolution}, c.expected, expanded);
  j.uncertainty = m.uncertainty;
  if (!(expanded <= c.useful)) {
    j.verdict = Verdict::inconclusive;
    j.note = fmt::format("the expanded uncertainty {:.3g} exceeds {:.3g}, the largest that still decides", expanded,
                         c.useful);
  }
  return j;
}

Judgement apply(const Measurement& m, const Qualitative& c) {
  require_reason(c.reason);
  return within(m, c.expected ? 1.0 : 0.0, 0.0);
}

Judgement apply(const Measurement& /*m*/, const Order& /*c*/) {
  throw std::invalid_argument("criterion: Order judges an ObservedOrder, not a single measurement");
}

}  // namespace

std::string_view name(Verdict verdict) {
  return verdict_names.at(static_cast<std::size_t>(verdict));
}

Verdict verdict_from(std::string_view name) {
  const auto* found = std::find(verdict_names.begin(), verdict_names.end(), name);
  if (found == verdict_names.end()) throw std::invalid_argument(fmt::format("verdict = {} is unknown", name));
  return static_cast<Verdict>(found - verdict_names.begin());
}

Judgement judge(const Measurement& measurement, const Criterion& criterion) {
  return std::visit([&](const auto& c) { return apply(measurement, c); }, criterion);
}

Judgement judge(const ObservedOrder& observed, const Order& criterion) {
  require_reason(criterion.reason);
  Judgement j{.verdict = Verdict::inconclusive,
              .measured = observed.order,
              .uncertainty = observed.half_width,
              .expected = criterion.theory,
              .limit = criterion.tolerance,
              .resolution = fmt::format("{} resolutions", observed.sizes.size()),
              .note = observed.note};
  const double distance = std::abs(observed.order - criterion.theory);
  if (distance + observed.half_width <= criterion.tolerance) {
    j.verdict = Verdict::pass;
  } else if (distance - observed.half_width > criterion.tolerance) {
    j.verdict = Verdict::fail;
  }
  return j;
}

}  // namespace seiche::evidence
