#include "validation/scoring/solver_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/csv_table.hpp"
#include "seiche/io/hdf5_table.hpp"

namespace seiche::validation {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A text file, line by line from 1, without ends of lines and a byte order mark.
struct Text {
  std::string file;
  std::vector<std::string> lines;

  [[noreturn]] void fail(std::size_t index, const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}: line {}: {}", file, index + 1, what));
  }
};

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

/// Words between any of the separators; of blanks several count as one.
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

/// Entries between single separators, blanks around them taken off.
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

/// Numbers of a line from the given word on.
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

/// Rows as they come, each with its line; turned into columns at the end.
class Rows {
 public:
  Rows(const Text& text, std::vector<std::string> names, std::vector<std::string> units) {
    table_.source = text.file;
    table_.names = std::move(names);
    table_.units = std::move(units);
    table_.columns.resize(table_.names.size());
  }
  void add(std::size_t line, const std::vector<double>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) table_.columns[k].push_back(row[k]);
    table_.lines.push_back(static_cast<long>(line) + 1);
  }
  [[nodiscard]] io::Table table() const {
    if (table_.rows() == 0) throw std::invalid_argument(fmt::format("{}: no rows of numbers", table_.source));
    return table_;
  }

 private:
  io::Table table_;
};

/// What stands between the entries of a line. A comma within the first word may be that of a decimal number.
char separator_of(const std::string& line) {
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string::npos) return separator;
  }
  return entries_of(line, ',').size() > 1 && !has_decimal_comma(words_of(line, " ").front()) ? ',' : ' ';
}

io::Table read_delimited(const Text& text, const std::vector<std::string>& columns) {
  // Names may stand in the last comment before the numbers; the first line that is none decides on the separator.
  std::size_t first = 0;
  while (first < text.lines.size() && is_comment(text.lines[first])) ++first;
  if (first == text.lines.size()) throw std::invalid_argument(fmt::format("{}: no rows of numbers", text.file));
  const std::string& opening = text.lines[first];
  const char separator = separator_of(opening);
  const auto split = [&](const std::string& line) {
    return separator == ' ' ? words_of(line, " \t") : entries_of(line, separator);
  };
  std::vector<std::string> names = split(opening);
  const bool named = std::none_of(names.begin(), names.end(), [](const std::string& word) {
    return number_in(word).has_value() || has_decimal_comma(word);
  });
  if (named) {
    ++first;
  } else if (columns.empty()) {
    text.fail(first, "the columns have no names: say them by --columns, as in --columns t,eta");
  }
  if (!columns.empty()) {
    if (columns.size() != names.size()) {
      text.fail(first, fmt::format("{} columns, --columns names {}", names.size(), columns.size()));
    }
    names = columns;
  }
  std::vector<std::string> units(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t bracket = names[k].find('[');
    if (bracket == std::string::npos || names[k].back() != ']') continue;
    units[k] = names[k].substr(bracket + 1, names[k].size() - bracket - 2);
    names[k] = words_of(names[k].substr(0, bracket), " \t").front();
  }
  Rows rows(text, names, units);
  for (std::size_t line = first; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<std::string> words = split(text.lines[line]);
    if (words.size() != names.size()) {
      text.fail(line, fmt::format("{} entries, must be {}", words.size(), names.size()));
    }
    std::vector<double> row;
    for (std::size_t k = 0; k < words.size(); ++k) row.push_back(number_at(text, line, words[k], names[k]));
    rows.add(line, row);
  }
  return rows.table();
}

/// The numbers within the first brackets after a word: "location=( 0.5 1 )".
std::vector<double> bracketed(const Text& text, std::size_t line) {
  const std::string& whole = text.lines[line];
  const std::size_t open = whole.find('(');
  const std::size_t close = whole.find(')', open);
  if (open == std::string::npos || close == std::string::npos) text.fail(line, "has no position (x y) in brackets");
  return numbers_of(text, line, words_of(whole.substr(open + 1, close - open - 1), " ,\t"), 0);
}

