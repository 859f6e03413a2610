/// What a case claims, declared before it runs.
///
///     void claims(const Values& values, const Claims<Results>& claims) {
///       claims.check("crest", "The crest keeps its height.", "loss of height [m]",
///                    [](const Results& r) -> Measurement { return {.value = r.crest, .resolution = r.resolution}; },
///                    evidence::Bound{.limit = 1e-3, .reason = "..."});
///       claims.from("Miles (1977)").check(...);          // another source than that of the case's study
///       claim_conservation(claims.of(&Results::flow));   // claims that several cases make of the same part
///       claims.of(&Results::waves).entry(k).check(...);  // about one of several
///       claims.only_if(values.as_published(), "the source prints it for its own parameters").check(...);
///       claims.at("N = 200").check(..., &Results::crest, ...);   // the resolution of several claims, said once
///       claims.at(&Results::resolution).where("t = {:g}").check(...);   // told by the run; the place of a Worst
///     }
///
/// The measurement of a claim is taken from the results by a function that is declared with it, or by a pointer to the
/// member of the results that holds it: a Measurement, an ObservedOrder, a Worst, a number, or whether something is so.
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

/// Adds a table without rows; the reference stays valid for the exhibit's life. @param columns  each with its unit in
/// brackets; @param tiles  of the atlas that the table fills
evidence::Table& add_table(evidence::Exhibit& exhibit, std::string id, std::string title, std::string caption,
                           const std::vector<std::string>& columns, std::vector<std::string> tiles = {});

/// Adds a figure of one panel; the reference stays valid for the exhibit's life.
evidence::Panel& add_panel(evidence::Exhibit& exhibit, const std::string& id, const std::string& title,
                           const std::string& caption, evidence::Axes axes, const std::vector<std::string>& tiles = {});

/// What stands in a table's row.
using Cell = std::variant<double, std::string>;
/// A number to 1/scale; nothing where it is none.
Cell rounded(double value, double scale = 1e4);

namespace detail {

inline DeclaredClaim::Measured as_measured(Measurement measurement, const std::string& /*where*/) {
  return measurement;
}
inline DeclaredClaim::Measured as_measured(evidence::ObservedOrder order, const std::string& /*where*/) {
  return order;
}
template <class Number>
requires std::is_arithmetic_v<Number> DeclaredClaim::Measured as_measured(Number value, const std::string& /*where*/) {
  return Measurement{.value = static_cast<double>(value)};
}
DeclaredClaim::Measured as_measured(const Worst& worst, const std::string& where);

}  // namespace detail

/// A list of claims of which all measurements are taken from a `Part` of the results. Copies add to the same list.
template <class Part>
class Claims {
 public:
  using Find = std::function<const Part&(const void* results)>;
  using Resolution = std::function<std::string(const void* results)>;
  /// What several claims have in common.
  struct Terms {
    std::string source;
    Resolution resolution = {};
    std::string where = {};  ///< format of the place of a Worst
    std::string left_out = {};
    std::optional<evidence::KnownFailure> failure = {};
  };

  /// A list for the whole results.
  explicit Claims(std::vector<DeclaredClaim>& list, std::string source = {})
      : Claims(list, [](const void* results) -> const Part& { return *static_cast<const Part*>(results); },
               {std::move(source)}) {}
  Claims(std::vector<DeclaredClaim>& list, Find find, Terms terms)
      : list_(&list), find_(std::move(find)), terms_(std::move(terms)) {}

  /// @param quantity  what is measured, with its unit in brackets unless that is 1: "run-up [depth]"
  template <class Measure>
  void check(std::string id, std::string text, const std::string& quantity, Measure measure,
             evidence::Criterion criterion) const {
    auto [name, unit] = name_and_unit(quantity);
    if (unit.empty()) unit = "1";
    check({std::move(id), std::move(text), std::move(name), std::move(unit), terms_.source}, std::move(measure),
          std::move(criterion));
  }
  /// A claim that names its source itself.
  template <class Measure>
  void check(evidence::Claim claim, Measure measure, evidence::Criterion criterion) const {
    list_->push_back({std::move(claim), std::move(criterion), terms_.failure, terms_.left_out,
                      [find = find_, measure = std::move(measure), terms = terms_](const void* results) {
                        DeclaredClaim::Measured measured =
                            detail::as_measured(std::invoke(measure, find(results)), terms.where);
                        auto* measurement = std::get_if<Measurement>(&measured);
                        if (measurement && measurement->resolution.empty() && terms.resolution) {
                          measurement->resolution = terms.resolution(results);
                        }
                        return measured;
                      }});
  }

  /// The same list for claims about a part of the results, a member or what a function of the results refers to.
  template <class Member>
  [[nodiscard]] auto of(Member member) const {
    using Found = std::remove_cvref_t<std::invoke_result_t<Member, const Part&>>;
    return Claims<Found>(
        *list_,
        [find = find_, member](const void* results) -> const Found& { return std::invoke(member, find(results)); },
        {terms_.source, terms_.resolution, terms_.where, terms_.left_out, terms_.failure});
  }

  /// The same list for claims about an entry of results that are a sequence.
  [[nodiscard]] auto entry(std::size_t k) const {
    return of([k](const Part& all) -> const auto& { return all.at(k); });
  }
  [[nodiscard]] auto last() const {
    return of([](const Part& all) -> const auto& { return all.back(); });
  }

  /// The same list for claims that apply under a condition on parameters. @param otherwise  why they do not apply
  [[nodiscard]] Claims only_if(bool applies, const std::string& otherwise) const {
    return with(&Terms::left_out, applies ? terms_.left_out : otherwise);
  }
  /// The same list for claims that the method is known not to meet. @param known  whether it is at these parameters
  [[nodiscard]] Claims fails(evidence::KnownFailure failure, bool known = true) const {
    return known ? with(&Terms::failure, std::optional(std::move(failure))) : *this;
  }
  /// The same list for measurements at a resolution that they need not name themselves.
  [[nodiscard]] Claims at(const std::string& resolution) const {
    return with(&Terms::resolution, Resolution([resolution](const void*) { return resolution; }));
  }
  /// The same with a resolution that the results tell.
  template <class Told>
  requires std::is_invocable_v<Told, const Part&>
  [[nodiscard]] Claims at(Told told) const {
    return with(&Terms::resolution,
                Resolution([find = find_, told](const void* results) { return std::invoke(told, find(results)); }));
  }
  /// The same list for measurements that are a Worst, whose place is told so: "t = {:g}".
  [[nodiscard]] Claims where(const std::string& format) const { return with(&Terms::where, format); }
  /// The same list for claims that come from a source of their own.
  [[nodiscard]] Claims from(const std::string& source) const { return with(&Terms::source, source); }

 private:
  template <class Term>
  [[nodiscard]] Claims with(Term Terms::*term, Term value) const {
    Claims other = *this;
    other.terms_.*term = std::move(value);
    return other;
  }

  std::vector<DeclaredClaim>* list_;
  Find find_;
  Terms terms_;
};

}  // namespace seiche::validation
