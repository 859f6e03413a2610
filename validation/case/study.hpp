/// The three parts of a case: what it claims, what it computes, what it shows.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/checkpoints.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

/// What a running case sees: its parameters, a way to say how far it is, and what an interrupted run has left.
class Run : public Values {
 public:
  using Progress = std::function<void(double)>;

  Run(Values values, Progress progress,
      std::shared_ptr<const Checkpoints> checkpoints = std::make_shared<Checkpoints>())
      : Values(std::move(values)), progress_(std::move(progress)), checkpoints_(std::move(checkpoints)) {}

  /// Tells the user how much is done, 0 to 1.
  void progress(double fraction) const { progress_(fraction); }
  /// A part whose result is kept, by a name that no other part has.
  [[nodiscard]] Part part(std::string name) const { return {*checkpoints_, std::move(name)}; }

 private:
  Progress progress_;
  std::shared_ptr<const Checkpoints> checkpoints_;
};

/// The claims are a function of the parameters; computing knows no verdict; what is shown is drawn from the results.
class Study {
 public:
  Study() = default;

  /// @param declare  all claims with their criteria, before anything is computed
  /// @param compute  numbers and curves
  /// @param show     figures, tables and measurements
  /// @param source   of the claims that name no other
  template <class Results>
  Study(void (*declare)(const Values&, const Claims<Results>&), Results (*compute)(const Run&),
        void (*show)(const Results&, const Values&, evidence::Exhibit&), const std::string& source = {})
      : claims_([declare, source](const Values& values) {
          std::vector<DeclaredClaim> list;
          declare(values, Claims<Results>(list, source));
          return list;
        }),
        compute_([compute](const Run& run) -> Computed { return std::make_shared<const Results>(compute(run)); }),
        show_([show](const void* results, const Values& values, evidence::Exhibit& exhibit) {
          show(*static_cast<const Results*>(results), values, exhibit);
        }) {}

  /// @throws std::invalid_argument where parameters that are each in range do not go together
  [[nodiscard]] std::vector<DeclaredClaim> claims(const Values& values) const;

  /// Computes, judges every declared claim once, shows. Whatever breaks down leaves no claim without a verdict: what
  /// could not be measured is an error under its own name. @throws std::invalid_argument as claims() does, and where
  /// computing refuses parameters that the user has set
  void run(const Run& run, evidence::Record& record) const;

 private:
  using Computed = std::shared_ptr<const void>;

  std::function<std::vector<DeclaredClaim>(const Values&)> claims_;
  std::function<Computed(const Run&)> compute_;
  std::function<void(const void*, const Values&, evidence::Exhibit&)> show_;
};

/// Every claim of the list in error, for a run that could not measure them.
void fail_all(const std::vector<DeclaredClaim>& claims, const std::string& why, evidence::Record& record);

}  // namespace seiche::validation
