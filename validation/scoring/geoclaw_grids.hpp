/// GeoClaw's grids: fort.qNNNN, each with its time in fort.tNNNN, of one or two dimensions, as text.
///
/// A file holds patches of several levels of refinement. A cell that a patch of a higher level covers is left out, so
/// that every place has one value. Columns: x [m], in two dimensions y [m], t [s], then h, hu, (hv,) eta.
#pragma once

#include "validation/scoring/folder_tables.hpp"

namespace seiche::validation {

bool is_geoclaw_grid(const std::filesystem::path& file);
/// @throws std::invalid_argument where the time is missing, or the numbers are not as the header says
io::Table read_geoclaw_grid(const std::filesystem::path& file);

/// A folder with such files.
bool is_geoclaw_output(const std::filesystem::path& folder);
/// All times, one below the other.
FolderTables read_geoclaw_output(const std::filesystem::path& folder);

}  // namespace seiche::validation
