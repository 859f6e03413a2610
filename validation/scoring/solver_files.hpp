/// Result files as solvers write them.
///
/// | format       | what it is | columns of the table |
/// |--------------|------------|----------------------|
/// | csv, hdf5    | table.hpp, hdf5_table.hpp | as named |
/// | delimited    | numbers between semicolons, tabs or blanks | as named, or as --columns says |
/// | openfoam     | what is below postProcessing (openfoam_files.hpp) | x, y, z, t, and the field, or hB and hL |
/// | geoclaw      | gaugeNNNNN.txt; fort.qNNNN (geoclaw_grids.hpp) | x, y, t, level, h, hu, hv, eta |
/// | reef3d       | REEF3D-*-WSF-HG.dat ("number of gauges:") | x, y, t, eta |
/// | dualsphysics | MeasureTool (" ;PosX [m]:;...") | x, y, z, t, and the quantity |
/// | swash        | tables with their header | t, eta, x, y, h, u, v; others as named |
/// | funwave      | sta_NNNN | t, eta, u, v |
/// | gerris       | OutputLocation ("# 1:t 2:x 3:y ...") | as named |
///
/// Gauges beside each other become gauges below each other, with their position in a column of its own. A series that
/// goes back in time was restarted: what the restart repeats replaces what was before.
///
/// A decimal comma is refused. Units are those that the file states; those of OpenFOAM, GeoClaw and REEF3D are SI.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "seiche/io/table.hpp"

namespace seiche::validation {

/// Names that --format takes, without "auto".
const std::vector<std::string>& solver_formats();

/// How files are to be read.
struct Reading {
  std::string format = "auto";            ///< one of solver_formats(), or "auto": the content decides
  std::vector<std::string> columns = {};  ///< names for a file that names none, or other ones; empty: as the file says
  std::vector<std::string> wanted = {};   ///< datasets to be read from an HDF5 file
  /// Positions of gauges [m], by the column or the file that holds them. Columns become rows, their values `gauge`.
  std::map<std::string, double> gauges = {};
};

struct ResultFile {
  io::Table table;
  std::string format;                             ///< that was recognised or asked for
  long replaced = 0;                              ///< rows that a restart repeats
  std::filesystem::path path = {};                ///< the file, or the folder
  std::vector<std::filesystem::path> files = {};  ///< that were read for this and the next tables
};

/// A file, or a folder of times: its tables, those of the same points as one.
/// @throws std::invalid_argument in one line that names the file, the line and what is wrong
std::vector<ResultFile> read_results(const std::filesystem::path& path, const Reading& how);

/// Files of the same columns as one, one below the other: gauges that are written to a file each.
std::vector<io::Table> joined(const std::vector<ResultFile>& files);

}  // namespace seiche::validation
