/// What OpenFOAM writes below postProcessing: probes and interface heights, sets along lines, and the folders of both.
///
/// A function writes into a folder per start of the run (series) or per time (sets):
///
///     probes/0/p, probes/2.5/p            one series: what a later folder repeats replaces what was before
///     line/0.1/line_alpha.water.xy        a set at a time; scalars in one file, each kind of vector in another
///
/// A set's file is called by the set, which has no underscore, and its fields: line_p_rgh_alpha.water.xy. One
/// coordinate is called x, three are x, y, z. A file of four columns and one field holds a vector if the field is U or
/// ends with it, otherwise three coordinates. A header of names, as later versions write it, goes before all that.
#pragma once

#include "seiche/io/text_table.hpp"
#include "validation/scoring/folder_tables.hpp"

namespace seiche::validation {

/// Probes ("# Probe 0 (x y z)") and interface heights ("# Location 0 ...").
io::Table read_openfoam(const io::Text& text);

/// A set's file; the time is the name of its folder, where that is a number.
io::Table read_openfoam_set(const std::filesystem::path& file);
bool is_openfoam_set(const std::filesystem::path& file);

/// All times of a function, or one of them: `probes`, `line/0.1`.
/// @throws std::invalid_argument for another folder, saying what is there
FolderTables read_openfoam_folder(const std::filesystem::path& folder);

}  // namespace seiche::validation
