#include "seiche/exact/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

Evaluator ExactSolution::evaluator(const std::map<std::string, double>& values) const {
  std::map<std::string, double> complete;
  std::string known;
  for (const Parameter& parameter : parameters) {
    complete[parameter.name] = parameter.default_value;
    known += (known.empty() ? "" : ", ") + parameter.name;
  }
  for (const auto& [key, value] : values) {
    const auto place = complete.find(key);
    if (place == complete.end()) {
      throw std::invalid_argument(fmt::format("{} is not a parameter of {}: it has {}", key, name, known));
    }
    place->second = value;
  }
  for (const Parameter& parameter : parameters) {
    require_within(parameter.name, complete[parameter.name], parameter.minimum, parameter.maximum);
  }
  return factory(complete);
}

const std::vector<ExactSolution>& catalogue() {
  static const std::vector<ExactSolution> solutions{
      riemann_entry(),     bore_reflection_entry(), simple_wave_entry(),
      steady_bump_entry(), macdonald_entry(),       thacker_entry(),
  };
  return solutions;
}

const ExactSolution* find_solution(std::string_view name) {
  const auto& all = catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ExactSolution& s) { return s.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace seiche::exact
