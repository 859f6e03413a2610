/// What cases share that show an exact solution and judge others by it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/exact/reference_solution.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"
#include "validation/case/study.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// One claim per identity of the solution that a case stands on. @param declared  the same, for names and limits
void claim_identities(const Claims<exact::SelfTest>& claims, const exact::SelfTest& declared);

/// An exact solution and its identities.
template <class Solution>
struct ExactResults {
  Solution solution;
  exact::SelfTest identities;
};
/// The study of a case that shows an exact solution, claims its identities, and scores others by it.
/// @tparam make  Solution (const Values&); @tparam show  void (const Solution&, const Values&, evidence::Exhibit&)
template <auto make, auto show>
Study exact_study(const std::string& source) {
  using Results = ExactResults<decltype(make(std::declval<const Values&>()))>;
  return Study(
      +[](const Values& values, const Claims<Results>& claims) {
        claim_identities(claims.of(&Results::identities), make(values).self_test());
      },
      +[](const Run& run) {
        const auto solution = make(run);
        return Results{solution, solution.self_test()};
      },
      +[](const Results& r, const Values& values, evidence::Exhibit& exhibit) { show(r.solution, values, exhibit); },
      source);
}

/// What is expected of a number whose reference is computed when it is first asked for.
Amount to_be_told();

/// "tolerance": the relative error that still passes a submitted result.
Parameter tolerance_parameter();

/// A measure that must be within the tolerance of zero (errors) or, with `expected` given, of that relative to it.
Requirement within_tolerance(Measure measure, const Values& values, const std::string& text, const std::string& source,
                             double expected = 0);

/// A number that must be the reference's, to the tolerance.
WantedQuantity wanted_number(const Column& column, double reference, const Values& values, const std::string& text,
                             const std::string& source);

/// The same of a number that takes long: it is computed when it is first asked for, and kept.
WantedQuantity wanted_number(const Column& column, std::function<double()> reference, const Values& values,
                             const std::string& text, const std::string& source);

/// `count` numbers from first to last, both included.
std::vector<double> evenly(double first, double last, int count);

}  // namespace seiche::validation
