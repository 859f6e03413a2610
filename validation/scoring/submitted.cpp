#include "validation/scoring/submitted.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/samples.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

/// Units that are written differently and mean the same: blanks, ** for ^, nothing or - for 1.
std::string plain_unit(const std::string& unit) {
  std::string plain;
  for (const char c : unit) {
    if (c == ' ') continue;
    if (c == '*' && plain.ends_with('*')) {
      plain.back() = '^';
    } else {
      plain += c;
    }
  }
  return plain.empty() || plain == "-" ? "1" : plain;
}

/// One wanted table in one file, by the names of both.
class Reader {
 public:
  Reader(const io::Table& file, const WantedTable& wanted, const ColumnNames& renamed)
      : file_(file), wanted_(wanted), renamed_(renamed) {}

  [[nodiscard]] std::vector<SubmittedGroup> groups() const {
    for (const Column& column : columns_of(wanted_)) check(column);
    std::vector<SubmittedGroup> result;
    if (!wanted_.group) {
      result.push_back(group(0, [](std::size_t) { return true; }));
      return result;
    }
    const std::vector<double>& given = values(*wanted_.group);
    const double scale = worst(*wanted_.groups);
    for (const double g : *wanted_.groups) {
      const auto belongs = [&](std::size_t row) { return std::abs(given[row] - g) <= 1e-6 * scale; };
      result.push_back(group(g, belongs));
    }
    return result;
  }

 private:
  [[nodiscard]] const std::string& name(const Column& column) const {
    const auto found = renamed_.find(column.name);
    return found == renamed_.end() ? column.name : found->second;
  }
  [[nodiscard]] const std::vector<double>& values(const Column& column) const { return file_.column(name(column)); }
  [[nodiscard]] std::size_t rows() const { return values(wanted_.quantities.front().column).size(); }

  [[noreturn]] void fail(const Column& column, const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}: column {}: {}", file_.source, name(column), what));
  }
  [[noreturn]] void fail(const Column& column, std::size_t row, const std::string& what) const {
    throw std::invalid_argument(
        fmt::format("{}: {}: column {}: {}", file_.source, file_.place(row), name(column), what));
  }

  void check(const Column& column) const {
    const std::size_t length = values(column).size();
    if (length == 0) fail(column, "no values");
    if (length != rows()) {
      fail(column, fmt::format("{} values, must be as many as in column {}: {}", length,
                               name(wanted_.quantities.front().column), rows()));
    }
    const std::string& unit = file_.unit(name(column));
    if (!unit.empty() && plain_unit(unit) != plain_unit(column.unit)) {
      fail(column, fmt::format("unit {}, must be {}", unit, column.unit));
    }
  }

  /// What rows that should be of one gauge or instant differ in, where the file says.
  [[nodiscard]] std::string several(const std::vector<std::size_t>& chosen) const {
    for (const char* name : {"t", "x", "y", "z"}) {
      const bool asked = (wanted_.group && this->name(*wanted_.group) == name) || this->name(*wanted_.abscissa) == name;
      if (asked || !file_.has(name)) continue;
      const std::vector<double>& at = file_.column(name);
      const double first = at[chosen.front()];
      for (const std::size_t row : chosen) {
        if (at[row] == first) continue;
        return fmt::format(": holds {} = {:g} and {:g}, and one alone is asked for", name, first, at[row]);
      }
    }
    return {};
  }

  template <class Belongs>
  [[nodiscard]] SubmittedGroup group(double value, Belongs belongs) const {
    std::vector<std::size_t> chosen;
    for (std::size_t row = 0; row < rows(); ++row) {
      if (belongs(row)) chosen.push_back(row);
    }
    const bool single = wanted_.kind == WantedTable::Kind::scalars;
    const Column& first = wanted_.group ? *wanted_.group : wanted_.quantities.front().column;
    const std::string where =
        wanted_.group ? fmt::format(" for {} = {:g}{}", first.name, value, after_number(first.unit)) : "";
    if (single ? chosen.size() != 1 : chosen.size() < 2) {
      fail(first, fmt::format("{} rows{}, must be {}", chosen.size(), where, single ? "exactly one" : "at least two"));
    }
    SubmittedGroup result;
    result.value = value;
    for (const WantedQuantity& q : wanted_.quantities) {
      for (const std::size_t row : chosen) result.values[q.column.name].push_back(values(q.column)[row]);
    }
    if (!wanted_.abscissa) return result;
    for (const std::size_t row : chosen) {
      const double x = values(*wanted_.abscissa)[row];
      if (!result.abscissa.empty() && !(x > result.abscissa.back())) {
        fail(*wanted_.abscissa, row,
             fmt::format("{:g} follows {:g}{}, must increase{}", x, result.abscissa.back(), where, several(chosen)));
      }
      result.abscissa.push_back(x);
    }
    return result;
  }

  const io::Table& file_;
  const WantedTable& wanted_;
  const ColumnNames& renamed_;
};

}  // namespace

