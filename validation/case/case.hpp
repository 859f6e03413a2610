/// What a validation case is.
///
/// A case is one file validation/<phenomenon>/<name>.cpp. It opens with a Markdown comment, the article that the report
/// prints, and defines one function `Case <name>()` in namespace seiche::validation::cases. The build finds the file,
/// takes the article, and adds the case to the registry: nothing else is to be edited.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/parameter.hpp"
#include "validation/case/submission.hpp"
#include "validation/case/tier.hpp"

namespace seiche::validation {

/// What a running case sees: its parameters, the record it writes, and a way to say how far it is.
class Run {
 public:
  using Progress = std::function<void(double)>;

  Run(Values values, Progress progress) : values_(std::move(values)), progress_(std::move(progress)) {}

  [[nodiscard]] double real(std::string_view name) const { return values_.real(name); }
  [[nodiscard]] long integer(std::string_view name) const { return values_.integer(name); }
  [[nodiscard]] bool toggle(std::string_view name) const { return values_.toggle(name); }
  [[nodiscard]] const std::string& text(std::string_view name) const { return values_.text(name); }
  [[nodiscard]] Tier tier() const { return values_.tier(); }
  [[nodiscard]] const Values& values() const { return values_; }

  /// Whether every parameter has its quick default, which is the publication's own where there is one.
  [[nodiscard]] bool as_published() const {
    return values_.canonical() == Values(values_.declared(), Tier::quick).canonical();
  }

  /// Tells the user how much is done, 0 to 1.
  void progress(double fraction) const { progress_(fraction); }

  evidence::Record record;

 private:
  Values values_;
  Progress progress_;
};

struct Case {
  std::string title;
  std::string source;                       ///< citation with figure, table or section
  std::vector<std::string> atlas;           ///< tiles that the case fills as a whole
  std::vector<Tier> tiers = {Tier::quick};  ///< tiers in which it does something of its own
  std::vector<Parameter> parameters;
  ByTier<std::chrono::seconds> time_limit = {std::chrono::minutes(5), std::chrono::hours(1), std::chrono::hours(24)};
  std::function<void(Run&)> run;
  Submission submission;  ///< how somebody else's result is judged; empty if it cannot be

  // Filled in by the registry.
  std::string name;         ///< the file's name
  std::string phenomenon;   ///< the folder's name
  std::string article;      ///< the file's opening comment
  std::string fingerprint;  ///< of the code that decides its numbers, and of the toolchain
};

}  // namespace seiche::validation
