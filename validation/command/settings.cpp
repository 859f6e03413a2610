#include "validation/command/settings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ranges>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/io/atomic_file.hpp"
#include "validation/case/configuration.hpp"

namespace seiche::command {
validation::Tier tier_from(const std::string& text) {
  using validation::Tier;
  for (const Tier tier : {Tier::quick, Tier::full, Tier::paper}) {
    if (name(tier) == text) return tier;
  }
  fail("--tier {} is unknown: must be one of quick, full, paper", text);
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (const auto part : std::views::split(text, separator)) parts.emplace_back(part.begin(), part.end());
  if (parts.empty()) parts.emplace_back();
  return parts;
}

std::vector<std::pair<std::string, std::string>> split_settings(const std::string& option,
                                                                const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& text : texts) {
    for (const std::string& one : parts_of(text, ',')) {
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos || equals == 0) fail("{} {}: '{}' must be name=value", option, text, one);
      pairs.emplace_back(one.substr(0, equals), one.substr(equals + 1));
    }
  }
  return pairs;
}

double number(const std::string& what, std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || std::isnan(value))
    fail("{} = {} is not a number", what, text);
  return value;
}

double finite_number(const std::string& what, std::string_view text) {
  const double value = number(what, text);
  if (!std::isfinite(value)) fail("{} = {} must be finite", what, text);
  return value;
}

namespace {

/// Changes the values of a case; what is wrong with that is said of the case.
validation::Values changed(const validation::Case& one, validation::Values values, const std::filesystem::path& config,
                           const std::vector<std::string>& settings) {
  try {
    if (!config.empty()) {
      if (!std::filesystem::is_regular_file(config)) fail("{}: cannot be read as a file", config.string());
      validation::apply_configuration(io::read_file(config), config.string(), one, values);
    }
    for (const auto& [name, value] : split_settings("--set", settings)) values.set(name, value);
  } catch (const std::invalid_argument& wrong) {
    fail("{}: {}", one.name, wrong.what());
  }
  return values;
}

}  // namespace

validation::Values values_for(const validation::Case& one, validation::Tier tier, const std::filesystem::path& config,
                              const std::vector<std::string>& settings) {
  return changed(one, one.values(tier), config, settings);
}

validation::Values published_values(const validation::Case& one, const std::string& set,
                                    const std::vector<std::string>& settings) {
  const validation::Published& published = one.published_set(set);
  validation::Values values = changed(one, one.values(published), {}, settings);
  if (values.are(published)) return values;
  fail("{}: --set changes the as-published set {}; give either --set or --as", one.name, set);
}

}  // namespace seiche::command
