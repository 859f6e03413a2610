#include "seiche/io/text_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/date.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/require_that.hpp"
#include "seiche/wording.hpp"

namespace seiche::io {
namespace {

constexpr std::size_t longest_line = 1 << 20;
constexpr std::size_t longest_text = 1 << 30;
constexpr std::size_t most_columns = 1000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::array separators{';', '\t', ',', ' '};

std::string_view trimmed(std::string_view text, std::string_view off = " \t") {
  const std::size_t begin = text.find_first_not_of(off);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(off) - begin + 1);
}

/// Characters of a stream; of UTF-16, which two bytes at the beginning announce, the characters that ASCII has.
class Characters {
 public:
  static constexpr int end = std::char_traits<char>::eof();

  explicit Characters(std::istream& in) : buffer_(in.rdbuf()) {
    const int first = buffer_->sgetc();
    if (first != 0xFF && first != 0xFE) return;
    buffer_->sbumpc();
    const int second = buffer_->sgetc();
    if (first + second == 0xFF + 0xFE) {
      buffer_->sbumpc();
      low_first_ = first == 0xFF;
      wide_ = true;
    } else {
      buffer_->sungetc();
    }
  }

  int next() {
    const int first = buffer_->sbumpc();
    if (!wide_ || first == end) return first;
    const int second = buffer_->sbumpc();
    if (second == end) return end;
    const int unit = low_first_ ? first + 256 * second : second + 256 * first;
    return unit < 0x80 ? unit : '?';
  }

 private:
  std::streambuf* buffer_;
  bool wide_ = false;
  bool low_first_ = false;
};

/// What std::from_chars reads: no sign + before the number, e for Fortran's d or nothing, a point for a comma.
std::string plain_number(std::string_view entry) {
  if (entry.size() > 1 && entry.front() == '+' && entry[1] != '-') entry.remove_prefix(1);
  std::string plain;
  for (std::size_t k = 0; k < entry.size(); ++k) {
    const char c = entry[k];
    const bool after_digit =
        k > 0 && (std::isdigit(static_cast<unsigned char>(entry[k - 1])) != 0 || entry[k - 1] == '.');
    const bool three_left = entry.size() - k == 4;
    const bool fraction = plain.find('.') != std::string::npos;
    if (after_digit && (c == 'd' || c == 'D' || c == 'E')) {
      plain += 'e';
    } else if (after_digit && (c == '-' || c == '+') && three_left && fraction &&
               plain.find('e') == std::string::npos) {
      plain += {'e', c};
    } else {
      plain += c == ',' ? '.' : c;
    }
  }
  return plain;
}

/// A line taken apart; of blanks several count as one, and what brackets hold is not split at them.
std::vector<std::string> split(const std::string& line, char separator) {
  if (separator != ' ') return entries_of(line, separator);
  std::vector<std::string> words;
  for (const std::string& word : words_of(line)) {
    const auto open = [](const std::string& text) {
      return std::count(text.begin(), text.end(), '[') > std::count(text.begin(), text.end(), ']');
    };
    const bool unit = word.front() == '[' && word.size() > 1 && !words.empty() && words.back().back() != ']';
    if (!words.empty() && (unit || open(words.back()))) {
      words.back() += " " + word;
    } else {
      words.emplace_back(word);
    }
    std::erase(words.back(), '"');
    if (words.back().empty()) words.pop_back();
  }
  return words;
}

/// A line of values, at least one of which is a number; none for another line.
std::optional<std::vector<double>> values_in(const std::string& line, char separator) {
  if (separator != ' ' && line.find(separator) == std::string::npos) return {};
  std::vector<std::string> entries = split(line, separator);
  if (!entries.empty() && entries.back().empty()) entries.pop_back();  // a separator at the end
  std::vector<double> values;
  for (const std::string& entry : entries) {
    const std::optional<double> value = value_in(entry);
    if (!value) return {};
    values.push_back(*value);
  }
  const bool any = std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  return any ? std::optional(values) : std::nullopt;
}

struct Start {
  std::size_t line = 0;
  char separator = ' ';
  std::size_t columns = 0;
};

/// The first of two lines of as many numbers, or else the first of numbers at all.
std::optional<Start> start_of(const Text& text) {
  std::optional<Start> first;
  std::optional<Start> before;
  std::string names;  // the last line without numbers
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    std::optional<Start> here;
    for (const char separator : separators) {
      const auto values = values_in(text.lines[line], separator);
      if (!values || here) continue;
      const std::vector<std::string> above = split(names, separator);
      const bool no_value = above.size() == values->size() + 1 && !above.back().empty() &&
                            split(text.lines[line], separator).size() == above.size();  // of the last column
      here = Start{line, separator, values->size() + (no_value ? 1 : 0)};
    }
    if (!here) names = text.lines[line];
    if (here && before && here->separator == before->separator && here->columns == before->columns) return before;
    if (here && !first) first = here;
    before = here;
  }
  return first;
}

