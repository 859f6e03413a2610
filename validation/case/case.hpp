/// What a validation case is.
///
/// A case is one file validation/<phenomenon>/<name>.cpp. It opens with a Markdown comment, the article that the report
/// prints, and defines one function `void <name>(Case& c)`, which fills the case in, in a namespace of its own,
/// seiche::validation::cases::<name>. The build finds the file, takes the article, and adds the case to the registry:
/// nothing else is to be edited.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/parameter.hpp"
#include "validation/case/study.hpp"
#include "validation/case/submission.hpp"
#include "validation/case/tier.hpp"

namespace seiche::validation {

struct Case {
  std::string title;
  std::string source;              ///< citation with figure, table or section
  std::vector<std::string> atlas;  ///< tiles that the case fills as a whole
  std::vector<Tier> tiers;         ///< in which it does something of its own; empty: tiers_of_defaults()
  std::vector<Parameter> parameters;
  std::vector<Published> published;  ///< the sources' own parameters, a set for every tile that the case fills
  ByTier<std::chrono::seconds> time_limit = {std::chrono::minutes(5), std::chrono::hours(1), std::chrono::hours(24)};
  Study study;                            ///< what it claims, computes and shows
  std::vector<std::string> former_names;  ///< which `seiche run` still understands
  Submission submission;                  ///< how somebody else's result is judged; empty if it cannot be

  // Filled in by the registry.
  std::string name;         ///< the file's name
  std::string phenomenon;   ///< the folder's name
  std::string article;      ///< the file's opening comment
  std::string fingerprint;  ///< of the code that decides its numbers, and of the toolchain

  /// The defaults of a tier.
  [[nodiscard]] Values values(Tier tier) const;
  /// The quick tier, and the full one where a parameter has another default there.
  [[nodiscard]] std::vector<Tier> tiers_of_defaults() const;
  /// The values of a published set.
  [[nodiscard]] Values values(const Published& set) const;
  /// The set that shows a tile. @throws std::invalid_argument listing the sets
  [[nodiscard]] const Published& published_set(std::string_view tile) const;
  /// Different values of all runs of a tier: its defaults, where the case does something of its own in it, and the
  /// published sets that run in it.
  [[nodiscard]] std::vector<Values> runs_of(Tier tier) const;
  /// @throws std::logic_error where a published set names no tile, a tile twice, or values that cannot be set
  void check_published() const;
};

}  // namespace seiche::validation
