#pragma once

#include <vector>

#include "reports/evidence/record_files.hpp"

namespace seiche::command {

/// Prints, for every case that several solvers have a record of, a column per solver: verdict and distance from what is
/// expected in units of the limit per claim; what it took, time, cells and threads, as it was stated; orders of
/// ladders; the measurements that they share.
///
/// @returns whether every one of these records is as declared; true where there are none
bool print_side_by_side(const std::vector<evidence::Summary>& records);

}  // namespace seiche::command