io::Table read_openfoam(const Text& text) {
  std::vector<std::vector<double>> places;
  const std::string stem = std::filesystem::path(text.file).filename().string();
  const bool heights = text.lines.front().starts_with("# Location");
  std::vector<std::string> names;
  std::optional<Rows> rows;
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    const std::string& whole = text.lines[line];
    if (is_comment(whole)) {
      const bool place = whole.starts_with("# Probe") || whole.starts_with("# Location");
      if (place && whole.find('(') != std::string::npos) places.push_back(bracketed(text, line));
      continue;
    }
    const std::vector<double> numbers = numbers_of(text, line, words_of(whole, " \t()"), 0);
    const std::size_t values = numbers.size() - 1;
    if (places.empty() || values == 0 || values % places.size() != 0) {
      text.fail(line, fmt::format("{} values for {} probes", values, places.size()));
    }
    const std::size_t each = values / places.size();
    if (!rows) {
      names = {"x", "y", "z", "t"};
      if (each == 1) {
        names.push_back(stem);
      } else if (heights && each == 2) {
        names.insert(names.end(), {"hB", "hL"});
      } else {
        for (std::size_t k = 0; k < each; ++k)
          names.push_back(fmt::format("{}_{}", stem, each == 3 ? std::string(1, "xyz"[k]) : std::to_string(k)));
      }
      rows.emplace(text, names, std::vector<std::string>(names.size()));
    }
    if (each + 4 != names.size()) text.fail(line, "holds another number of values than the lines before");
    for (std::size_t p = 0; p < places.size(); ++p) {
      std::vector<double> row = places[p];
      row.resize(3);
      row.push_back(numbers.front());
      for (std::size_t k = 0; k < each; ++k) row.push_back(numbers[1 + p * each + k]);
      rows->add(line, row);
    }
  }
  if (!rows) throw std::invalid_argument(fmt::format("{}: no rows of numbers", text.file));
  return rows->table();
}

io::Table read_geoclaw(const Text& text) {
  const std::vector<double> place = bracketed(text, 0);
  if (place.size() != 2) text.fail(0, "the location has not two numbers");
  Rows rows(text, {"x", "y", "level", "t", "h", "hu", "hv", "eta"}, {"m", "m", "1", "s", "m", "m^2/s", "m^2/s", "m"});
  for (std::size_t line = 1; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<double> numbers = numbers_of(text, line, words_of(text.lines[line], " \t"), 0);
    if (numbers.size() != 6)
      text.fail(line, fmt::format("{} entries, must be level, t, h, hu, hv, eta", numbers.size()));
    std::vector<double> row = place;
    row.insert(row.end(), numbers.begin(), numbers.end());
    rows.add(line, row);
  }
  return rows.table();
}

io::Table read_reef3d(const Text& text) {
  std::vector<std::vector<double>> places;
  Rows rows(text, {"x", "y", "t", "eta"}, {"m", "m", "s", "m"});
  bool series = false;
  for (std::size_t line = 1; line < text.lines.size(); ++line) {
    const std::vector<std::string> words = words_of(text.lines[line], " \t");
    if (words.empty() || words.front() == "x_coord") continue;
    if (words.front() == "time") {
      series = true;
      continue;
    }
    const std::vector<double> numbers = numbers_of(text, line, words, 0);
    if (!series) {
      if (numbers.size() != 3) text.fail(line, "must be the number, x and y of a gauge");
      places.push_back({numbers[1], numbers[2]});
      continue;
    }
    if (numbers.size() != places.size() + 1) {
      text.fail(line, fmt::format("{} values for {} gauges", numbers.size() - 1, places.size()));
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      rows.add(line, {places[p][0], places[p][1], numbers.front(), numbers[p + 1]});
    }
  }
  return rows.table();
}

io::Table read_measuretool(const Text& text) {
  const char separator = text.lines.front().find(';') != std::string::npos ? ';' : ',';
  if (text.lines.size() < 5) text.fail(text.lines.size() - 1, "ends before the first row of numbers");
  std::vector<std::vector<double>> places;  // by axis
  for (std::size_t axis = 0; axis < 3; ++axis) {
    places.push_back(numbers_of(text, axis, entries_of(text.lines[axis], separator), 2));
  }
  const std::vector<std::string> header = entries_of(text.lines[3], separator);
  if (header.size() != places.front().size() + 2 || places[1].size() != places[0].size() ||
      places[2].size() != places[0].size()) {
    text.fail(3, fmt::format("{} columns for {} positions", header.size() - 2, places.front().size()));
  }
  // "Elevation_0 [m]"
  const std::string quantity = header[2].substr(0, header[2].find_last_of("_ ["));
  const std::size_t bracket = header[2].find('[');
  const std::string unit =
      bracket == std::string::npos ? "" : header[2].substr(bracket + 1, header[2].find(']') - bracket - 1);
  Rows rows(text, {"x", "y", "z", "t", quantity.substr(0, quantity.find('_'))}, {"m", "m", "m", "s", unit});
  for (std::size_t line = 4; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<std::string> entries = entries_of(text.lines[line], separator);
    if (entries.size() != header.size()) {
      text.fail(line, fmt::format("{} entries, must be {}", entries.size(), header.size()));
    }
    const std::vector<double> numbers = numbers_of(text, line, entries, 1);  // without the number of the part
    for (std::size_t p = 0; p < places.front().size(); ++p) {
      rows.add(line, {places[0][p], places[1][p], places[2][p], numbers[0], numbers[p + 1]});
    }
  }
  return rows.table();
}

