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

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

/// "worst at t = 0.35 s" where the measurement says where.
std::string place(const Measurement& m) {
  return m.where.empty() ? "" : "at " + m.where;
}

Judgement unfit(Judgement judgement, Verdict verdict, const std::string& why) {
  judgement.verdict = verdict;
  judgement.note = joined(why, judgement.note);
  return judgement;
}

/// Judges |value - expected| <= limit for a value known to +- uncertainty.
Judgement within(const Measurement& m, double expected, double limit) {
  const Judgement j{.measured = m.value,
                    .uncertainty = m.uncertainty,
                    .expected = expected,
                    .limit = limit,
                    .resolution = m.resolution,
                    .note = place(m)};
  const double half_width = m.uncertainty.value_or(0);
  const double distance = std::abs(m.value - expected);
  if (!std::isfinite(m.value)) return unfit(j, Verdict::error, "the measured value is not a finite number");
  if (!std::isfinite(expected)) return unfit(j, Verdict::error, "the expected value is not a finite number");
  if (!std::isfinite(limit)) return unfit(j, Verdict::error, "the limit is not a finite number");
  if (std::isnan(half_width) || half_width < 0) return unfit(j, Verdict::error, "the uncertainty is not a number");
  if (distance + half_width <= limit) return unfit(j, Verdict::pass, "");
  if (distance - half_width > limit) return unfit(j, Verdict::fail, "");
  return unfit(j, Verdict::inconclusive, "the numerical uncertainty straddles the limit");
}

/// What the run told is more than the criterion allows it to be: empty if it is not.
std::string beyond_cap(const char* name, const Amount& amount) {
  if (std::abs(amount.value()) <= amount.cap() || !std::isfinite(amount.value())) return "";
  return fmt::format("{} = {:.3g} exceeds {:.3g}, beyond which the claim says nothing", name, amount.value(),
                     amount.cap());
}

Judgement capped(Judgement judgement, std::initializer_list<std::pair<const char*, Amount>> amounts) {
  for (const auto& [name, amount] : amounts) {
    const std::string beyond = beyond_cap(name, amount);
    if (!beyond.empty() && judgement.verdict != Verdict::error) {
      judgement = unfit(std::move(judgement), Verdict::inconclusive, beyond);
    }
  }
  return judgement;
}

Judgement apply(const Measurement& m, const Roundoff& c) {
  require_reason(c.reason);
  constexpr double standard_deviations = 4;
  const double limit =
      standard_deviations * std::numeric_limits<double>::epsilon() * std::sqrt(c.operations.value()) * c.scale.value();
  return capped(within(m, c.expected.value(), limit),
                {{"operations", c.operations}, {"scale", c.scale}, {"expected", c.expected}});
}

Judgement apply(const Measurement& m, const Bound& c) {
  require_reason(c.reason);
  const double limit = c.relative ? c.limit.value() * std::abs(c.expected.value()) : c.limit.value();
  return capped(within(m, c.expected.value(), limit), {{"limit", c.limit}, {"expected", c.expected}});
}

/// Beyond `useful` an uncertainty says nothing of agreement; a difference larger than the uncertainty is one, however
/// large that is. Where the numerical one was not estimated it is taken for the largest that decides anything.
Judgement apply(const Measurement& m, const Uncertainty& c) {
  require_reason(c.reason);
  // m.uncertainty is an expanded (95 %) half-width; the criterion combines standard uncertainties.
  const double numerical = m.uncertainty.value_or(0) / c.coverage;
  // Of three arguments the library's hypot loses a NaN beside zeros.
  const bool known = !(std::isnan(numerical) || std::isnan(c.input.value()) || std::isnan(c.data.value()));
  const double expanded = known ? c.coverage * std::hypot(numerical, c.input.value(), c.data.value())
                                : std::numeric_limits<double>::quiet_NaN();
  Measurement plain = m;
  plain.uncertainty.reset();
  Judgement j = within(plain, c.expected.value(), expanded);
  j.uncertainty = m.uncertainty;
  if (j.verdict == Verdict::error) return j;
  j = capped(std::move(j), {{"expected", c.expected}, {"data", c.data}, {"input", c.input}});
  if (!m.uncertainty) {
    const bool beyond = j.verdict == Verdict::fail && std::abs(m.value - c.expected.value()) > expanded + c.useful;
    if (!beyond) return unfit(std::move(j), Verdict::inconclusive, "its numerical uncertainty was not estimated");
    return unfit(std::move(j), Verdict::fail,
                 fmt::format("its numerical uncertainty was not estimated, but it is off by more than the {:.3g} of "
                             "data and inputs and the {:.3g} that is the most with which anything can be decided",
                             expanded, c.useful));
  }
  if (expanded <= c.useful || j.verdict == Verdict::fail) return j;
  return unfit(std::move(j), Verdict::inconclusive,
               fmt::format("the expanded uncertainty {:.3g} exceeds {:.3g}, the largest that still decides", expanded,
                           c.useful));
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

Criterion settled(const Criterion& criterion, const Told& told) {
  const auto settle = [](Amount& amount, const std::optional<double>& number, const char* name) {
    if (amount.stated() && number) {
      throw std::invalid_argument(fmt::format("criterion: {} is stated beforehand, the run must not tell it", name));
    }
    if (amount.stated()) return;
    if (!number) throw std::invalid_argument(fmt::format("criterion: the run did not tell {}", name));
    amount = amount.with(*number);
  };
  Criterion result = criterion;
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.expected.stated(); }) settle(c.expected, told.expected, "what is expected");
        if constexpr (requires { c.operations; }) settle(c.operations, told.operations, "the operations");
        if constexpr (requires { c.scale; }) settle(c.scale, told.scale, "the scale");
        if constexpr (requires { c.limit; }) settle(c.limit, told.limit, "the limit");
        if constexpr (requires { c.data; }) settle(c.data, told.data, "the uncertainty of the data");
        if constexpr (requires { c.input; }) settle(c.input, told.input, "the uncertainty of the input");
      },
      result);
  return result;
}

Judgement judge(const ObservedOrder& observed, const Order& criterion) {
  require_reason(criterion.reason);
  const bool broken =
      std::any_of(observed.errors.begin(), observed.errors.end(), [](double error) { return !std::isfinite(error); });
  Judgement j{.verdict = broken ? Verdict::error : Verdict::inconclusive,
              .measured = observed.order,
              .uncertainty = observed.half_width,
              .expected = criterion.theory,
              .limit = criterion.tolerance,
              .resolution = fmt::format("{} resolutions", observed.sizes.size()),
              .note = observed.note};
  if (broken) return j;
  const double distance = std::abs(observed.order - criterion.theory);
  if (distance <= criterion.tolerance && distance + observed.half_width < 1) {
    j.verdict = Verdict::pass;
    if (distance > observed.half_width)
      j.note = joined(j.note, "the interval excludes theory by less than the tolerance");
  } else if (distance - observed.half_width > criterion.tolerance) {
    j.verdict = Verdict::fail;
  }
  return j;
}

Judgement error(const std::string& what) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return {.verdict = Verdict::error, .measured = nothing, .expected = nothing, .limit = nothing, .note = what};
}

}  // namespace seiche::evidence
