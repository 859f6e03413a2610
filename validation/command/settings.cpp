#include "validation/command/settings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
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
  throw std::invalid_argument(fmt::format("--tier {} is unknown: must be one of quick, full, paper", text));
}

std::vector<std::pair<std::string, std::string>> split_settings(const std::string& option,
                                                                const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& text : texts) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t comma = std::min(text.find(',', begin), text.size());
      const std::string one = text.substr(begin, comma - begin);
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos || equals == 0) {
        throw std::invalid_argument(fmt::format("{} {}: '{}' must be name=value", option, text, one));
      }
      pairs.emplace_back(one.substr(0, equals), one.substr(equals + 1));
      begin = comma + 1;
    }
  }
  return pairs;
}

double number(const std::string& what, std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || std::isnan(value)) {
    throw std::invalid_argument(fmt::format("{} = {} is not a number", what, text));
  }
  return value;
}

double finite_number(const std::string& what, std::string_view text) {
  const double value = number(what, text);
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("{} = {} must be finite", what, text));
  return value;
}

validation::Values values_for(const validation::Case& one, validation::Tier tier, const std::filesystem::path& config,
                              const std::vector<std::string>& settings) {
  validation::Values values = one.values(tier);
  try {
    if (!config.empty()) {
      if (!std::filesystem::is_regular_file(config)) {
        throw std::invalid_argument(fmt::format("{}: cannot be read as a file", config.string()));
      }
      validation::apply_configuration(io::read_file(config), config.string(), one, values);
    }
    for (const auto& [name, value] : split_settings("--set", settings)) values.set(name, value);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", one.name, wrong.what()));
  }
  return values;
}

validation::Values published_values(const validation::Case& one, const std::string& set,
                                    const std::vector<std::string>& settings) {
  const validation::Published& published = one.published_set(set);
  validation::Values values = one.values(published);
  try {
    for (const auto& [name, value] : split_settings("--set", settings)) values.set(name, value);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", one.name, wrong.what()));
  }
  if (!values.are(published)) {
    throw std::invalid_argument(
        fmt::format("{}: --set changes the as-published set {}; give either --set or --as", one.name, set));
  }
  return values;
}

}  // namespace seiche::command
