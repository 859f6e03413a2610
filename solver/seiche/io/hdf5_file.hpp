#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace seiche::io {

/// A self-describing HDF5 file being written: every array carries its name, unit and meaning as attributes.
///
/// The same data give the same bytes: no object times are tracked. Every array carries checksums (Fletcher32), by which
/// HDF5 refuses to read damaged numbers.
class Hdf5File {
 public:
  /// @throws std::runtime_error (here and below) with the path, when the library cannot write.
  explicit Hdf5File(const std::filesystem::path& path);
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;
  ~Hdf5File();

  /// Makes a group; its parents must exist.
  void group(const std::string& path);
  /// Writes doubles in row-major order.
  /// @param shape  extents; their product must be values.size()
  void array(const std::string& path, std::span<const double> values, std::span<const std::size_t> shape,
             std::string_view name, std::string_view unit, std::string_view meaning);
  void array(const std::string& path, std::span<const double> values, std::string_view name, std::string_view unit,
             std::string_view meaning);
  void array(const std::string& path, std::span<const std::int32_t> values, std::string_view name,
             std::string_view unit, std::string_view meaning);

  void attribute(const std::string& object, const std::string& name, std::string_view text);
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, int value);

  /// Flushes and closes; the destructor closes without reporting errors.
  void close();

 private:
  void describe(const std::string& path, std::string_view name, std::string_view unit, std::string_view meaning);

  struct Handle;
  std::unique_ptr<Handle> handle_;
};

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
