#include "validation/scoring/file_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "validation/case/refusal.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {

bool is_missing(double value) {
  return std::isnan(value) || std::abs(value) >= 1e20 || value == -999 || value == -9999 || value == -99999;
}

void FileColumns::fail(const Column& column, const std::string& what) const {
  validation::fail("{}: column {}: {}", file_.source, find(column).value_or(column.name), what);
}
void FileColumns::fail(const Column& column, std::size_t row, const std::string& what) const {
  validation::fail("{}: {}: column {}: {}", file_.source, file_.place(row), find(column).value_or(column.name), what);
}
void FileColumns::note(const std::string& what) const {
  const std::string sentence = file_.source + ": " + what;
  std::vector<std::string>& notes = understood_.notes;
  if (std::ranges::find(notes, sentence) == notes.end()) notes.push_back(sentence);
}

bool FileColumns::is_wanted(const std::string& name) const {
  const std::vector<Column> all = columns_of(wanted_);
  return std::ranges::find(all, name, &Column::name) != all.end();
}

const std::optional<std::string>& FileColumns::find(const Column& column) const {
  const auto [kept, fresh] = found_.try_emplace(column.name);
  if (fresh) kept->second = found(column);
  return kept->second;
}
std::optional<std::string> FileColumns::found(const Column& column) const {
  if (const auto given = understood_.renamed.find(column.name); given != understood_.renamed.end()) {
    return file_.has(given->second) ? std::optional(given->second) : std::nullopt;
  }
  if (file_.has(column.name)) return column.name;
  std::vector<std::string> others;
  for (const std::string& other : other_names(column.name)) {
    if (!others.empty() && (other == "hu" || other == "hv")) continue;  // a velocity is there as well
    for (const std::string& name : file_.names) {
      if (plain_name(name) == other && !is_wanted(name)) others.push_back(name);
    }
  }
  if (others.size() > 1) {
    fail(column, fmt::format("may be {}: say which by --map NAME={}", fmt::join(others, " or "), column.name));
  }
  if (!others.empty()) return others.front();
  const bool quantity = alone_ && understood_.gauges.empty() && wanted_.quantities.size() == 1 &&
                        column.name == wanted_.quantities.front().column.name;
  std::vector<std::string> left = quantity ? file_.names : std::vector<std::string>{};
  std::erase_if(left, [&](const std::string& name) { return means_another(name); });
  return left.size() == 1 ? std::optional(left.front()) : std::nullopt;
}

bool FileColumns::means_another(const std::string& name) const {
  if (is_wanted(name) || understood_.gauges.contains(name)) return true;
  return std::ranges::any_of(std::array{"t", "x", "y", "z", "eta", "h", "u", "v", "p"}, [&](const char* known) {
    const std::vector<std::string>& others = other_names(known);
    return name == known || std::ranges::find(others, plain_name(name)) != others.end();
  });
}

const std::vector<double>& FileColumns::values(const Column& column, const std::string& in_file) const {
  const auto renamed = understood_.renamed.find(column.name);
  const std::string name = !in_file.empty()                       ? in_file
                           : renamed == understood_.renamed.end() ? find(column).value_or(column.name)
                                                                  : renamed->second;
  const auto [kept, fresh] = converted_.emplace(name, std::vector<double>());
  if (!fresh) return kept->second;
  try {
    kept->second = file_.column(name);
  } catch (const std::invalid_argument& missing) {
    if (!wanted_.group || find(*wanted_.group)) throw;
    validation::fail("{}; say which hold a {}: --gauges NAME={:g},...", missing.what(), wanted_.group->name,
                     wanted_.groups->front());
  }
  std::vector<double>& result = kept->second;
  if (in_file.empty() && renamed == understood_.renamed.end() && name != column.name) {
    note(fmt::format("column {} is taken for {}", name, column.name));
  }
  const bool flux = (name == "hu" || name == "hv") && column.unit == "m/s" && file_.unit(name).empty();
  std::string unit = flux ? "m^2/s" : file_.unit(name);
  if (const auto epoch = epoch_of(unit); epoch && !result.empty()) {
    const double first = result.front() * conversion(epoch->unit, "s").value_or(1);
    unit = epoch->unit;
    constexpr double year = 366 * 86400.0;  // [s]; larger numbers count from somewhere else
    const double origin = first >= epoch->origin && first < epoch->origin + year ? epoch->origin : first;
    if (std::abs(first) > year) {
      for (double& value : result) value -= origin / conversion(unit, "s").value_or(1);
      note(fmt::format("column {}: counted from {:.10g} s on", name, origin));
    }
  }
  if (unit.empty()) return result;
  if (const auto factor = conversion(unit, column.unit)) {
    if (*factor == 1) return result;
    for (double& value : result) value = is_missing(value) ? value : value * *factor;
    note(fmt::format("column {}: {} became {}", name, unit, column.unit));
    return result;
  }
  const std::vector<double>* depth = file_.has("h") ? &file_.column("h") : nullptr;
  const auto factor = conversion(unit, column.unit + " m");
  if (!factor || depth == nullptr || depth->size() != result.size()) {
    converted_.erase(kept);
    fail(column, fmt::format("unit {}, must be {}, or another of the same kind", unit, column.unit));
  }
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k] = (*depth)[k] > 0 && !is_missing(result[k]) ? *factor * result[k] / (*depth)[k] : 0;
  }
  note(fmt::format("column {} was divided by the depth h", name));
  return result;
}

}  // namespace seiche::validation
