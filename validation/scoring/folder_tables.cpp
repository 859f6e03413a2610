#include "validation/scoring/folder_tables.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/refusal.hpp"

namespace seiche::validation {
namespace {

bool same_places(const io::Table& one, const io::Table& other) {
  return std::ranges::all_of(std::array{"x", "y", "z", "t"}, [&](const char* name) {
    return one.has(name) == other.has(name) && (!one.has(name) || one.column(name) == other.column(name));
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

std::vector<io::Table> merged(const std::vector<io::Table>& parts) {
  std::vector<io::Table> tables;
  for (const io::Table& part : parts) {
    const auto same = std::ranges::find_if(tables, [&](const auto& t) { return same_places(t, part); });
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
    fail("{}: columns {}, but {} has {}", more.source, fmt::join(more.names, ", "), table.source,
         fmt::join(table.names, ", "));
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    table.columns[k].insert(table.columns[k].end(), more.columns[k].begin(), more.columns[k].end());
  }
  table.lines.insert(table.lines.end(), more.lines.begin(), more.lines.end());
}

void add_constant(io::Table& table, const std::string& name, const std::string& unit, double value) {
  table.names.push_back(name);
  table.units.push_back(unit);
  table.columns.emplace_back(table.rows(), value);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            const std::function<bool(const std::filesystem::path&)>& is_of_kind) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && is_of_kind(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace seiche::validation
