#include "seiche/io/table.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/hdf5_table.hpp"

namespace seiche::io {

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
  return is_hdf5(file) ? read_hdf5(file, wanted) : read_csv(file);
}

}  // namespace seiche::io
