#include "validation/scoring/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/standing.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/data_folder.hpp"

namespace seiche::validation {

std::string rank(const evidence::Record& record) {
  const evidence::Standing standing = evidence::standing_of(record);
  std::map<std::string, std::vector<double>> stored;
  for (const std::vector<std::string>& row : recorded_rows("solvers.csv")) {
    const auto error = io::number_in(row.at(6));
    if (row[0] == record.name && row[1] == standing.settings && row[3] != record.solver && error)
      stored[row[2]].push_back(*error);
  }
  std::vector<std::string> told;
  for (const auto& [quantity, error] : standing.errors) {
    const std::vector<double>& others = stored[quantity];
    if (others.empty() || std::isnan(error)) continue;
    told.push_back(fmt::format("{}: error {:.2g} %, smaller than {} of {} stored solvers on their finest cells",
                               quantity, 100 * error,
                               std::ranges::count_if(others, [&](double e) { return e > error; }), others.size()));
  }
  return fmt::format("{}", fmt::join(told, "; "));
}

}  // namespace seiche::validation
