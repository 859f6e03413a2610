#pragma once

#include <cstddef>

namespace seiche::linear {

/// Unknowns below which passes over a lattice stay on one thread. Two idle cores pay from 2e4 unknowns on; on a machine
/// whose cores are busy every pass waits for a time slice of the other thread, 4 ms, which small systems do not make
/// good.
inline constexpr std::size_t worth_threads = 131072;

}  // namespace seiche::linear
