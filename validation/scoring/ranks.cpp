#include "validation/scoring/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "validation/scoring/baseline.hpp"

namespace seiche::validation {

std::vector<std::string> ranks(const std::filesystem::path& folder, const std::string& stem) {
  const auto own = evidence::read_summary(folder / (stem + ".json"));
  std::vector<evidence::Summary> others;
  for (const std::filesystem::path& file : evidence::record_files(folder)) {
    try {
      evidence::Summary other = evidence::read_summary(file);
      if (other.name == own.name && other.solver != own.solver) others.push_back(std::move(other));
    } catch (const std::runtime_error&) {
      continue;  // of somebody else: no verdict hangs on it
    }
  }
  std::vector<std::string> told;
  for (const auto& claim : own.claims) {
    std::vector<double> errors;
    for (const evidence::Summary& other : others) {
      const auto same = std::ranges::find(other.claims, claim.id, &evidence::Summary::Outcome::id);
      if (same != other.claims.end() && std::isfinite(same->measured)) errors.push_back(error_of(*same));
    }
    if (errors.empty() || claim.kind == "qualitative" || claim.kind == "roundoff") continue;
    const double error = error_of(claim);
    told.push_back(fmt::format("{}: error {:.3g}, better than {} of {}", claim.id, error,
                               std::ranges::count_if(errors, [&](double e) { return e > error; }), errors.size()));
  }
  return told;
}

}  // namespace seiche::validation
