#include "validation/case/registry.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

/// Number of single-letter edits between two words (Levenshtein distance).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

const Case& find_case(std::string_view name) {
  const auto& cases = all_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) {
    return c.name == name || std::find(c.former_names.begin(), c.former_names.end(), name) != c.former_names.end();
  });
  if (found != cases.end()) return *found;
  const auto nearest = std::min_element(cases.begin(), cases.end(), [&](const Case& a, const Case& b) {
    return edits(a.name, name) < edits(b.name, name);
  });
  throw std::invalid_argument(
      fmt::format("case {} is unknown: did you mean {}? 'seiche list' shows all", name, nearest->name));
}

}  // namespace seiche::validation
