#include "validation/studies/wcsph/spacing_ladder.hpp"

#include <algorithm>
#include <cmath>

#include "reports/evidence/grid_convergence.hpp"
#include "validation/case/on_threads.hpp"

namespace seiche::validation {
namespace {

std::optional<evidence::GridConvergence> convergence_of(const std::vector<double>& spacings,
                                                        const std::vector<double>& values) {
  const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  if (spacings.size() < 3 || !finite) return std::nullopt;
  return evidence::grid_convergence(spacings, values, 1);
}

}  // namespace

std::vector<long> sph_ladder(Tier tier, long finest, int rungs) {
  if (tier == Tier::quick) return {finest};
  std::vector<long> ladder;
  for (int k = rungs - 1; k >= 0; --k)
    ladder.push_back(std::lround(static_cast<double>(finest) * std::pow(0.5, 0.5 * k)));
  return ladder;
}

void climb(const Run& run, std::size_t sizes, const std::function<void(std::size_t)>& compute) {
  on_threads(run, sizes, [&](std::size_t k) { compute(sizes - 1 - k); });
}

std::optional<double> resolution_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values) {
  const auto study = convergence_of(spacings, values);
  return study ? std::optional(study->uncertainty) : std::nullopt;
}

void measure_convergence(evidence::Exhibit& exhibit, const std::string& id, const std::vector<double>& spacings,
                         const std::vector<double>& values) {
  const auto study = convergence_of(spacings, values);
  if (!study) return;
  exhibit.measure("uncertainty_" + id, study->uncertainty);
  exhibit.measure("limit_" + id, study->extrapolated);
}

}  // namespace seiche::validation
