#include "validation/scoring/solver_files.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/hdf5_table.hpp"
#include "seiche/io/table.hpp"
#include "validation/scoring/gauge_files.hpp"
#include "validation/scoring/geoclaw_grids.hpp"
#include "validation/scoring/openfoam_files.hpp"

namespace seiche::validation {
namespace {

/// What stands between the entries of a line. A comma within the first word may be that of a decimal number.
char separator_of(const std::string& line) {
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string::npos) return separator;
  }
  return entries_of(line, ',').size() > 1 && !has_decimal_comma(words_of(line, " ").front()) ? ',' : ' ';
}

/// Blanks part a unit in brackets from its name as well.
std::vector<std::string> with_units(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    if (word.starts_with('[') && !names.empty()) {
      names.back() += word;
    } else {
      names.push_back(word);
    }
  }
  return names;
}

io::Table read_delimited(const Text& text, const std::vector<std::string>& columns) {
  // Names may stand in the last comment before the numbers; the first line that is none decides on the separator.
  std::size_t first = 0;
  while (first < text.lines.size() && is_comment(text.lines[first])) ++first;
  if (first == text.lines.size()) throw std::invalid_argument(fmt::format("{}: no rows of numbers", text.file));
  const std::string& opening = text.lines[first];
  const char separator = separator_of(opening);
  const auto split = [&](std::string line) {
    std::erase(line, '"');
    return separator == ' ' ? words_of(line, " \t") : entries_of(line, separator);
  };
  std::vector<std::string> names = with_units(split(opening));
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
    if (bracket == 0) text.fail(first, fmt::format("{}: a unit without the name of its column", names[k]));
    units[k] = names[k].substr(bracket + 1, names[k].size() - bracket - 2);
    const std::vector<std::string> words = words_of(names[k].substr(0, bracket), " \t");
    if (words.empty()) text.fail(first, fmt::format("column {} has no name", k + 1));
    names[k] = words.front();
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

std::string recognised(const Text& text) {
  const std::filesystem::path file = text.file;
  if (is_openfoam_set(file)) return "openfoam";
  if (is_geoclaw_grid(file)) return "geoclaw";
  if (text.lines.empty()) return "csv";
  const std::string& first = text.lines.front();
  if (first.starts_with("# Probe") || first.starts_with("# Location")) return "openfoam";
  if (first.find("gauge_id=") != std::string::npos) return "geoclaw";
  if (first.starts_with("number of gauges:")) return "reef3d";
  if (first.find("PosX [m]:") != std::string::npos) return "dualsphysics";
  if (first.starts_with("# 1:t ")) return "gerris";
  if (is_swash(text)) return "swash";
  if (file.filename().string().starts_with("sta_")) return "funwave";
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
  using Gauge = std::array<double, 3>;
  const std::vector<double>& t = table.column("t");
  const auto gauge = [&](std::size_t row) {
    Gauge at{};
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      const std::string name(1, "xyz"[axis]);
      if (table.has(name)) at[axis] = table.column(name)[row];
    }
    return at;
  };
  std::map<Gauge, double> earliest;  // of the rows that follow, by gauge
  std::vector<bool> stays(t.size());
  for (std::size_t row = t.size(); row-- > 0;) {
    const Gauge here = gauge(row);
    const auto next = earliest.find(here);
    stays[row] = next == earliest.end() || t[row] < next->second;
    if (stays[row]) earliest[here] = t[row];
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

/// Columns that are gauges beside each other become rows below each other: x, what all gauges share, and `gauge`.
/// A gauge may also be a file's name: then all of its rows get the position.
io::Table with_gauges(const io::Table& wide, const std::map<std::string, double>& gauges, const std::string& file) {
  io::Table table{.source = wide.source, .names = {"x"}, .units = {"m"}, .columns = {{}}, .lines = {}};
  if (const auto whole = gauges.find(file); whole != gauges.end()) {
    if (wide.has("x")) throw std::invalid_argument(fmt::format("{}: has a column x of its own", wide.source));
    table.columns.front().assign(wide.rows(), whole->second);
    table.names.insert(table.names.end(), wide.names.begin(), wide.names.end());
    table.units.insert(table.units.end(), wide.units.begin(), wide.units.end());
    table.columns.insert(table.columns.end(), wide.columns.begin(), wide.columns.end());
    table.lines = wide.lines;
    return table;
  }
  std::vector<std::size_t> shared;
  std::vector<std::size_t> beside;
  for (std::size_t k = 0; k < wide.names.size(); ++k) {
    (gauges.contains(wide.names[k]) ? beside : shared).push_back(k);
  }
  if (beside.empty()) return wide;
  for (const std::size_t k : shared) {
    if (wide.names[k] == "x") throw std::invalid_argument(fmt::format("{}: has a column x of its own", wide.source));
    table.names.push_back(wide.names[k]);
    table.units.push_back(wide.units[k]);
  }
  table.names.emplace_back("gauge");
  table.units.push_back(wide.units[beside.front()]);
  table.columns.resize(table.names.size());
  for (const std::size_t column : beside) {
    for (std::size_t row = 0; row < wide.rows(); ++row) {
      table.columns.front().push_back(gauges.at(wide.names[column]));
      for (std::size_t k = 0; k < shared.size(); ++k) table.columns[k + 1].push_back(wide.columns[shared[k]][row]);
      table.columns.back().push_back(wide.columns[column][row]);
      if (row < wide.lines.size()) table.lines.push_back(wide.lines[row]);
    }
  }
  return table;
}

io::Table read_text(const std::filesystem::path& file, const std::string& format,
                    const std::vector<std::string>& columns) {
  if (format == "openfoam" && is_openfoam_set(file)) return read_openfoam_set(file);
  if (format == "geoclaw" && is_geoclaw_grid(file)) return read_geoclaw_grid(file);
  const Text text = text_of(file);
  if (text.lines.empty()) throw std::invalid_argument(fmt::format("{}: no rows of numbers", file.string()));
  if (format == "openfoam") return read_openfoam(text);
  if (format == "geoclaw") return read_geoclaw(text);
  if (format == "reef3d") return read_reef3d(text);
  if (format == "dualsphysics") return read_measuretool(text);
  if (format == "swash") return read_swash(text);
  if (format == "gerris") return read_gerris(text);
  if (format == "funwave") return read_funwave(text);
  return read_delimited(text, columns);
}

ResultFile read_file(const std::filesystem::path& file, const Reading& how) {
  if (how.format == "hdf5" || (how.format == "auto" && io::is_hdf5(file))) {
    return {.table = io::read_hdf5(file, how.wanted), .format = "hdf5", .files = {file}};
  }
  std::string chosen = how.format;
  // A file that is not text, or whose lines never end, is refused by the reader of CSV before all of it is held.
  if (chosen == "auto") chosen = how.columns.empty() ? recognised(opening_of(file)) : "delimited";
  if (chosen == "csv") return {.table = io::read_csv(file), .format = "csv", .files = {file}};
  ResultFile result{.table = read_text(file, chosen, how.columns), .format = chosen, .files = {file}};
  result.replaced = replace_restarted(result.table);
  return result;
}

std::vector<ResultFile> read_folder(const std::filesystem::path& folder, const Reading& how) {
  const FolderTables read = is_geoclaw_output(folder) ? read_geoclaw_output(folder) : read_openfoam_folder(folder);
  std::vector<io::Table> tables = read.tables;
  long replaced = 0;
  for (io::Table& table : tables) replaced += table.has("t") && read.series ? replace_restarted(table) : 0;
  std::vector<ResultFile> results;
  for (const io::Table& table : merged(tables)) {
    results.push_back({.table = table, .format = read.format});
  }
  results.front().replaced = replaced;
  results.front().files = read.files;
  if (how.format != "auto" && how.format != read.format) {
    throw std::invalid_argument(
        fmt::format("{}: --format {}: is a folder of {}", folder.string(), how.format, read.format));
  }
  return results;
}

}  // namespace

const std::vector<std::string>& solver_formats() {
  static const std::vector<std::string> names{"csv",    "hdf5",         "delimited", "openfoam", "geoclaw",
                                              "reef3d", "dualsphysics", "swash",     "funwave",  "gerris"};
  return names;
}

std::vector<ResultFile> read_results(const std::filesystem::path& path, const Reading& how) {
  std::vector<ResultFile> results;
  if (std::filesystem::is_directory(path)) {
    results = read_folder(path, how);
  } else {
    results.push_back(read_file(path, how));
  }
  for (ResultFile& one : results) one.path = path;
  if (!how.gauges.empty()) {
    for (ResultFile& one : results) one.table = with_gauges(one.table, how.gauges, path.filename().string());
  }
  return results;
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
