#include "validation/command/settings.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "validation/case/registry.hpp"

namespace seiche::command {
namespace {

validation::Value value_of(const std::string& file, const std::string& key, const toml::node& node) {
  if (const auto v = node.value_exact<double>()) return *v;
  if (const auto v = node.value_exact<int64_t>()) return static_cast<long>(*v);
  if (const auto v = node.value_exact<bool>()) return *v;
  if (const auto v = node.value_exact<std::string>()) return *v;
  throw std::invalid_argument(fmt::format("{}: line {}: parameter {} must be a number, a text, true or false", file,
                                          node.source().begin.line, key));
}

void apply(const std::string& file, const toml::table& table, validation::Values& values) {
  for (const auto& [key, node] : table) {
    if (node.is_table()) continue;
    try {
      values.set(key.str(), value_of(file, std::string(key.str()), node));
    } catch (const std::invalid_argument& wrong) {
      throw std::invalid_argument(fmt::format("{}: line {}: {}", file, node.source().begin.line, wrong.what()));
    }
  }
}

void apply_file(const std::filesystem::path& config, const validation::Case& one, validation::Values& values) {
  const std::string file = config.string();
  toml::table table;
  try {
    table = toml::parse_file(file);
  } catch (const toml::parse_error& wrong) {
    throw std::invalid_argument(fmt::format("{}: line {}: {}", file, wrong.source().begin.line, wrong.description()));
  }
  for (const auto& [key, node] : table) {
    if (node.is_table()) validation::find_case(key.str());  // an unknown table is a misspelt case
  }
  apply(file, table, values);
  if (const toml::table* own = table[one.name].as_table()) apply(file, *own, values);
}

}  // namespace

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument(fmt::format("--set {}: must be name=value", text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

validation::Values values_for(const validation::Case& one, validation::Tier tier, const std::filesystem::path& config,
                              const std::vector<std::string>& settings) {
  validation::Values values(one.parameters, tier);
  try {
    if (!config.empty()) apply_file(config, one, values);
    for (const std::string& setting : settings) {
      const auto [name, value] = split_setting(setting);
      values.set(name, value);
    }
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", one.name, wrong.what()));
  }
  return values;
}

}  // namespace seiche::command