/// Name and unit of "h [m]" or "h(m)".
std::pair<std::string, std::string> name_and_unit(std::string_view entry) {
  const char close = entry.empty() ? ' ' : entry.back();
  const std::size_t open = close == ']' ? entry.find('[') : close == ')' ? entry.rfind('(') : std::string_view::npos;
  if (open == std::string_view::npos) return {std::string(trimmed(entry)), ""};
  return {std::string(trimmed(entry.substr(0, open))),
          std::string(trimmed(entry.substr(open + 1, entry.size() - open - 2)))};
}

/// "[m]", "(m)", or a unit that nobody calls a column.
bool is_unit(const std::string& entry) {
  constexpr std::array bare{"s", "sec", "m", "cm", "mm", "ft", "m/s", "cm/s", "Pa", "kPa"};
  return std::ranges::find(bare, entry) != bare.end() ||
         (entry.size() > 1 && (entry.front() == '[' || entry.front() == '(') &&
          (entry.back() == ']' || entry.back() == ')'));
}

/// A line of names in the order of the columns, with the units of a line below it.
struct Header {
  std::size_t line = 0;
  std::vector<std::string> columns;
};

std::vector<std::string> header_entries(const std::string& line, const Start& start) {
  const std::size_t begin = line.find_first_not_of(" \t#%!/");
  const std::string words = begin == std::string::npos ? "" : line.substr(is_comment(line) ? begin : 0);
  std::vector<std::string> entries = split(words, start.separator);
  if (entries.size() == start.columns + 1 && entries.back().empty()) entries.pop_back();
  for (const char separator : separators) {
    if (entries.size() != start.columns && is_comment(line)) entries = split(words, separator);
  }
  return entries;
}

/// Of the lines before the numbers the last with as many entries of which the fewest are numbers.
std::optional<Header> header_of(const Text& text, const Start& start) {
  std::optional<Header> header;
  std::vector<std::string> units;
  auto fewest = static_cast<std::ptrdiff_t>(start.columns);
  for (std::size_t line = start.line; line-- > 0;) {
    std::vector<std::string> entries = header_entries(text.lines[line], start);
    if (entries.size() != start.columns) continue;
    if (std::all_of(entries.begin(), entries.end(), is_unit)) {
      if (units.empty() && !header) units = entries;
      continue;
    }
    const auto numbers =
        std::count_if(entries.begin(), entries.end(), [](const auto& e) { return number_in(e).has_value(); });
    if (numbers >= fewest || (header && is_comment(text.lines[line]) && !is_comment(text.lines[header->line])))
      continue;
    fewest = numbers;
    header = Header{line, std::move(entries)};
  }
  for (std::size_t k = 0; header && k < units.size(); ++k) {
    header->columns[k] += std::isalpha(units[k].front()) != 0 ? "[" + units[k] + "]" : units[k];
  }
  return header;
}

/// Gerris numbers its columns: "2:x".
std::string without_number(const std::string& name) {
  const std::size_t colon = name.find(':');
  return colon != std::string::npos && number_in(name.substr(0, colon)) ? name.substr(colon + 1) : name;
}

/// Where no line holds numbers alone: the first that is no comment names the columns, the next one is broken.
[[noreturn]] void fail_without_numbers(const Text& text) {
  std::vector<std::size_t> lines;
  for (std::size_t line = 0; line < text.lines.size() && lines.size() < 2; ++line) {
    if (!is_comment(text.lines[line])) lines.push_back(line);
  }
  if (lines.size() == 2) {
    for (const char separator : separators) {
      if (separator != ' ' && text.lines[lines[0]].find(separator) == std::string::npos) continue;
      const std::vector<std::string> names = split(text.lines[lines[0]], separator);
      const std::vector<std::string> entries = split(text.lines[lines[1]], separator);
      for (std::size_t k = 0; k < std::min(names.size(), entries.size()); ++k) {
        if (value_in(entries[k])) continue;
        text.fail(lines[1], fmt::format("column {}: '{}' is not a finite number", names[k].substr(0, 80),
                                        entries[k].substr(0, 40)));
      }
    }
  }
  throw std::invalid_argument(
      fmt::format("{}: no rows of numbers: a line of column names and lines of numbers are needed", text.file));
}

}  // namespace

void Text::fail(std::size_t index, std::string what) const {
  std::replace(what.begin(), what.end(), '\t', ' ');
  throw std::invalid_argument(fmt::format("{}: line {}: {}", file, index + 1, printable(what)));
}

