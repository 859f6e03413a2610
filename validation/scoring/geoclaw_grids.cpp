#include "validation/scoring/geoclaw_grids.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "seiche/io/text_table.hpp"
#include "validation/case/refusal.hpp"

namespace seiche::validation {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view opening = "fort.q";

struct Patch {
  double level = 0;
  std::vector<std::size_t> cells;  ///< along x, and y
  std::vector<double> low, size;   ///< corner and edges of a cell
  std::vector<std::size_t> lines;  ///< of its cells, along x first

  [[nodiscard]] bool plan() const { return cells.size() == 2; }
  [[nodiscard]] double at(std::size_t axis, std::size_t cell) const {
    return low[axis] + (static_cast<double>(cell) + 0.5) * size[axis];
  }
  [[nodiscard]] bool covers(const std::vector<double>& place) const {
    for (std::size_t axis = 0; axis < cells.size(); ++axis) {
      const double beyond = place[axis] - low[axis];
      if (beyond < 0 || beyond > static_cast<double>(cells[axis]) * size[axis]) return false;
    }
    return true;
  }
};

/// Of fort.t: the time stands in its first line, before the word `time`.
double time_of(const fs::path& grid) {
  const std::string number = grid.filename().string().substr(opening.size());
  const io::Text text = io::text_of(grid.parent_path() / ("fort.t" + number));
  if (text.lines.empty()) fail("{}: is empty, must say the time", text.file);
  const std::vector<std::string> words = io::words_of(text.lines.front());
  const std::optional<double> time = io::number_in(words.empty() ? "" : words.front());
  if (!time) text.fail(0, "must begin with the time");
  return *time;
}

void skip_blank(const io::Text& text, std::size_t& line) {
  while (line < text.lines.size() && io::words_of(text.lines[line]).empty()) ++line;
}

/// Reads "number   what" lines up to the blank one; `line` is then the first of the cells.
Patch header_at(const io::Text& text, std::size_t& line) {
  Patch patch;
  for (; line < text.lines.size(); ++line) {
    const std::vector<std::string> words = io::words_of(text.lines[line]);
    if (words.empty()) break;
    if (words.size() != 2) text.fail(line, "must be a number and what it is: the header of a patch");
    const double value = io::values_of(text, line, {words[0]}).front();
    const std::string& what = words[1];
    if (what == "AMR_level" || what == "level") patch.level = value;
    if (what == "mx" || what == "my") {
      if (!(value >= 1 && value <= 1e7)) text.fail(line, fmt::format("{} = {:g}, must be in [1, 1e7]", what, value));
      patch.cells.push_back(static_cast<std::size_t>(value));
    }
    if (what == "xlow" || what == "ylow") patch.low.push_back(value);
    if (what == "dx" || what == "dy") patch.size.push_back(value);
  }
  skip_blank(text, line);
  const std::size_t dimensions = patch.cells.size();
  if (dimensions == 0 || dimensions > 2 || patch.low.size() != dimensions || patch.size.size() != dimensions) {
    text.fail(std::min(line, text.lines.size() - 1),
              "a header must have mx, xlow, dx, and in two dimensions my, ylow, dy");
  }
  return patch;
}

/// `line` is then the first behind them that is not blank.
void take_cells(const io::Text& text, std::size_t& line, Patch& patch) {
  const std::size_t count =
      std::accumulate(patch.cells.begin(), patch.cells.end(), std::size_t{1}, std::multiplies<>());
  for (; patch.lines.size() < count && line < text.lines.size(); skip_blank(text, ++line)) patch.lines.push_back(line);
  const std::size_t left = count - patch.lines.size();
  if (left > 0) text.fail(text.lines.size() - 1, fmt::format("ends {} cells before the patch does", left));
}

std::vector<std::string> names_for(const io::Text& text, const Patch& patch, std::size_t values) {
  const bool plan = patch.plan();
  std::vector<std::string> names{"x", "t", "h", "hu", "eta"};
  if (plan) names = {"x", "y", "t", "h", "hu", "hv", "eta"};
  const std::size_t places = plan ? 3 : 2;
  if (places + values + 1 == names.size()) names.pop_back();  // without eta: Clawpack's shallow water
  if (places + values != names.size())
    text.fail(patch.lines.front(),
              fmt::format("{} values in a cell, must be h, hu{}, eta", values, plan ? ", hv" : ""));
  return names;
}

}  // namespace

bool is_geoclaw_grid(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with(opening) && name.size() > opening.size() &&
         io::number_in(std::string_view(name).substr(opening.size())).has_value();
}

io::Table read_geoclaw_grid(const fs::path& file) {
  const double time = time_of(file);
  const io::Text text = io::text_of(file);
  std::vector<Patch> patches;
  for (std::size_t line = 0; line < text.lines.size();) {
    patches.push_back(header_at(text, line));
    if (patches.back().plan() != patches.front().plan()) {
      text.fail(line - 1, "a patch of one dimension beside one of two, must all be alike");
    }
    take_cells(text, line, patches.back());
  }
  if (patches.empty()) fail("{}: no patches", text.file);
  const std::size_t values = io::words_of(text.lines[patches.front().lines.front()]).size();
  io::Rows rows(text, names_for(text, patches.front(), values));
  std::vector<std::pair<std::vector<double>, std::size_t>> cells;  // row and line
  for (const Patch& patch : patches) {
    for (std::size_t k = 0; k < patch.lines.size(); ++k) {
      std::vector<double> row{patch.at(0, k % patch.cells[0])};
      if (patch.plan()) row.push_back(patch.at(1, k / patch.cells[0]));
      const auto hides = [&](const Patch& other) { return other.level > patch.level && other.covers(row); };
      if (std::ranges::any_of(patches, hides)) continue;
      row.push_back(time);
      const std::size_t line = patch.lines[k];
      const std::vector<double> numbers = io::values_of(text, line, io::words_of(text.lines[line]));
      if (numbers.size() != values) text.fail(line, fmt::format("{} entries, must be {}", numbers.size(), values));
      row.insert(row.end(), numbers.begin(), numbers.end());
      cells.emplace_back(row, line);
    }
  }
  // Along x whatever patch they are of; in two dimensions row by row.
  const bool plan = patches.front().plan();
  std::ranges::stable_sort(cells, {},
                           [&](const auto& cell) { return std::pair(plan ? cell.first[1] : 0, cell.first[0]); });
  for (const auto& [row, line] : cells) rows.add(line, row);
  return rows.table();
}

bool is_geoclaw_output(const fs::path& folder) {
  return !files_in(folder, is_geoclaw_grid).empty();
}

FolderTables read_geoclaw_output(const fs::path& folder) {
  FolderTables read{.format = "geoclaw", .files = files_in(folder, is_geoclaw_grid)};
  for (const fs::path& file : read.files) {
    const io::Table now = read_geoclaw_grid(file);
    if (!read.tables.empty()) {
      put_below(read.tables.front(), now);
      continue;
    }
    read.tables.push_back(now);
    read.tables.front().source = folder.string();
  }
  return read;
}

}  // namespace seiche::validation
