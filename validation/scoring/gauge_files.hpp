/// Series at gauges and points as solvers write them, each into rows with the position of their gauge.
#pragma once

#include "validation/scoring/result_text.hpp"

namespace seiche::validation {

/// GeoClaw's gaugeNNNNN.txt.
io::Table read_geoclaw(const Text& text);
/// REEF3D-*-WSF-HG.dat.
io::Table read_reef3d(const Text& text);
/// DualSPHysics' MeasureTool, in any order of the positions.
io::Table read_measuretool(const Text& text);
/// FUNWAVE's sta_NNNN: time, elevation, velocities; the file does not say where.
io::Table read_funwave(const Text& text);
/// A table of SWASH with its header: quantities and units stand in comments. Tsec is called t, Watlev eta, Xp x, Yp y.
io::Table read_swash(const Text& text);

/// Gerris' OutputLocation ("# 1:t 2:x 3:y ..."): a row per time and location.
io::Table read_gerris(const Text& text);

/// Is this the opening of a SWASH table?
bool is_swash(const Text& opening);

}  // namespace seiche::validation
