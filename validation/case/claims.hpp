/// What a case claims, declared before it runs.
///
///     void claims(const Values& values, const Claims<Results>& claims) {
///       claims.check("crest", "The crest keeps its height.", "loss of height [m]",
///                    [](const Results& r) -> Measurement { return {.value = r.crest, .resolution = r.resolution}; },
///                    evidence::Bound{.limit = 1e-3, .reason = "..."});
///       claims.from("Miles (1977)").check(...);          // another source than that of the case's study
///       claim_conservation(claims.of(&Results::flow));   // claims that several cases make of the same part
///       claims.only_if(values.as_published(), "the source prints it for its own parameters").check(...);
///       claims.at("N = 200").check(..., &Results::crest, ...);   // the resolution of several claims, said once
///     }
///
/// The measurement of a claim is taken from the results by a function that is declared with it, or by a pointer to the
/// member of the results that holds it: a Measurement, an ObservedOrder, a Worst or a number.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

using evidence::Amount;
using evidence::Bound;
using evidence::Measurement;
using evidence::Order;
using evidence::Qualitative;
using evidence::Role;
using evidence::Roundoff;
using evidence::Uncertainty;

/// A claim with its criterion, and how its measurement is taken from results of a type that only the case knows.
struct DeclaredClaim {
  using Measured = std::variant<Measurement, evidence::ObservedOrder>;

  evidence::Claim claim;
  evidence::Criterion criterion;
  std::optional<evidence::KnownFailure> known_failure;
  std::string left_out;  ///< why it does not apply at these parameters; empty if it does
  std::function<Measured(const void* results)> measured;
};

/// "run-up [depth]" as "run-up" and "depth"; the unit is empty where no brackets end the text.
std::pair<std::string, std::string> name_and_unit(const std::string& text);

/// The columns of a table, each with its unit in brackets.
std::vector<std::pair<std::string, std::string>> table_columns(const std::vector<std::string>& columns);

namespace detail {

inline DeclaredClaim::Measured as_measured(Measurement measurement, const std::string& resolution) {
  if (measurement.resolution.empty()) measurement.resolution = resolution;
  return measurement;
}
inline DeclaredClaim::Measured as_measured(evidence::ObservedOrder order, const std::string& /*resolution*/) {
  return order;
}
inline DeclaredClaim::Measured as_measured(double value, const std::string& resolution) {
  return Measurement{.value = value, .resolution = resolution};
}
inline DeclaredClaim::Measured as_measured(const Worst& worst, const std::string& resolution) {
  return Measurement{.value = worst.value(), .resolution = resolution};
}

}  // namespace detail

/// A list of claims of which all measurements are taken from a `Part` of the results. Copies add to the same list.
template <class Part>
class Claims {
 public:
  using Find = std::function<const Part&(const void* results)>;

  /// A list for the whole results.
  explicit Claims(std::vector<DeclaredClaim>& list, std::string source = {})
      : Claims(
            list, [](const void* results) -> const Part& { return *static_cast<const Part*>(results); }, {}, {},
            std::move(source)) {}
  Claims(std::vector<DeclaredClaim>& list, Find find, std::string left_out, std::string resolution, std::string source)
      : list_(&list),
        find_(std::move(find)),
        left_out_(std::move(left_out)),
        resolution_(std::move(resolution)),
        source_(std::move(source)) {}

  /// @param quantity  what is measured, with its unit in brackets unless that is 1: "run-up [depth]"
  template <class Measure>
  void check(std::string id, std::string text, const std::string& quantity, Measure measure,
             evidence::Criterion criterion) const {
    add(claim(std::move(id), std::move(text), quantity), std::move(measure), std::move(criterion), {});
  }
  /// A claim that the method is known not to meet.
  template <class Measure>
  void known_failure(std::string id, std::string text, const std::string& quantity, Measure measure,
                     evidence::Criterion criterion, evidence::KnownFailure failure) const {
    add(claim(std::move(id), std::move(text), quantity), std::move(measure), std::move(criterion), std::move(failure));
  }

  template <class Measure>
  void check(evidence::Claim claim, Measure measure, evidence::Criterion criterion) const {
    add(std::move(claim), std::move(measure), std::move(criterion), {});
  }

  template <class Measure>
  void known_failure(evidence::Claim claim, Measure measure, evidence::Criterion criterion,
                     evidence::KnownFailure failure) const {
    add(std::move(claim), std::move(measure), std::move(criterion), std::move(failure));
  }

  /// The same list for claims about a part of the results, a member or what a function of the results refers to.
  template <class Member>
  [[nodiscard]] auto of(Member member) const {
    using Found = std::remove_cvref_t<std::invoke_result_t<Member, const Part&>>;
    return Claims<Found>(
        *list_,
        [find = find_, member](const void* results) -> const Found& { return std::invoke(member, find(results)); },
        left_out_, resolution_, source_);
  }

  /// The same list for claims that apply under a condition on parameters. @param otherwise  why they do not apply
  [[nodiscard]] Claims only_if(bool applies, const std::string& otherwise) const {
    return Claims(*list_, find_, applies ? left_out_ : otherwise, resolution_, source_);
  }

  /// The same list for measurements at a resolution that they need not name themselves.
  [[nodiscard]] Claims at(const std::string& resolution) const {
    return Claims(*list_, find_, left_out_, resolution, source_);
  }

  /// The same list for claims that come from a source of their own.
  [[nodiscard]] Claims from(const std::string& source) const {
    return Claims(*list_, find_, left_out_, resolution_, source);
  }

 private:
  [[nodiscard]] evidence::Claim claim(std::string id, std::string text, const std::string& quantity) const {
    auto [name, unit] = name_and_unit(quantity);
    return {std::move(id), std::move(text), std::move(name), unit.empty() ? "1" : std::move(unit), source_};
  }

  template <class Measure>
  void add(evidence::Claim claim, Measure measure, evidence::Criterion criterion,
           std::optional<evidence::KnownFailure> failure) const {
    list_->push_back({std::move(claim), std::move(criterion), std::move(failure), left_out_,
                      [find = find_, measure = std::move(measure), resolution = resolution_](const void* results) {
                        return detail::as_measured(std::invoke(measure, find(results)), resolution);
                      }});
  }

  std::vector<DeclaredClaim>* list_;
  Find find_;
  std::string left_out_;
  std::string resolution_;
  std::string source_;
};

}  // namespace seiche::validation