Text text_of(std::istream& in, const std::string& name, std::size_t most) {
  Text text{.file = name, .lines = {}};
  Characters bytes(in);
  std::string line;
  std::size_t read = 0;
  int before = 0;
  const auto end_line = [&] {
    if (text.lines.empty() && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    text.lines.push_back(std::move(line));
    line.clear();
  };
  for (int c = 0; read < most && (c = bytes.next()) != Characters::end; before = c, ++read) {
    if (c == '\n' && before == '\r') continue;
    if (c == '\n' || c == '\r') {
      end_line();
      continue;
    }
    if (most == std::string::npos && ((c < ' ' && c != '\t' && c != '\f') || c == 0x7f)) {
      text.fail(text.lines.size(), "binary content, must be text");
    }
    line.push_back(static_cast<char>(c));
    if (line.size() > longest_line) text.fail(text.lines.size(), "longer than 1 MiB");
    if (read > longest_text) text.fail(text.lines.size(), "more than 1 GiB before this line");
  }
  if (!line.empty()) end_line();
  return text;
}

Text text_of(const std::filesystem::path& path, std::size_t most) {
  const bool file = std::filesystem::is_regular_file(path);  // a pipe would wait for its other end
  std::ifstream in(file ? path : std::filesystem::path(), std::ios::binary);
  require_that(file && in.good(), "{}: cannot be read as a file", path.string());
  return text_of(in, path.string(), most);
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
  std::vector<std::string> entries(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      entries.emplace_back();
    } else {
      entries.back() += c;
    }
  }
  for (std::string& entry : entries) entry = trimmed(entry);
  return entries;
}

std::optional<double> number_in(std::string_view entry) {
  double value = 0;
  const std::string plain = plain_number(entry);
  const auto [end, failure] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (end != plain.data() + plain.size()) return {};
  if (failure == std::errc::result_out_of_range && plain.find("e-") != std::string::npos) return 0;
  if (failure != std::errc() || !std::isfinite(value)) return {};
  return value;
}