std::string recognised(const Text& text) {
  if (text.lines.empty()) return "csv";
  const std::string& first = text.lines.front();
  if (first.starts_with("# Probe") || first.starts_with("# Location")) return "openfoam";
  if (first.find("gauge_id=") != std::string::npos) return "geoclaw";
  if (first.starts_with("number of gauges:")) return "reef3d";
  if (first.find("PosX [m]:") != std::string::npos) return "dualsphysics";
  for (const std::string& line : text.lines) {
    if (line.starts_with("#") || line.find_first_not_of(" \t") == std::string::npos) continue;
    const bool commas = line.find(',') != std::string::npos;
    return commas && line.find(';') == std::string::npos && !is_comment(line) ? "csv" : "delimited";
  }
  return "csv";
}

/// A table in which t goes back within a gauge, or within the whole where there is none: the later rows stay.
long replace_restarted(io::Table& table) {
  if (!table.has("t")) return 0;
  const std::vector<double>& t = table.column("t");
  const std::vector<double> one(t.size(), 0);
  const std::vector<double>& x = table.has("x") ? table.column("x") : one;
  std::map<double, double> earliest;  // of the rows that follow, by gauge
  std::vector<bool> stays(t.size());
  for (std::size_t row = t.size(); row-- > 0;) {
    const auto next = earliest.find(x[row]);
    stays[row] = next == earliest.end() || t[row] < next->second;
    if (stays[row]) earliest[x[row]] = t[row];
  }
  const auto gone = static_cast<long>(std::count(stays.begin(), stays.end(), false));
  if (gone == 0) return 0;
  const auto keep = [&](auto& values) {
    std::size_t to = 0;
    for (std::size_t row = 0; row < stays.size(); ++row) {
      if (stays[row]) values[to++] = values[row];
    }
    values.resize(to);
  };
  for (auto& column : table.columns) keep(column);
  keep(table.lines);
  return gone;
}

}  // namespace

const std::vector<std::string>& solver_formats() {
  static const std::vector<std::string> names{"csv",     "hdf5",   "delimited",   "openfoam",
                                              "geoclaw", "reef3d", "dualsphysics"};
  return names;
}

ResultFile read_result(const std::filesystem::path& file, const std::string& format,
                       const std::vector<std::string>& columns, const std::vector<std::string>& wanted) {
  if (format == "hdf5" || (format == "auto" && io::is_hdf5(file))) {
    return {.table = io::read_hdf5(file, wanted), .format = "hdf5"};
  }
  if (format == "csv") return {.table = io::read_csv(file), .format = "csv"};
  std::string chosen = format;
  // A file that is not text, or whose lines never end, is refused by the reader of CSV before all of it is held.
  if (format == "auto") {
    std::ifstream in(file, std::ios::binary);
    std::string head(4096, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    std::istringstream lines(head.starts_with(byte_order_mark) ? head.substr(byte_order_mark.size()) : head);
    Text opening{.file = file.string(), .lines = {}};
    for (std::string line; std::getline(lines, line);) opening.lines.push_back(line);
    chosen = columns.empty() ? recognised(opening) : "delimited";
    if (chosen == "csv") return {.table = io::read_csv(file), .format = "csv"};
  }
  const Text text = text_of(file);
  if (text.lines.empty()) throw std::invalid_argument(fmt::format("{}: no rows of numbers", file.string()));
  ResultFile result{.table = {}, .format = chosen};
  if (chosen == "openfoam") {
    result.table = read_openfoam(text);
  } else if (chosen == "geoclaw") {
    result.table = read_geoclaw(text);
  } else if (chosen == "reef3d") {
    result.table = read_reef3d(text);
  } else if (chosen == "dualsphysics") {
    result.table = read_measuretool(text);
  } else {
    result.table = read_delimited(text, columns);
  }
  result.replaced = replace_restarted(result.table);
  return result;
}

std::vector<io::Table> joined(const std::vector<ResultFile>& files) {
  std::vector<io::Table> tables;
  for (const ResultFile& file : files) {
    const bool native = file.format != "csv" && file.format != "hdf5";
    const auto same = std::find_if(tables.begin(), tables.end(), [&](const io::Table& table) {
      return native && table.names == file.table.names && table.units == file.table.units;
    });
    if (same == tables.end()) {
      tables.push_back(file.table);
      continue;
    }
    same->source += ", " + file.table.source;
    for (std::size_t k = 0; k < same->columns.size(); ++k) {
      const std::vector<double>& more = file.table.columns[k];
      same->columns[k].insert(same->columns[k].end(), more.begin(), more.end());
    }
    same->lines.insert(same->lines.end(), file.table.lines.begin(), file.table.lines.end());
  }
  return tables;
}

}  // namespace seiche::validation
