#pragma once

#include <array>
#include <string_view>

namespace seiche::validation {

/// How much a run may cost: quick is seconds per case, full within an hour for all on two cores, paper the resolutions
/// of the sources and beyond.
enum class Tier { quick, full, paper };

inline constexpr std::array tier_names{std::string_view("quick"), std::string_view("full"), std::string_view("paper")};

constexpr std::string_view name(Tier tier) {
  return tier_names.at(static_cast<std::size_t>(tier));
}

/// A value that may differ from tier to tier; one value serves all.
template <class T>
struct ByTier {
  T quick;
  T full;
  T paper;

  ByTier(T all)
      : quick(all), full(all), paper(std::move(all)) {}  // NOLINT(google-explicit-constructor): reads as the value
  ByTier(T for_quick, T for_full, T for_paper)
      : quick(std::move(for_quick)), full(std::move(for_full)), paper(std::move(for_paper)) {}

  [[nodiscard]] const T& at(Tier tier) const { return tier == Tier::quick ? quick : tier == Tier::full ? full : paper; }
};

}  // namespace seiche::validation
