/// Result files as solvers write them.
///
/// | format       | what it is | columns of the table |
/// |--------------|------------|----------------------|
/// | csv, hdf5    | csv_table.hpp, hdf5_table.hpp | as named |
/// | delimited    | numbers between semicolons, tabs or blanks; comments with #, % or //; a line of names or none | as
/// named, or as --columns says | | openfoam     | postProcessing: probes ("# Probe 0 (x y z)"), interfaceHeight ("#
/// Location 0 ..."), scalars or (u v w) | x, y, z, t, and the file's name, or hB and hL | | geoclaw      |
/// gaugeNNNNN.txt ("# gauge_id= 1 location=( x y )") | x, y, t, level, h, hu, hv, eta | | reef3d       |
/// REEF3D-*-WSF-HG.dat ("number of gauges:") | x, y, t, eta | | dualsphysics | MeasureTool (" ;PosX [m]:;...") | x, y,
/// z, t, and the quantity |
///
/// Gauges beside each other become gauges below each other, with their position in a column of its own. A series that
/// goes back in time was restarted: what the restart repeats replaces what was before.
///
/// A decimal comma is refused. Units are those that the file states; those of OpenFOAM, GeoClaw and REEF3D are SI.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "seiche/io/table.hpp"

namespace seiche::validation {

/// Names that --format takes, without "auto".
const std::vector<std::string>& solver_formats();

struct ResultFile {
  io::Table table;
  std::string format;  ///< that was recognised or asked for
  long replaced = 0;   ///< rows that a restart repeats
};

/// @param format   one of solver_formats(), or "auto": the content decides
/// @param columns  names for a file that names none, or other ones: "t", "eta"; empty: as the file says
/// @param wanted   datasets to be read from an HDF5 file
/// @throws std::invalid_argument in one line that names the file, the line and what is wrong
ResultFile read_result(const std::filesystem::path& file, const std::string& format,
                       const std::vector<std::string>& columns, const std::vector<std::string>& wanted);

/// Files of the same columns as one, one below the other: gauges that are written to a file each.
std::vector<io::Table> joined(const std::vector<ResultFile>& files);

}  // namespace seiche::validation
