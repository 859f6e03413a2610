#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace seiche::io {

/// One time level of a field on a polyline, held in an HDF5 file: points is an N x 3 array, fields are N values each.
struct XdmfFrame {
  double time = 0;
  std::size_t points = 0;
  std::string points_path;                                  ///< inside the HDF5 file
  std::vector<std::pair<std::string, std::string>> fields;  ///< name, path inside the HDF5 file
};

/// Text of an XDMF 3 file through which ParaView opens the frames of `hdf5_name` (a file in the same folder).
std::string xdmf(const std::string& hdf5_name, const std::vector<XdmfFrame>& frames);

}  // namespace seiche::io
