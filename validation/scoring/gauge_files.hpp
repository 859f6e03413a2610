/// Series at gauges and points whose files say where they are: rows with the position of their gauge.
#pragma once

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// The numbers within the first brackets of a line: "location=( 0.5 1 )".
std::vector<double> bracketed(const io::Text& text, std::size_t line);

/// GeoClaw's gaugeNNNNN.txt; of several layers the surface, and q1, q2, ... as its header counts them.
io::Table read_geoclaw(const io::Text& text);
/// REEF3D-*-WSF-HG.dat.
io::Table read_reef3d(const io::Text& text);
/// DualSPHysics' MeasureTool, in any order of the positions.
io::Table read_measuretool(const io::Text& text);

}  // namespace seiche::validation
