#include "validation/studies/wcsph/spacing_ladder.hpp"

#include <cmath>

#include "reports/evidence/grid_convergence.hpp"
#include "validation/case/on_threads.hpp"

namespace seiche::validation {

std::vector<long> sph_ladder(Tier tier, long finest, int rungs) {
  if (tier == Tier::quick) return {finest};
  std::vector<long> ladder;
  for (int k = rungs - 1; k >= 0; --k)
    ladder.push_back(std::lround(static_cast<double>(finest) * std::pow(0.5, 0.5 * k)));
  return ladder;
}

void climb(Running& run, std::size_t sizes, const std::function<void(std::size_t)>& compute) {
  on_threads(
      sizes, workers_of(run.tier()), [&](std::size_t k) { compute(sizes - 1 - k); },
      [&](std::size_t done) { run.progress(static_cast<double>(done) / static_cast<double>(sizes)); });
}

void measure_convergence(evidence::Exhibit& exhibit, const std::string& id, const std::vector<double>& spacings,
                         const std::vector<double>& values) {
  if (spacings.size() < 3) return;
  const evidence::GridConvergence study = evidence::grid_convergence(spacings, values, 1);
  exhibit.measure("uncertainty_" + id, study.uncertainty);
  exhibit.measure("limit_" + id, study.extrapolated);
}

double resolution_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values) {
  return spacings.size() < 3 ? 0 : evidence::grid_convergence(spacings, values, 1).uncertainty;
}

}  // namespace seiche::validation
