#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace seiche::io {

/// One array of values at the points.
struct XdmfField {
  std::string name;
  std::string path;            ///< inside the HDF5 file
  std::size_t components = 1;  ///< 1: a scalar, N values; 3: a vector, an N x 3 array
  bool integer = false;        ///< 32 bits, otherwise double
};

/// One time level of fields at points, held in an HDF5 file: points is an N x 3 array.
struct XdmfFrame {
  enum class Topology { polyline, polyvertex };

  double time = 0;
  std::size_t points = 0;
  std::string points_path;  ///< inside the HDF5 file
  std::vector<XdmfField> fields;
  Topology topology = Topology::polyline;
};

/// Text of an XDMF 3 file through which ParaView opens the frames of `hdf5_name` (a file in the same folder).
std::string xdmf(const std::string& hdf5_name, const std::vector<XdmfFrame>& frames);

}  // namespace seiche::io
