#include "validation/case/registry.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/wording.hpp"

namespace seiche::validation {

const Case& find_case(std::string_view name) {
  const auto& cases = all_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) {
    return c.name == name || std::find(c.former_names.begin(), c.former_names.end(), name) != c.former_names.end();
  });
  if (found != cases.end()) return *found;
  std::vector<std::string> names;
  for (const Case& one : cases) names.push_back(one.name);
  throw std::invalid_argument(
      fmt::format("unknown case '{}'{} 'seiche list' shows all cases", name, did_you_mean(name, names)));
}

}  // namespace seiche::validation
