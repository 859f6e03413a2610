#pragma once

#include <cstddef>

#include "seiche/flush_denormals.hpp"

namespace seiche::linear {

/// `usual`, a size from which on a loop is worth threads; less in a build whose threads are to be looked at
/// (SEICHE_THREADS_FROM, set with the thread sanitizer).
constexpr std::size_t threads_from([[maybe_unused]] std::size_t usual) {
#ifdef SEICHE_THREADS_FROM
  return SEICHE_THREADS_FROM;
#else
  return usual;
#endif
}

/// Unknowns below which passes over a lattice or a row stay on one thread. Two idle cores pay from 2e4 unknowns on; on
/// a machine whose cores are busy every pass waits for a time slice of the other thread, 4 ms, which small systems do
/// not make good.
inline constexpr std::size_t worth_threads = threads_from(98304);

/// Calls work(k) for k = 0, ..., count - 1, on all threads if they are worth it, all without denormal numbers: the
/// processor's switch for them belongs to a thread.
template <class Work>
void share_out(std::size_t count, [[maybe_unused]] bool worth_it, const Work& work) {
#pragma omp parallel if (worth_it)
  {
    const FlushDenormals guard;
#pragma omp for schedule(static) nowait
    for (std::size_t k = 0; k < count; ++k) work(k);
  }
}

}  // namespace seiche::linear
