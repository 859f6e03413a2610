/// Independent computations side by side, on as many threads as the tier may use.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "validation/case/study.hpp"
#include "validation/case/tier.hpp"

namespace seiche::validation {

/// One in the quick tier, whose cases run side by side themselves; else one per core.
std::size_t workers_of(Tier tier);

/// work(k) for k = 0..count-1, begun in this order by `workers` threads of one OpenMP thread each. What work(k) writes
/// must be its own.
/// @param done  told how many are finished; never by two threads at once
/// Rethrows the exception of the lowest k that threw; those not yet begun by then are not.
void on_threads(std::size_t count, std::size_t workers, const std::function<void(std::size_t k)>& work,
                const std::function<void(std::size_t finished)>& done = {});
/// The same by the workers of a run's tier; the run is told how far it is.
void on_threads(const Run& run, std::size_t count, const std::function<void(std::size_t k)>& work);
/// One after another and on one thread each, or their times would be those of their neighbours.
void one_by_one(const Run& run, const std::vector<std::function<void()>>& work);

}  // namespace seiche::validation
