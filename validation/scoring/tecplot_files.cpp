#include "validation/scoring/tecplot_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "validation/scoring/submitted.hpp"

namespace seiche::validation {
namespace {

/// Key, value, key, ... of a line in capitals, without what stands in quotes.
std::vector<std::string> settings_of(const std::string& line) {
  std::string bare;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    bare += quoted || c == '"' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return io::words_of(bare, " \t,=");
}

/// Names of a line of variables: what stands in quotes, or words.
std::vector<std::string> variables_of(const std::string& line) {
  const bool quoted = line.find('"') != std::string::npos;
  std::vector<std::string> parts = io::words_of(line.substr(line.find('=') + 1), quoted ? "\"" : " \t,");
  if (quoted) std::erase_if(parts, [](const auto& part) { return part.find_first_not_of(" \t,") == part.npos; });
  for (std::string& name : parts) {
    if (const std::size_t comma = name.find(','); comma != std::string::npos && name.find('[') == std::string::npos)
      name = fmt::format("{} [{}]", name.substr(0, comma), name.substr(comma + 1));
  }
  return parts;
}

}  // namespace

bool names_tecplot_variables(const std::string& line) {
  const std::vector<std::string> words = settings_of(line);
  return !words.empty() && words.front() == "VARIABLES";
}

io::Table read_tecplot(const io::Text& text) {
  io::Text rows = text;
  std::vector<std::string> names;
  std::vector<double> times;  // of the rows
  std::vector<std::size_t> zones;
  double time = nan;
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    const std::vector<std::string> words = settings_of(text.lines[line]);
    const bool named = text.lines[line].find('"') != std::string::npos && zones.empty() && !names.empty();
    if (words.empty() && !named) continue;
    if (!words.empty() && io::value_in(words.front())) {
      times.push_back(time);
      continue;
    }
    rows.lines[line].clear();
    if (words.empty() || words.front() == "VARIABLES")
      std::ranges::move(variables_of(text.lines[line]), std::back_inserter(names));
    if (!words.empty() && words.front() == "ZONE") {
      zones.push_back(line);
      time = nan;
    }
    for (std::size_t k = 0; k + 1 < words.size() && !zones.empty(); ++k) {
      if (words[k + 1] == "BLOCK" || words[k + 1].starts_with("FE"))
        text.fail(line, fmt::format("{} = {}: write ordered zones in POINT form", words[k], words[k + 1]));
      if (words[k] == "SOLUTIONTIME") time = io::number_in(words[k + 1]).value_or(time);
    }
  }
  io::Table table = io::read_text_table(rows, names);
  const auto is_time = [](const std::string& name) { return name == "t" || plain_name(name) == "time"; };
  if (std::ranges::any_of(table.names, is_time)) return table;
  const bool timed = std::ranges::none_of(times, [](double t) { return std::isnan(t); });
  if (zones.size() > 1 && !timed) text.fail(zones[1], "a second zone: every ZONE must state its SOLUTIONTIME");
  if (!timed || times.size() != table.rows()) return table;
  table.names.emplace_back("t");
  table.units.emplace_back("s");
  table.columns.push_back(times);
  return table;
}

}  // namespace seiche::validation
