#include "validation/scoring/openfoam_files.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/refusal.hpp"
#include "validation/scoring/gauge_files.hpp"

namespace seiche::validation {
namespace {

namespace fs = std::filesystem;

/// Fields in the name of a set's file: what follows the set. Only one usual name has an underscore.
std::vector<std::string> fields_of(const fs::path& file) {
  std::vector<std::string> fields;
  for (const std::string& word : io::words_of(file.stem().string(), "_")) {
    const bool joined = word == "rgh" && !fields.empty() && fields.back() == "p";
    if (joined) fields.pop_back();
    fields.push_back(joined ? "p_rgh" : word);
  }
  if (!fields.empty()) fields.erase(fields.begin());
  return fields;
}

std::vector<std::string> components_of(const std::string& field, std::size_t each) {
  if (each == 1) return {field};
  std::vector<std::string> names;
  for (std::size_t k = 0; k < each; ++k) {
    names.push_back(fmt::format("{}_{}", field, each == 3 ? std::string(1, "xyz"[k]) : std::to_string(k)));
  }
  return names;
}

bool is_velocity(const std::string& field) {
  return field.ends_with('U') || field.starts_with("U.");
}

/// Names of all columns of a set's file, by the file's name and how many there are; empty where that does not fit.
std::vector<std::string> names_by_file(const fs::path& file, std::size_t columns) {
  const std::vector<std::string> fields = fields_of(file);
  if (fields.empty()) return {};
  const bool vector_along_line = columns == 1 + 3 * fields.size() && is_velocity(fields.front());
  for (const std::size_t coordinates : {3UL, 1UL}) {
    for (const std::size_t each : {1UL, 3UL, 6UL, 9UL}) {
      if (columns != coordinates + each * fields.size() || (vector_along_line && coordinates == 3)) continue;
      std::vector<std::string> names{"x"};
      if (coordinates == 3) names.insert(names.end(), {"y", "z"});
      for (const std::string& field : fields) {
        const std::vector<std::string> components = components_of(field, each);
        names.insert(names.end(), components.begin(), components.end());
      }
      return names;
    }
  }
  return {};
}

/// Folders that are called by a number, by that number.
std::map<double, fs::path> times_in(const fs::path& folder) {
  std::map<double, fs::path> times;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::optional<double> time = io::number_in(entry.path().filename().string());
    if (entry.is_directory() && time) times[*time] = entry.path();
  }
  return times;
}

/// The sets of one time as one table.
io::Table sets_in(const std::vector<fs::path>& files, const fs::path& folder) {
  std::vector<io::Table> parts;
  std::ranges::transform(files, std::back_inserter(parts), read_openfoam_set);
  const std::vector<io::Table> tables = merged(parts);
  if (tables.size() > 1)
    fail("{}: {} sets of different points: name the files of one of them", folder.string(), tables.size());
  return tables.front();
}

}  // namespace

io::Table read_openfoam(const io::Text& text) {
  if (text.lines.empty()) fail("{}: no rows of numbers", text.file);
  std::vector<std::vector<double>> places;
  const std::string stem = std::filesystem::path(text.file).filename().string();
  const bool heights = text.lines.front().starts_with("# Location");
  std::vector<std::string> names;
  std::optional<io::Rows> rows;
  for (std::size_t line = 0; line < text.lines.size(); ++line) {
    const std::string& whole = text.lines[line];
    if (io::is_comment(whole)) {
      const bool place = whole.starts_with("# Probe") || whole.starts_with("# Location");
      if (place && whole.find('(') != std::string::npos) places.push_back(bracketed(text, line));
      continue;
    }
    const std::vector<double> numbers = io::values_of(text, line, io::words_of(whole, " \t()"));
    if (numbers.empty()) text.fail(line, "no numbers");
    const std::size_t values = numbers.size() - 1;
    if (places.empty())
      text.fail(line, "no position of a probe before it: '# Probe 0 (x y z)' or '# Location 0 : (x y z)'");
    if (values == 0 || values % places.size() != 0) {
      text.fail(line, fmt::format("{} values for {} probes", values, places.size()));
    }
    const std::size_t each = values / places.size();
    if (!rows) {
      names = heights && each == 2 ? std::vector<std::string>{"hB", "hL"} : components_of(stem, each);
      names.insert(names.begin(), {"x", "y", "z", "t"});
      rows.emplace(text, names);
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
  if (!rows) fail("{}: no rows of numbers", text.file);
  return rows->table();
}

bool is_openfoam_set(const fs::path& file) {
  return file.extension() == ".xy";
}

io::Table read_openfoam_set(const fs::path& file) {
  const io::Text text = io::text_of(file);
  io::Table table = io::read_text_table(text, {}, [&](std::size_t columns) {
    std::vector<std::string> names = names_by_file(file, columns);
    if (names.empty()) {
      fail("{}: {} columns do not fit the name of the file, SET_FIELD_FIELD.xy: say them by --columns", text.file,
           columns);
    }
    return names;
  });
  const auto time = io::number_in(file.parent_path().filename().string());
  if (time && !table.has("t")) add_constant(table, "t", "", *time);
  return table;
}

FolderTables read_openfoam_folder(const fs::path& folder) {
  FolderTables read{.format = "openfoam"};
  const fs::path plain = folder.has_filename() ? folder : folder.parent_path();
  std::map<double, fs::path> times = times_in(plain);
  if (const auto own = io::number_in(plain.filename().string()); own && times.empty()) times[*own] = plain;
  if (times.empty()) {
    std::set<std::string> there;
    for (const auto& entry : fs::directory_iterator(plain)) there.insert(entry.path().filename().string());
    fail("{}: is a folder without times; name the folder of one function, as in postProcessing/probes; it contains {}",
         plain.string(), fmt::join(there | std::views::take(8), ", "));
  }
  std::map<std::string, io::Table> series;  // by name of the file, over the starts of the run
  std::optional<io::Table> sets;
  const auto is_any = [](const fs::path&) { return true; };
  for (const auto& [time, at] : times) {
    const std::vector<fs::path> lines = files_in(at, is_openfoam_set);
    const std::vector<fs::path> files = lines.empty() ? files_in(at, is_any) : lines;
    read.files.insert(read.files.end(), files.begin(), files.end());
    if (!lines.empty()) {
      const io::Table now = sets_in(lines, at);
      if (sets) {
        put_below(*sets, now);
      } else {
        sets = now;
        sets->source = plain.string();
      }
      continue;
    }
    for (const fs::path& file : files) {
      const io::Table now = read_openfoam(io::text_of(file));
      const auto [place, fresh] = series.emplace(file.filename().string(), now);
      if (!fresh) {
        put_below(place->second, now);
        place->second.source = (plain / file.filename()).string();
      }
    }
  }
  if (sets) {
    read.tables.push_back(*sets);
    return read;
  }
  if (series.empty()) fail("{}: its folders of times are empty", plain.string());
  for (auto& [name, table] : series) read.tables.push_back(std::move(table));
  return read;
}

}  // namespace seiche::validation
