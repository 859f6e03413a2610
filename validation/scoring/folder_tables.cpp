#include "validation/scoring/folder_tables.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace seiche::validation {
namespace {

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
