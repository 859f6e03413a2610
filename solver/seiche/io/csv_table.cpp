#include "seiche/io/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace seiche::io {
namespace {

constexpr std::size_t longest_line = 1 << 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> entries;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    entries.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return entries;
    begin = comma + 1;
  }
}

/// Reads line by line without ever holding more than one line of sane length.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& file) : name_(file.string()), in_(file, std::ios::binary) {
    if (!std::filesystem::is_regular_file(file) || !in_) fail("cannot be read as a file");
  }

  bool next(std::string& line) {
    line.clear();
    ++number_;
    for (int c = 0; (c = in_.get()) != std::char_traits<char>::eof();) {
      if (c == '\n') return true;
      if (c == '\0') fail(fmt::format("line {}: binary content, must be text", number_));
      line.push_back(static_cast<char>(c));
      if (line.size() > longest_line) fail(fmt::format("line {}: longer than 1 MiB", number_));
    }
    return !line.empty();
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}: {}", name_, what));
  }
  [[nodiscard]] long number() const { return number_; }

 private:
  std::string name_;
  std::ifstream in_;
  long number_ = 0;
};

double number_in(const LineReader& reader, std::string_view entry, const std::string& column) {
  double value = 0;
  const auto [end, failure] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
  if (failure != std::errc() || end != entry.data() + entry.size() || !std::isfinite(value)) {
    reader.fail(
        fmt::format("line {}: column {}: '{}' is not a finite number", reader.number(), column, entry.substr(0, 40)));
  }
  return value;
}

}  // namespace

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::invalid_argument(fmt::format("column {} is missing: there are {}", name, fmt::join(names, ", ")));
  }
  return columns[static_cast<std::size_t>(found - names.begin())];
}

CsvTable read_csv(const std::filesystem::path& file) {
  LineReader reader(file);
  CsvTable table;
  for (std::string line; reader.next(line);) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    const std::vector<std::string_view> entries = split(text);
    if (table.names.empty()) {
      for (const std::string_view entry : entries) {
        table.names.emplace_back(trimmed(entry.substr(0, entry.find('['))));
        if (table.names.back().empty()) reader.fail(fmt::format("line {}: a column has no name", reader.number()));
      }
      table.columns.resize(table.names.size());
      continue;
    }
    if (entries.size() != table.names.size()) {
      reader.fail(fmt::format("line {}: {} entries, must be {} ({})", reader.number(), entries.size(),
                              table.names.size(), fmt::join(table.names, ", ")));
    }
    for (std::size_t k = 0; k < entries.size(); ++k) {
      table.columns[k].push_back(number_in(reader, entries[k], table.names[k]));
    }
  }
  if (table.rows() == 0) reader.fail("no rows: a line of column names and lines of numbers are needed");
  return table;
}

}  // namespace seiche::io
