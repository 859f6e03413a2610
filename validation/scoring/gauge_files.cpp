#include "validation/scoring/gauge_files.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "validation/scoring/folder_tables.hpp"

namespace seiche::validation {
namespace {

/// Without the first entries of a line, and a separator at its end.
std::vector<double> values_after(const io::Text& text, std::size_t line, char separator, std::ptrdiff_t first) {
  std::vector<std::string> entries = io::entries_of(text.lines[line], separator);
  entries.erase(entries.begin(), entries.begin() + std::min<std::ptrdiff_t>(first, std::ssize(entries)));
  if (!entries.empty() && entries.back().empty()) entries.pop_back();
  return io::values_of(text, line, entries);
}

/// Columns as "# Columns: level, time, q[1 2 3], eta, aux[]" counts them; without that line three of q and the surface.
std::vector<std::string> geoclaw_columns(const io::Text& text, std::size_t count) {
  std::vector<std::string> q{"h [m]", "hu [m^2/s]", "hv [m^2/s]"};
  for (const std::string& line : text.lines) {
    const std::size_t open = line.find("q[");
    if (!line.starts_with('#') || open == std::string::npos) continue;
    const std::size_t each = io::words_of(line.substr(open + 2, line.find(']', open) - open - 2)).size();
    if (each == 2) q.pop_back();
    if (each <= 3) break;
    q.clear();
    for (std::size_t k = 1; k <= each; ++k) q.push_back(fmt::format("q{}", k));
    break;
  }
  std::vector<std::string> columns{"level", "t [s]"};
  columns.insert(columns.end(), q.begin(), q.end());
  columns.emplace_back("eta [m]");
  for (std::size_t k = 2; columns.size() < count; ++k) columns.push_back(fmt::format("eta{}", k));
  return columns;
}

}  // namespace

std::vector<double> bracketed(const io::Text& text, std::size_t line) {
  const std::string& whole = text.lines[line];
  const std::size_t open = whole.find('(');
  const std::size_t close = whole.find(')', open);
  if (open == std::string::npos || close == std::string::npos) text.fail(line, "has no position (x y) in brackets");
  return io::values_of(text, line, io::words_of(whole.substr(open + 1, close - open - 1), " ,\t"));
}

io::Table read_geoclaw(const io::Text& text) {
  const std::vector<double> place = bracketed(text, 0);
  if (place.size() != 2) text.fail(0, "the location has not two numbers");
  std::size_t first = 0;
  while (first < text.lines.size() && io::is_comment(text.lines[first])) ++first;
  if (first == text.lines.size()) text.fail(0, "no rows of numbers follow");
  const std::size_t count = io::words_of(text.lines[first]).size();
  const std::vector<std::string> columns = geoclaw_columns(text, count);
  if (columns.size() != count) text.fail(first, fmt::format("{} entries, must be {}", count, columns.size()));
  io::Table table = io::read_text_table(text, columns);
  add_constant(table, "x", "m", place[0]);
  add_constant(table, "y", "m", place[1]);
  return table;
}

io::Table read_reef3d(const io::Text& text) {
  std::vector<std::vector<double>> places;
  io::Rows rows(text, {"x [m]", "y [m]", "t [s]", "eta [m]"});
  bool series = false;
  for (std::size_t line = 1; line < text.lines.size(); ++line) {
    const std::vector<std::string> words = io::words_of(text.lines[line]);
    series = series || (!words.empty() && words.front() == "time");
    if (words.empty() || words.front() == "x_coord" || words.front() == "time") continue;
    const std::vector<double> numbers = io::values_of(text, line, words);
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

io::Table read_measuretool(const io::Text& text) {
  const char separator = text.lines.front().find(';') != std::string::npos ? ';' : ',';
  if (text.lines.size() < 5) text.fail(text.lines.size() - 1, "ends before the first row of numbers");
  std::vector<std::vector<double>> places;  // by axis
  for (std::size_t axis = 0; axis < 3; ++axis) places.push_back(values_after(text, axis, separator, 2));
  const std::vector<std::string> header = io::entries_of(text.lines[3], separator);
  if (places[0].empty()) text.fail(0, "no positions: MeasureTool writes them behind ' ;PosX [m]:'");
  if (header.size() != places[0].size() + 2 || places[1].size() != places[0].size() ||
      places[2].size() != places[0].size()) {
    text.fail(3, fmt::format("{} columns, must be part, time and one for each of the {} positions", header.size(),
                             places[0].size()));
  }
  // "Elevation_0 [m]"
  const std::string quantity = header[2].substr(0, header[2].find_last_of("_ ["));
  const std::string unit = header[2].substr(std::min(header[2].find('['), header[2].size()));
  io::Rows rows(text, {"x [m]", "y [m]", "z [m]", "t [s]", quantity.substr(0, quantity.find('_')) + unit});
  for (std::size_t line = 4; line < text.lines.size(); ++line) {
    if (io::is_comment(text.lines[line])) continue;
    const std::vector<double> numbers = values_after(text, line, separator, 1);  // without the number of the part
    if (numbers.size() + 1 != header.size()) {
      text.fail(line, fmt::format("{} entries, must be {}", numbers.size() + 1, header.size()));
    }
    for (std::size_t p = 0; p < places.front().size(); ++p) {
      rows.add(line, {places[0][p], places[1][p], places[2][p], numbers[0], numbers[p + 1]});
    }
  }
  return rows.table();
}

}  // namespace seiche::validation
