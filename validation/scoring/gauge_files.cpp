#include "validation/scoring/gauge_files.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace seiche::validation {

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

io::Table read_funwave(const Text& text) {
  Rows rows(text, {"t", "eta", "u", "v"}, {"s", "m", "m/s", "m/s"});
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<double> numbers = numbers_of(text, line, words_of(text.lines[line], " \t"), 0);
    if (numbers.size() != 4) text.fail(line, fmt::format("{} entries, must be time, eta, u, v", numbers.size()));
    rows.add(line, numbers);
  }
  return rows.table();
}

io::Table read_gerris(const Text& text) {
  std::vector<std::string> names;
  for (const std::string& word : words_of(text.lines.front(), "# \t")) names.push_back(word.substr(word.find(':') + 1));
  Rows rows(text, names);
  for (std::size_t line = 1; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<double> numbers = numbers_of(text, line, words_of(text.lines[line], " \t"), 0);
    if (numbers.size() != names.size()) {
      text.fail(line, fmt::format("{} entries, must be {}", numbers.size(), names.size()));
    }
    rows.add(line, numbers);
  }
  return rows.table();
}

bool is_swash(const Text& opening) {
  return std::any_of(opening.lines.begin(), opening.lines.end(), [](const std::string& line) {
    return line.starts_with('%') && line.find("SWASH") != std::string::npos;
  });
}

io::Table read_swash(const Text& text) {
  // The last two comments that are not blank: names, and units in brackets.
  std::vector<std::vector<std::string>> header;
  std::size_t first = 0;
  for (; first < text.lines.size() && is_comment(text.lines[first]); ++first) {
    const std::vector<std::string> words = words_of(text.lines[first], "% \t");
    if (!words.empty()) header.push_back(words);
  }
  const bool complete = header.size() >= 2 && header.back().front().starts_with('[') &&
                        header.back().size() == header[header.size() - 2].size();
  if (!complete) text.fail(first, "the header must end with a line of names and one of units: TABLE ... HEAD");
  static const std::map<std::string, std::string> short_names{
      {"Tsec", "t"}, {"Watlev", "eta"}, {"Xp", "x"}, {"Yp", "y"}, {"Depth", "h"}, {"X-vel", "u"}, {"Y-vel", "v"}};
  std::vector<std::string> names = header[header.size() - 2];
  std::vector<std::string> units = header.back();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (const auto known = short_names.find(names[k]); known != short_names.end()) names[k] = known->second;
    units[k] = units[k].substr(1, units[k].find(']') - 1);
    if (units[k] == "sec") units[k] = "s";
  }
  Rows rows(text, names, units);
  for (std::size_t line = first; line < text.lines.size(); ++line) {
    if (is_comment(text.lines[line])) continue;
    const std::vector<double> numbers = numbers_of(text, line, words_of(text.lines[line], " \t"), 0);
    if (numbers.size() != names.size()) {
      text.fail(line, fmt::format("{} entries, must be {}", numbers.size(), names.size()));
    }
    rows.add(line, numbers);
  }
  return rows.table();
}

}  // namespace seiche::validation
