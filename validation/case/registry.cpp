#include "validation/case/registry.hpp"

#include <algorithm>

#include "seiche/wording.hpp"
#include "validation/case/refusal.hpp"

namespace seiche::validation {

const Case& find_case(std::string_view name) {
  const auto& cases = all_cases();
  const auto found = std::ranges::find_if(cases, [&](const Case& c) {
    return c.name == name || std::ranges::find(c.former_names, name) != c.former_names.end();
  });
  if (found != cases.end()) return *found;
  std::vector<std::string> names;
  for (const Case& one : cases) names.push_back(one.name);
  fail("unknown case '{}'{} 'seiche list' shows all cases", name, did_you_mean(name, names));
}

}  // namespace seiche::validation
