/// Processor time of short computations.
#pragma once

#include <functional>

namespace seiche::validation {

/// Processor time that this process has used so far [s].
double processor_seconds();

/// Processor time of one call of `work` [s]: the shortest mean of three batches of calls that fill 20 ms each, or of as
/// many as begin within 0.3 s.
double shortest_time(const std::function<void()>& work);

}  // namespace seiche::validation