std::optional<double> value_in(std::string_view entry) {
  if (const std::optional<double> number = number_in(entry)) return number;
  if (is_date(entry)) return date_in(std::string(entry));
  constexpr std::array<std::string_view, 12> none{"",     "nan",  "-nan", "+nan", "na",        "n/a",
                                                  "null", "none", "-",    "--",   "-nan(ind)", "nan(ind)"};
  std::string lower(entry.substr(0, 12));
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  if (std::find(none.begin(), none.end(), lower) == none.end() &&
      entry.find_first_not_of('*') != std::string_view::npos)
    return {};
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> values_of(const Text& text, std::size_t line, const std::vector<std::string>& words) {
  std::vector<double> values;
  for (const std::string& word : words) {
    const std::optional<double> value = value_in(word);
    if (!value)
      text.fail(line, fmt::format("entry {}: '{}' is not a finite number", values.size() + 1, word.substr(0, 40)));
    values.push_back(*value);
  }
  return values;
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string::npos || line[first] == '#' || line[first] == '%' || line[first] == '!' ||
         line.compare(first, 2, "//") == 0;
}

Rows::Rows(const Text& text, const std::vector<std::string>& columns) : text_(text) {
  table_.source = text.file;
  for (const std::string& column : columns) {
    const auto [name, unit] = name_and_unit(column);
    table_.names.push_back(printable(name));
    table_.units.push_back(printable(unit));
  }
  table_.columns.resize(columns.size());
}

void Rows::add(std::size_t line, const std::vector<double>& row) {
  if (row.size() != table_.columns.size()) {
    text_.fail(line, fmt::format("{} entries, must be {}{}", row.size(), table_.columns.size(),
                                 row.size() < table_.names.size()
                                     ? fmt::format(": column {} is missing", table_.names[row.size()].substr(0, 80))
                                     : ""));
  }
  for (std::size_t k = 0; k < row.size(); ++k) table_.columns[k].push_back(row[k]);
  table_.lines.push_back(static_cast<long>(line) + 1);
}

Table Rows::table() const {
  require_that(table_.rows() > 0, "{}: no rows of numbers", table_.source);
  return table_;
}

Table read_text_table(const Text& text, const std::vector<std::string>& columns, const UsualColumns& usual) {
  const std::optional<Start> start = start_of(text);
  if (!start) fail_without_numbers(text);
  const std::optional<Header> header = header_of(text, *start);
  std::vector<std::string> names = columns;
  if (names.empty() && header) names = header->columns;
  if (names.empty() && usual) names = usual(start->columns);
  if (start->columns > most_columns) text.fail(start->line, fmt::format("more than {} columns", most_columns));
  if (names.empty()) {
    std::size_t above = start->line;  // a header of another length?
    while (above > 0 && is_comment(text.lines[above - 1])) --above;
    if (above > 0 && is_unit(text.lines[above - 1])) {
      text.fail(above - 1, fmt::format("{}: a unit without the name of its column", text.lines[above - 1]));
    }
    if (above > 0) {
      Rows(text, split(text.lines[above - 1], start->separator)).add(start->line, std::vector<double>(start->columns));
    }
    text.fail(start->line, "the columns have no names: name them by --columns, as in --columns t,eta");
  }
  if (names.size() != start->columns) {
    text.fail(start->line, fmt::format("{} columns, --columns names {}", start->columns, names.size()));
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::string& name = names[k];
    name = without_number(name);
    const std::string bare = name_and_unit(name).first;
    const std::size_t at = header ? header->line : start->line;
    const std::string shown = bare.substr(0, 80);
    if (name.find('[') != std::string::npos && name.back() != ']') {
      text.fail(at, fmt::format("column {}: '{}' must end with the bracket that closes the unit",
                                shown.substr(0, shown.find('[')), name.substr(name.find('[')).substr(0, 40)));
    }
    if (bare.empty() && is_unit(name)) text.fail(at, fmt::format("{}: a unit without the name of its column", name));
    if (bare.empty()) name = fmt::format("column {}", k + 1);
    const auto same = [&](const std::string& other) { return name_and_unit(other).first == bare; };
    const auto own = names.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::find_if(names.begin(), own, same) != own) text.fail(at, fmt::format("column {} is there twice", shown));
  }
  const std::vector<std::string> first = split(text.lines[start->line], start->separator);
  for (std::size_t k = 0; k < std::min(first.size(), names.size()); ++k) {
    if (is_date(first[k])) names[k] = name_and_unit(names[k]).first + " [seconds since 1970-01-01]";
  }
  Rows rows(text, names);
  // A line between header and numbers that holds some is a broken row.
  for (std::size_t line = header && columns.empty() ? header->line + 1 : start->line; line < text.lines.size();
       ++line) {
    const std::string& whole = text.lines[line];
    if (is_comment(whole) || (header && whole == text.lines[header->line])) continue;
    std::vector<std::string> entries = split(whole, start->separator);
    if (line < start->line &&
        std::none_of(entries.begin(), entries.end(), [](const auto& e) { return number_in(e).has_value(); }))
      continue;
    if (entries.size() == names.size() + 1 && entries.back().empty()) entries.pop_back();  // a separator at the end
    std::vector<double> row(entries.size());
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const std::optional<double> value = value_in(entries[k]);
      if (!value && k < names.size()) {
        text.fail(line, fmt::format("column {}: '{}' is not a finite number",
                                    name_and_unit(names[k]).first.substr(0, 80), entries[k].substr(0, 40)));
      }
      row[k] = value.value_or(0);
    }
    rows.add(line, row);
  }
  return rows.table();
}

namespace {

Table without_gaps(Table table) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const std::vector<double>& values = table.columns[k];
    const auto none = std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (none == values.end()) continue;
    throw std::invalid_argument(fmt::format("{}: {}: column {}: no value", table.source,
                                            table.place(static_cast<std::size_t>(none - values.begin())),
                                            table.names[k]));
  }
  return table;
}

}  // namespace

Table read_csv(std::istream& in, const std::string& name) {
  return without_gaps(read_text_table(text_of(in, name)));
}

Table read_csv(const std::filesystem::path& file) {
  return without_gaps(read_text_table(text_of(file)));
}

bool Table::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::size_t Table::index(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const auto why = unusable.find(name);
  if (why != unusable.end()) {
    throw std::invalid_argument(fmt::format("{}: column {}: {}", source, name, why->second));
  }
  std::vector<std::string> there = names;
  for (const auto& [other, reason] : unusable) there.push_back(other);
  constexpr std::size_t shown = 12;
  const bool more = there.size() > shown;
  if (more) there.resize(shown);
  throw std::invalid_argument(fmt::format("{}: column {} is missing: the file has {}{}", source, name,
                                          there.empty() ? "none" : fmt::format("{}", fmt::join(there, ", ")),
                                          more ? ", ..." : ""));
}

std::string Table::place(std::size_t row) const {
  return row < lines.size() ? fmt::format("line {}", lines[row]) : fmt::format("element {}", row);
}

Table read_table(const std::filesystem::path& file, const std::vector<std::string>& wanted) {
  return is_hdf5(file) ? read_hdf5(file, wanted) : read_text_table(text_of(file));
}

}  // namespace seiche::io
