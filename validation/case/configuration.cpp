#include "validation/case/configuration.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "seiche/io/hdf5_table.hpp"
#include "seiche/wording.hpp"
#include "validation/case/refusal.hpp"
#include "validation/case/registry.hpp"

namespace seiche::validation {
namespace {

Value value_of(const toml::node& node) {
  if (const auto v = node.value_exact<double>()) return *v;
  if (const auto v = node.value_exact<int64_t>()) return static_cast<long>(*v);
  if (const auto v = node.value_exact<bool>()) return *v;
  if (const auto v = node.value_exact<std::string>()) return *v;
  fail("must be a number, a text, true or false");
}

/// Keys and texts come from the file: a line break in one must not break the message.
[[noreturn]] void fail_at(const std::string& name, const toml::source_region& where, const std::string& what) {
  fail("{}", printable(fmt::format("{}: line {}: {}", name, where.begin.line, what)));
}

/// toml++ takes tables apart by recursion: keys of tens of thousands of dots end the process. Where there are many
/// dots, another one tries it first.
/// @throws std::invalid_argument
void require_shallow(std::string_view text, const std::string& name) {
  constexpr long few = 1000;
  if (std::count(text.begin(), text.end(), '.') <= few) return;
  try {
    io::isolated([&] { return toml::parse(text).empty() ? std::string("nothing") : std::string("something"); }, 10);
  } catch (const std::invalid_argument&) {  // a mistake that the parser names
  } catch (const std::runtime_error&) {
    fail("{}: its keys are nested too deeply", printable(name));
  }
}

void apply(const std::string& name, const toml::table& table, Values& values) {
  for (const auto& [key, node] : table) {
    if (node.is_table()) continue;
    try {
      values.set(key.str(), value_of(node));
    } catch (const std::invalid_argument& wrong) {
      const std::string message = wrong.what();
      const bool named = message.starts_with("parameter");
      fail_at(name, node.source(), named ? message : fmt::format("parameter {} {}", key.str(), message));
    }
  }
}

}  // namespace

void apply_configuration(std::string_view text, const std::string& name, const Case& one, Values& values) {
  require_shallow(text, name);
  toml::table table;
  try {
    table = toml::parse(text, name);
  } catch (const toml::parse_error& wrong) {
    fail_at(name, wrong.source(), std::string(wrong.description()));
  }
  for (const auto& [key, node] : table) {
    if (!node.is_table()) continue;
    try {
      find_case(key.str());  // an unknown table is a misspelt case
    } catch (const std::invalid_argument& unknown) {
      fail_at(name, node.source(), unknown.what());
    }
  }
  apply(name, table, values);
  if (const toml::table* own = table[one.name].as_table()) apply(name, *own, values);
}

}  // namespace seiche::validation
