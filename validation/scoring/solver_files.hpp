/// Result files as solvers write them.
///
/// | format       | what it is | columns of the table |
/// |--------------|------------|----------------------|
/// | csv, delimited, swash, gerris | a table with names (text_table.hpp) | as named, or as --columns says |
/// | hdf5         | hdf5_table.hpp; netCDF 4 is HDF5 | as named |
/// | openfoam     | what is below postProcessing (openfoam_files.hpp) | x, y, z, t, and the field, or hB and hL |
/// | geoclaw      | gaugeNNNNN.txt; fort.qNNNN (geoclaw_grids.hpp) | x, y, t, level, h, hu, hv, eta |
/// | reef3d       | REEF3D-*-WSF-HG.dat ("number of gauges:") | x, y, t, eta |
/// | dualsphysics | MeasureTool (" ;PosX [m]:;...") | x, y, z, t, and the quantity |
/// | funwave      | sta_NNNN | t, eta, u, v |
/// | tecplot      | "VARIABLES =" and ordered ZONEs (tecplot_files.hpp) | as named, and t |
///
/// Gauges beside each other in a file that says where they are become gauges below each other, with their position in
/// columns of its own. A folder is one of OpenFOAM's functions, GeoClaw's output, or holds a station or gauge per file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// Names that --format takes, without "auto".
const std::vector<std::string>& solver_formats();

/// How files are to be read.
struct Reading {
  std::string format = "auto";            ///< one of solver_formats(), or "auto": the content decides
  std::vector<std::string> columns = {};  ///< names for a file that names none, or other ones; empty: as the file says
  std::vector<std::string> wanted = {};   ///< datasets to be read from an HDF5 file
};

struct ResultFile {
  io::Table table;
  std::string format;                             ///< that was recognised or asked for
  std::filesystem::path path = {};                ///< the file, or the folder
  std::vector<std::filesystem::path> files = {};  ///< that were read for this and the next tables
};

/// A file, or a folder of times: its tables, those of the same points as one.
/// @throws std::invalid_argument in one line that names the file, the line and what is wrong
std::vector<ResultFile> read_results(const std::filesystem::path& path, const Reading& how);

}  // namespace seiche::validation
