#include "seiche/io/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/hdf5_table.hpp"

namespace seiche::io {

bool Table::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::size_t Table::index(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const auto why = unusable.find(name);
  if (why != unusable.end()) throw std::invalid_argument(fmt::format("{}: column {}: {}", source, name, why->second));
  std::vector<std::string> there = names;
  for (const auto& [other, reason] : unusable) there.push_back(other);
  constexpr std::size_t shown = 12;
  const bool more = there.size() > shown;
  if (more) there.resize(shown);
  throw std::invalid_argument(fmt::format("{}: column {} is missing: the file has {}{}", source, name,
                                          there.empty() ? "none" : fmt::format("{}", fmt::join(there, ", ")),
                                          more ? ", ..." : ""));
}

const std::vector<double>& Table::column(const std::string& name) const {
  return columns[index(name)];
}

const std::string& Table::unit(const std::string& name) const {
  return units[index(name)];
}

std::string Table::place(std::size_t row) const {
  return row < lines.size() ? fmt::format("line {}", lines[row]) : fmt::format("element {}", row);
}

Table read_table(const std::filesystem::path& file, const std::vector<std::string>& wanted) {
  return is_hdf5(file) ? read_hdf5(file, wanted) : read_csv(file);
}

namespace {

constexpr std::size_t longest_line = 1 << 20;
constexpr std::size_t most_columns = 1000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> entries;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    entries.push_back(unquoted(trimmed(line.substr(begin, comma - begin))));
    if (comma == std::string_view::npos) return entries;
    begin = comma + 1;
  }
}

/// Reads line by line without ever holding more than one line of sane length.
class LineReader {
 public:
  LineReader(std::istream& in, std::string name) : name_(std::move(name)), buffer_(in.rdbuf()) {}

  bool next(std::string& line) {
    constexpr int end_of_file = std::char_traits<char>::eof();
    line.clear();
    ++number_;
    for (int c = 0; (c = buffer_->sbumpc()) != end_of_file;) {
      if (c == '\n') return true;
      if (c == '\r') {
        if (buffer_->sgetc() == '\n') buffer_->sbumpc();
        return true;
      }
      if ((c < ' ' && c != '\t') || c == 0x7f) fail("binary content, must be text");
      line.push_back(static_cast<char>(c));
      if (line.size() > longest_line) fail("longer than 1 MiB");
    }
    return !line.empty();
  }

  /// Says what is wrong with the line that was read last.
  [[noreturn]] void fail(std::string what) const {
    std::replace(what.begin(), what.end(), '\t', ' ');
    throw std::invalid_argument(fmt::format("{}: line {}: {}", name_, number_, what));
  }
  [[nodiscard]] long number() const { return number_; }

 private:
  std::string name_;
  std::streambuf* buffer_;
  long number_ = 0;
};

/// The finite number that the whole of `entry` spells, if it does.
std::optional<double> number_in(std::string_view entry) {
  double value = 0;
  if (entry.size() > 1 && entry.front() == '+' && entry[1] != '-') entry.remove_prefix(1);
  const auto [end, failure] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
  if (failure != std::errc() || end != entry.data() + entry.size() || !std::isfinite(value)) return {};
  return value;
}

/// Takes "h [m]" apart into the table's names and units.
void read_header(const LineReader& reader, const std::vector<std::string_view>& entries, Table& table) {
  if (entries.size() > most_columns) reader.fail(fmt::format("more than {} columns", most_columns));
  for (const std::string_view entry : entries) {
    const std::size_t bracket = entry.find('[');
    const std::string name(trimmed(entry.substr(0, bracket)));
    const std::string shown = name.substr(0, 80);
    if (name.empty()) reader.fail(fmt::format("column {} has no name", table.names.size() + 1));
    if (number_in(name)) {
      reader.fail(
          fmt::format("column '{}' is a number: the first line that is no comment must name the columns", shown));
    }
    if (name.find_first_of(";\t") != std::string::npos) {
      reader.fail(fmt::format("column '{}': columns must be separated by commas", shown));
    }
    if (table.has(name)) reader.fail(fmt::format("column {} is there twice", shown));
    std::string unit;
    if (bracket != std::string_view::npos) {
      const std::string_view rest = entry.substr(bracket + 1);
      if (rest.empty() || rest.find(']') != rest.size() - 1) {
        reader.fail(
            fmt::format("column {}: '{}' must end with the bracket that closes the unit", shown, entry.substr(0, 40)));
      }
      unit = trimmed(rest.substr(0, rest.size() - 1));
    }
    table.names.push_back(name);
    table.units.push_back(unit);
  }
  table.columns.resize(table.names.size());
}

}  // namespace

Table read_csv(std::istream& in, const std::string& name) {
  LineReader reader(in, name);
  Table table;
  table.source = name;
  for (std::string line; reader.next(line);) {
    std::string_view text = line;
    if (reader.number() == 1 && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    text = trimmed(text);
    if (text.empty() || text.front() == '#') continue;
    const std::vector<std::string_view> entries = split(text);
    if (table.names.empty()) {
      read_header(reader, entries, table);
      continue;
    }
    if (entries.size() != table.names.size()) {
      const std::string missing = entries.size() < table.names.size()
                                      ? ": column " + table.names[entries.size()].substr(0, 80) + " is missing"
                                      : "";
      reader.fail(fmt::format("{} entries, must be {}{}", entries.size(), table.names.size(), missing));
    }
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const std::optional<double> value = number_in(entries[k]);
      if (!value) {
        reader.fail(fmt::format("column {}: '{}' is not a finite number", table.names[k].substr(0, 80),
                                entries[k].substr(0, 40)));
      }
      table.columns[k].push_back(*value);
    }
    table.lines.push_back(reader.number());
  }
  if (table.rows() == 0) {
    throw std::invalid_argument(
        fmt::format("{}: no rows: a line of column names and lines of numbers are needed", name));
  }
  return table;
}

Table read_csv(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in) {
    throw std::invalid_argument(fmt::format("{}: cannot be read as a file", file.string()));
  }
  return read_csv(in, file.string());
}

}  // namespace seiche::io
