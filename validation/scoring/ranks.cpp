#include "validation/scoring/ranks.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "seiche/samples.hpp"
#include "validation/case/data_folder.hpp"

namespace seiche::validation {
namespace {

/// Parameters that are not their defaults, as the table has them.
std::string settings_of(const evidence::Record& record) {
  std::vector<std::string> all;
  for (const auto& [name, parameter] : record.parameters) {
    if (parameter.value == parameter.standard) continue;
    all.push_back(std::visit([&](const auto& value) { return fmt::format("{}={}", name, value); }, parameter.value));
  }
  return fmt::format("{}", fmt::join(all, ";"));
}

/// Of every quantity the largest over gauges and instants; of an experiment the difference that its readings share,
/// since a curve holds the time that a gate takes as well.
std::map<std::string, Worst> errors_of(const evidence::Record& record) {
  std::map<std::string, Worst> errors;
  for (const evidence::JudgedClaim& one : record.claims()) {
    if (one.claim.id != "agreement") continue;
    errors["readings"].add(one.judgement.measured);
    return errors;
  }
  for (const auto& [name, value] : record.measurements()) {
    for (const std::string measure : {"_relative_l1", "_relative_error"}) {
      const std::size_t end = name.find(measure);
      const std::size_t after = end + measure.size();
      if (end == std::string::npos || (after < name.size() && name[after] != '_')) continue;
      errors[name.substr(0, end)].add(value);
    }
  }
  return errors;
}

}  // namespace

std::string rank(const evidence::Record& record) {
  const std::string settings = settings_of(record);
  std::map<std::string, std::vector<double>> stored;
  for (const std::vector<std::string>& row : recorded_rows("solvers.csv")) {
    const auto error = io::number_in(row.at(6));
    if (row[0] == record.name && row[1] == settings && row[3] != record.solver && error)
      stored[row[2]].push_back(*error);
  }
  std::vector<std::string> told;
  for (const auto& [quantity, worst] : errors_of(record)) {
    const double error = worst.value();
    const std::vector<double>& others = stored[quantity];
    if (others.empty()) continue;
    told.push_back(fmt::format("{}: error {:.2g} %, smaller than {} of {} stored solvers on their finest cells",
                               quantity, 100 * error,
                               std::ranges::count_if(others, [&](double e) { return e > error; }), others.size()));
  }
  return fmt::format("{}", fmt::join(told, "; "));
}

}  // namespace seiche::validation
