/// Resolution studies of particle runs, as far as a tier affords them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/case/case.hpp"

namespace seiche::validation {

/// Numbers of spacings, ascending: of the quick tier only the finest, otherwise `rungs` of them, each 0.7 of the next.
/// Particles scatter what they converge to, so that three lattices show a trend only over a factor wider than two.
std::vector<long> sph_ladder(Tier tier, long finest, int rungs = 3);

/// compute(size) for each index of the ladder, the costliest first, side by side as the tier allows.
void climb(Running& run, std::size_t sizes, const std::function<void(std::size_t size)>& compute);

/// Keeps `uncertainty_<id>` of the value on the finest lattice, by grid convergence of first order, and the value that
/// it is heading for, `limit_<id>`; nothing with fewer than three lattices.
void measure_convergence(evidence::Exhibit& exhibit, const std::string& id, const std::vector<double>& spacings,
                         const std::vector<double>& values);

/// The same uncertainty; 0, not estimated, with fewer than three lattices.
double resolution_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values);

}  // namespace seiche::validation