std::vector<Column> columns_of(const WantedTable& wanted) {
  std::vector<Column> columns;
  if (wanted.group) columns.push_back(*wanted.group);
  if (wanted.abscissa) columns.push_back(*wanted.abscissa);
  for (const WantedQuantity& q : wanted.quantities) columns.push_back(q.column);
  return columns;
}

std::vector<std::string> names_in_files(const std::vector<WantedTable>& wanted, const ColumnNames& renamed) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) {
    for (const Column& column : columns_of(table)) {
      const auto found = renamed.find(column.name);
      names.push_back(found == renamed.end() ? column.name : found->second);
    }
  }
  return names;
}

Submitted submitted_from(const std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                         const ColumnNames& renamed) {
  Submitted submitted;
  for (const WantedTable& table : wanted) {
    const auto has_some = [&](const io::Table& file) {
      return std::any_of(table.quantities.begin(), table.quantities.end(), [&](const WantedQuantity& q) {
        const auto found = renamed.find(q.column.name);
        return file.has(found == renamed.end() ? q.column.name : found->second);
      });
    };
    const auto first = std::find_if(files.begin(), files.end(), has_some);
    if (first == files.end()) continue;
    const auto second = std::find_if(first + 1, files.end(), has_some);
    if (second != files.end()) {
      throw std::invalid_argument(
          fmt::format("{}: holds the table {}, which {} holds as well", second->source, table.name, first->source));
    }
    submitted[table.name] = Reader(*first, table, renamed).groups();
  }
  // Says which column of the first table is missing, or why it cannot be used.
  if (submitted.empty()) submitted[wanted.front().name] = Reader(files.front(), wanted.front(), renamed).groups();
  return submitted;
}

std::string template_of(const WantedTable& wanted, const std::string& opening) {
  std::string text = opening;
  std::vector<std::string> header;
  for (const Column& column : columns_of(wanted)) {
    text += fmt::format("# {}: {} [{}]\n", column.name, column.meaning, column.unit);
    header.push_back(fmt::format("{} [{}]", column.name, column.unit));
  }
  for (const std::string& command : *wanted.exact) text += fmt::format("# the reference: {}\n", command);
  text += fmt::format("{}\n", fmt::join(header, ","));
  const std::string blanks(wanted.quantities.size() - (wanted.abscissa ? 0 : 1), ',');
  for (const double g : wanted.group ? *wanted.groups : std::vector<double>{0}) {
    const std::string group = wanted.group ? fmt::format("{:.17g}{}", g, wanted.abscissa ? "," : "") : "";
    if (!wanted.abscissa) {
      text += fmt::format("{}{}{}\n", group, wanted.group ? "," : "", blanks);
      continue;
    }
    for (const double x : wanted.points(g)) text += fmt::format("{}{:.17g}{}\n", group, x, blanks);
  }
  return text;
}

}  // namespace seiche::validation
