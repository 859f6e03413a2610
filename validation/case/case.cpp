#include "validation/case/case.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/refusal.hpp"

namespace seiche::validation {

Values Case::values(Tier tier) const {
  return Values(parameters, tier, std::make_shared<const std::vector<Published>>(published));
}

Values Case::values(const Published& set) const {
  return Values(parameters, set, std::make_shared<const std::vector<Published>>(published));
}

std::vector<Tier> Case::tiers_of_defaults() const {
  if (values(Tier::quick).canonical() == values(Tier::full).canonical()) return {Tier::quick};
  return {Tier::quick, Tier::full};
}

const Published& Case::published_set(std::string_view tile) const {
  const auto found = std::ranges::find_if(published, [&](const Published& set) { return set.shows(tile); });
  if (found != published.end()) return *found;
  std::vector<std::string> tiles;
  for (const Published& set : published) tiles.insert(tiles.end(), set.tiles.begin(), set.tiles.end());
  if (tiles.empty()) fail("{} has no as-published set {}: it has none", name, tile);
  fail("{} has no as-published set {}: must be one of {}", name, tile, fmt::join(tiles, ", "));
}

std::vector<Values> Case::runs_of(Tier tier) const {
  std::vector<Values> runs;
  const auto add = [&](Values run) {
    const bool known = std::ranges::find(runs, run.canonical(), &Values::canonical) != runs.end();
    if (!known) runs.push_back(std::move(run));
  };
  if (std::ranges::find(tiers, tier) != tiers.end()) add(values(tier));
  for (const Published& set : published) {
    if (set.tier == tier) add(values(set));
  }
  return runs;
}

void Case::check_published() const {
  std::set<std::string> tiles;
  for (const Published& set : published) {
    if (set.tiles.empty()) throw std::logic_error(fmt::format("{}: an as-published set names no figure", name));
    for (const std::string& tile : set.tiles) {
      if (!tiles.insert(tile).second)
        throw std::logic_error(fmt::format("{}: figure {} has two as-published sets", name, tile));
    }
    std::vector<std::string> named = set.stated;
    for (const auto& [parameter, theirs] : set.different) named.push_back(parameter);
    for (const std::string& parameter : named) {
      if (std::ranges::find(parameters, parameter, &Parameter::name) != parameters.end()) continue;
      throw std::logic_error(fmt::format("{}: as-published set {} names no parameter {}", name, set.name(), parameter));
    }
    try {
      static_cast<void>(values(set));
    } catch (const std::invalid_argument& wrong) {
      throw std::logic_error(fmt::format("{}: as-published set {}: {}", name, set.name(), wrong.what()));
    }
  }
}

}  // namespace seiche::validation
