#include "validation/case/parameter.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/wording.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/case/refusal.hpp"

namespace seiche::validation {
namespace {

std::string to_text(const Value& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

[[noreturn]] void reject(const Parameter& parameter, std::string_view value) {
  fail("parameter {} = {} is not allowed: must be {}", parameter.name, value, parameter.range());
}

template <class T>
ByTier<Value> values_of(const ByTier<T>& standard) {
  return {standard.quick, standard.full, standard.paper};
}

template <class Number>
bool parse(const std::string& text, Number& number) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && end == text.data() + text.size();
}

/// Whether a value of the right type lies in the declared range.
bool allowed(const Parameter& parameter, const Value& value) {
  const auto inside = [&](double v) { return Range::within(parameter.lowest, parameter.highest).holds(v); };
  if (const auto* v = std::get_if<double>(&value)) return inside(*v);
  if (const auto* v = std::get_if<long>(&value)) return inside(static_cast<double>(*v));
  const auto* v = std::get_if<std::string>(&value);
  return v == nullptr || std::ranges::find(parameter.choices, *v) != parameter.choices.end();
}

}  // namespace

std::string Parameter::range() const {
  if (!choices.empty()) return fmt::format("one of {}", fmt::join(choices, ", "));
  if (std::holds_alternative<bool>(standard.quick)) return "true or false";
  const char* type = std::holds_alternative<long>(standard.quick) ? "an integer" : "a number";
  return fmt::format("{} in [{:g}, {:g}]{}{}", type, lowest, highest, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

Parameter real(std::string name, ByTier<double> standard, std::string unit, Range range, std::string meaning) {
  return {std::move(name), std::move(unit), std::move(meaning), values_of(standard), range.lowest, range.highest};
}

Parameter integer(std::string name, ByTier<long> standard, Range range, std::string meaning) {
  return {std::move(name), "1", std::move(meaning), values_of(standard), range.lowest, range.highest};
}

Parameter choice(std::string name, ByTier<std::string> standard, std::vector<std::string> choices,
                 std::string meaning) {
  return {std::move(name), "1", std::move(meaning), values_of(standard), 0, 0, std::move(choices)};
}

Parameter choice(std::string name, const char* standard, std::vector<std::string> choices, std::string meaning) {
  return choice(std::move(name), std::string(standard), std::move(choices), std::move(meaning));
}

Parameter toggle(std::string name, ByTier<bool> standard, std::string meaning) {
  return {std::move(name), "1", std::move(meaning), values_of(standard)};
}

bool Published::shows(std::string_view tile) const {
  return std::ranges::find(tiles, tile) != tiles.end();
}

std::string Published::origin(const std::string& parameter) const {
  if (different.count(parameter) == 1) return "different";
  return std::ranges::find(stated, parameter) == stated.end() ? "chosen" : "stated";
}

Values::Values(std::vector<Parameter> declared, Tier tier, Sets sets)
    : declared_(std::move(declared)),
      tier_(tier),
      sets_(sets ? std::move(sets) : std::make_shared<const std::vector<Published>>()) {
  for (const Parameter& parameter : declared_) values_[parameter.name] = parameter.standard.at(tier);
}

Values::Values(std::vector<Parameter> declared, const Published& set, Sets sets)
    : Values(std::move(declared), set.tier, std::move(sets)) {
  for (const auto& [name, value] : set.values) this->set(name, value);
}

const Parameter& Values::find(std::string_view name) const {
  const std::string_view now = name == "beyond_folds" ? "beyond_tangling"  // names in version 0.1
                               : name == "judged_to"  ? "scored_to"
                                                      : name;
  const auto found = std::ranges::find(declared_, now, &Parameter::name);
  if (found != declared_.end()) return *found;
  std::vector<std::string> names;
  for (const Parameter& p : declared_) names.push_back(p.name);
  fail("parameter {} is unknown{} must be one of {}", name, did_you_mean(name, names), fmt::join(names, ", "));
}

void Values::set(std::string_view name, const std::string& text) {
  const Parameter& parameter = find(name);
  Value value = parameter.standard.quick;
  bool understood = true;
  if (auto* number = std::get_if<double>(&value)) {
    understood = parse(text, *number);
  } else if (auto* whole = std::get_if<long>(&value)) {
    understood = parse(text, *whole);
  } else if (auto* flag = std::get_if<bool>(&value)) {
    understood = text == "true" || text == "false";
    *flag = text == "true";
  } else {
    value = text;
  }
  if (!understood || !allowed(parameter, value)) reject(parameter, text.empty() ? "(empty)" : text);
  values_.find(parameter.name)->second = value;
}

void Values::set(std::string_view name, const Value& value) {
  const Parameter& parameter = find(name);
  Value converted = value;
  const auto* whole = std::get_if<long>(&value);
  if (whole != nullptr && std::holds_alternative<double>(parameter.standard.quick)) {
    converted = static_cast<double>(*whole);
  }
  if (converted.index() != parameter.standard.quick.index() || !allowed(parameter, converted)) {
    reject(parameter, to_text(value));
  }
  values_.find(parameter.name)->second = converted;
}

template <class T>
const T& Values::get(std::string_view name) const {
  const auto found = values_.find(name);
  const T* value = found == values_.end() ? nullptr : std::get_if<T>(&found->second);
  if (value == nullptr) throw std::logic_error(fmt::format("case uses parameter {} that it does not declare so", name));
  return *value;
}

template const double& Values::get<double>(std::string_view) const;
template const long& Values::get<long>(std::string_view) const;
template const bool& Values::get<bool>(std::string_view) const;
template const std::string& Values::get<std::string>(std::string_view) const;

std::string Values::canonical() const {
  std::string text;
  for (const auto& [name, value] : values_) text += name + "=" + to_text(value) + "\n";
  return text;
}

bool Values::are(const Published& set) const {
  return tier_ >= set.tier && canonical() == Values(declared_, set, sets_).canonical();
}

bool Values::are(const NamedValues& settings) const {
  Values other = *this;
  for (const auto& [name, value] : settings) other.set(name, value);
  return canonical() == other.canonical();
}

bool Values::as_published(std::string_view tile) const {
  const auto found = std::ranges::find_if(*sets_, [&](const Published& set) { return set.shows(tile); });
  if (found == sets_->end())
    throw std::logic_error(fmt::format("no as-published set of the case shows figure {}", tile));
  return are(*found);
}

std::string Values::set_name() const {
  if (standard()) return {};
  const auto found = std::ranges::find_if(*sets_, [&](const Published& set) { return set.tier == tier_ && are(set); });
  return found == sets_->end() ? "" : found->name();
}

io::Table Values::table(const std::string& source) const {
  return reference_table(source, *tables_read_);
}

}  // namespace seiche::validation
