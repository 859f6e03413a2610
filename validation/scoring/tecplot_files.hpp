/// Tecplot's text files in POINT form: a row of all variables for each point.
///
/// Zones become rows below each other, with their SOLUTIONTIME in a column t where every zone states one. A unit may
/// follow a variable's name in brackets or after a comma, "u [m/s]" or "u, m/s".
#pragma once

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// Whether a line names variables as Tecplot does: VARIABLES = ...
bool names_tecplot_variables(const std::string& line);

/// @throws std::invalid_argument in one line as read_text_table() does, for zones in BLOCK form or of finite elements,
/// and for several zones of which one does not say its time
io::Table read_tecplot(const io::Text& text);

}  // namespace seiche::validation
