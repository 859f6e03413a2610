#include "reports/evidence/standing.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/samples.hpp"

namespace seiche::evidence {
namespace {

std::string settings_of(const Record& record) {
  std::vector<std::string> all;
  for (const auto& [name, parameter] : record.parameters) {
    if (parameter.value == parameter.standard) continue;
    all.push_back(std::visit([&](const auto& value) { return fmt::format("{}={}", name, value); }, parameter.value));
  }
  return fmt::format("{}", fmt::join(all, ";"));
}

std::map<std::string, double> errors_of(const Record& record) {
  for (const JudgedClaim& one : record.claims()) {
    if (one.claim.id == "agreement") return {{"readings", std::abs(one.judgement.measured)}};
  }
  std::map<std::string, Worst> worst;
  for (const auto& [name, value] : record.measurements()) {
    for (const std::string measure : {"_relative_l1", "_relative_error"}) {
      const std::size_t end = name.find(measure);
      const std::size_t after = end + measure.size();
      if (end == std::string::npos || (after < name.size() && name[after] != '_')) continue;
      worst[name.substr(0, end)].add(value);
    }
  }
  std::map<std::string, double> errors;
  for (const auto& [quantity, of] : worst) errors[quantity] = of.value();
  return errors;
}

}  // namespace

Standing standing_of(const Record& record) {
  return {record.solver == "seiche" ? "" : settings_of(record), errors_of(record)};
}

}  // namespace seiche::evidence
