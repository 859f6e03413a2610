#include "validation/scoring/result_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace seiche::validation {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The columns that say where and when.
std::vector<std::string> coordinates_of(const io::Table& table) {
  std::vector<std::string> names;
  for (const char* name : {"x", "y", "z", "t"}) {
    if (table.has(name)) names.emplace_back(name);
  }
  return names;
}

bool same_places(const io::Table& one, const io::Table& other) {
  const std::vector<std::string> names = coordinates_of(one);
  return names == coordinates_of(other) && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
           return one.column(name) == other.column(name);
         });
}

/// The columns of another table at the same places, beside those of this one.
void put_beside(io::Table& table, const io::Table& more) {
  table.source += ", " + more.source;
  for (std::size_t k = 0; k < more.names.size(); ++k) {
    if (table.has(more.names[k])) continue;
    table.names.push_back(more.names[k]);
    table.units.push_back(more.units[k]);
    table.columns.push_back(more.columns[k]);
  }
}

}  // namespace

void Text::fail(std::size_t index, const std::string& what) const {
  throw std::invalid_argument(fmt::format("{}: line {}: {}", file, index + 1, what));
}

Text text_of(const std::filesystem::path& path) {
  constexpr std::size_t longest_line = 1 << 20;
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !in) {
    throw std::invalid_argument(fmt::format("{}: cannot be read as a file", path.string()));
  }
  Text text{.file = path.string(), .lines = {}};
  std::string line;
  for (int c = 0; (c = in.get()) != std::ifstream::traits_type::eof();) {
    if (c == '\n') {
      text.lines.push_back(std::move(line));
      line.clear();
    } else if (c != '\r') {
      if ((c < ' ' && c != '\t') || c == 0x7f) text.fail(text.lines.size(), "binary content, must be text");
      line.push_back(static_cast<char>(c));
      if (line.size() > longest_line) text.fail(text.lines.size(), "longer than 1 MiB");
    }
  }
  if (!line.empty()) text.lines.push_back(std::move(line));
  if (!text.lines.empty() && text.lines.front().starts_with(byte_order_mark)) {
    text.lines.front().erase(0, byte_order_mark.size());
  }
  return text;
}

std::vector<std::string> words_of(const std::string& line, const std::string& separators) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(separators, begin)) != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

std::vector<std::string> entries_of(const std::string& line, char separator) {
  std::vector<std::string> entries;
  std::istringstream in(line);
  for (std::string entry; std::getline(in, entry, separator);) {
    const std::vector<std::string> words = words_of(entry, " \t");
    entries.push_back(fmt::format("{}", fmt::join(words, " ")));
  }
  if (!entries.empty() && entries.back().empty()) entries.pop_back();  // a separator at the end of the line
  return entries;
}

std::optional<double> number_in(std::string_view entry) {
  double value = 0;
  if (entry.size() > 1 && entry.front() == '+' && entry[1] != '-') entry.remove_prefix(1);
  const auto [end, failure] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
  if (failure != std::errc() || end != entry.data() + entry.size() || !std::isfinite(value)) return {};
  return value;
}

bool has_decimal_comma(const std::string& entry) {
  const std::size_t comma = entry.find(',');
  if (comma == std::string::npos || entry.find(',', comma + 1) != std::string::npos) return false;
  std::string with_point = entry;
  with_point[comma] = '.';
  return number_in(with_point).has_value();
}

double number_at(const Text& text, std::size_t line, const std::string& entry, const std::string& column) {
  if (const std::optional<double> value = number_in(entry)) return *value;
  if (has_decimal_comma(entry)) {
    text.fail(line, fmt::format("column {}: '{}' has a decimal comma: write points (LC_ALL=C, or sed 's/,/./g')",
                                column, entry.substr(0, 40)));
  }
  text.fail(line, fmt::format("column {}: '{}' is not a finite number", column, entry.substr(0, 40)));
}

std::vector<double> numbers_of(const Text& text, std::size_t line, const std::vector<std::string>& words,
                               std::size_t from) {
  std::vector<double> numbers;
  for (std::size_t k = from; k < words.size(); ++k) {
    numbers.push_back(number_at(text, line, words[k], fmt::format("{}", k + 1)));
  }
  return numbers;
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string::npos || line[first] == '#' || line[first] == '%' || line.compare(first, 2, "//") == 0;
}

std::vector<double> bracketed(const Text& text, std::size_t line) {
  const std::string& whole = text.lines[line];
  const std::size_t open = whole.find('(');
  const std::size_t close = whole.find(')', open);
  if (open == std::string::npos || close == std::string::npos) text.fail(line, "has no position (x y) in brackets");
  return numbers_of(text, line, words_of(whole.substr(open + 1, close - open - 1), " ,\t"), 0);
}

Text opening_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head(4096, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  std::istringstream lines(head.starts_with(byte_order_mark) ? head.substr(byte_order_mark.size()) : head);
  Text opening{.file = path.string(), .lines = {}};
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    opening.lines.push_back(line);
  }
  return opening;
}

Rows::Rows(const Text& text, std::vector<std::string> names, std::vector<std::string> units) {
  table_.source = text.file;
  table_.names = std::move(names);
  table_.units = std::move(units);
  table_.units.resize(table_.names.size());
  table_.columns.resize(table_.names.size());
}

void Rows::add(std::size_t line, const std::vector<double>& row) {
  for (std::size_t k = 0; k < row.size(); ++k) table_.columns[k].push_back(row[k]);
  table_.lines.push_back(static_cast<long>(line) + 1);
}

io::Table Rows::table() const {
  if (table_.rows() == 0) throw std::invalid_argument(fmt::format("{}: no rows of numbers", table_.source));
  return table_;
}

std::vector<io::Table> merged(const std::vector<io::Table>& parts) {
  std::vector<io::Table> tables;
  for (const io::Table& part : parts) {
    const auto same = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return same_places(t, part); });
    if (same == tables.end()) {
      tables.push_back(part);
    } else {
      put_beside(*same, part);
    }
  }
  return tables;
}

void put_below(io::Table& table, const io::Table& more) {
  if (table.names != more.names) {
    throw std::invalid_argument(fmt::format("{}: columns {}, but {} has {}", more.source, fmt::join(more.names, ", "),
                                            table.source, fmt::join(table.names, ", ")));
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    table.columns[k].insert(table.columns[k].end(), more.columns[k].begin(), more.columns[k].end());
  }
  table.lines.insert(table.lines.end(), more.lines.begin(), more.lines.end());
}

}  // namespace seiche::validation
