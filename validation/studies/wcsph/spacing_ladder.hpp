/// Resolution studies of particle runs, as far as a tier affords them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "validation/case/case.hpp"

namespace seiche::validation {

/// Numbers of spacings, ascending: of the quick tier only the finest, otherwise `rungs` of them, each 0.7 of the next.
/// Particles scatter what they converge to, so that three lattices show a trend only over a factor wider than two.
std::vector<long> sph_ladder(Tier tier, long finest, int rungs = 3);

/// compute(size) for each index of the ladder, the costliest first, side by side as the tier allows.
void climb(const Run& run, std::size_t sizes, const std::function<void(std::size_t size)>& compute);

/// Half-width (95 %) of the numerical uncertainty of the value on the finest lattice, by grid convergence of first
/// order; none, for it cannot be estimated, with fewer than three lattices or a value that is not a finite number.
std::optional<double> resolution_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values);

/// Keeps it as `uncertainty_<id>`, and the value that the lattices are heading for as `limit_<id>`, where it can be
/// estimated.
void measure_convergence(evidence::Exhibit& exhibit, const std::string& id, const std::vector<double>& spacings,
                         const std::vector<double>& values);

}  // namespace seiche::validation
