#include "seiche/io/hdf5_file.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <H5Cpp.h>
#include <fmt/format.h>
#include <pugixml.hpp>

#include "seiche/require_that.hpp"

namespace seiche::io {
namespace {

constexpr hsize_t largest_chunk = hsize_t{64} << 20U;  // [byte]

/// Checksums are those of chunks: the whole array, or as many of its rows as fit.
std::vector<hsize_t> chunk_of(std::vector<hsize_t> extents, std::size_t element) {
  hsize_t row = element;
  for (std::size_t k = 1; k < extents.size(); ++k) row *= extents[k];
  extents.front() = std::min(extents.front(), std::max<hsize_t>(1, largest_chunk / row));
  return extents;
}

/// A file of HDF5 1.10 and later: its own structures carry checksums too, and an array of one chunk needs no index.
H5::H5File created(const std::filesystem::path& path) {
  H5::FileCreatPropList creation;
  H5Pset_obj_track_times(creation.getId(), false);
  H5::FileAccPropList access;
  access.setLibverBounds(H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  return {path.string(), H5F_ACC_TRUNC, creation, access};
}

}  // namespace

struct Hdf5File::Handle {
  std::filesystem::path path;
  H5::H5File file;

  /// The library's exceptions do not derive from std::exception; callers of ours should not have to know.
  template <class Action>
  void guarded(Action action) {
    try {
      action();
    } catch (const H5::Exception& failure) {
      throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), failure.getDetailMsg()));
    }
  }

  template <class Value>
  void array(const std::string& path_in_file, const H5::PredType& stored, const H5::PredType& given,
             std::span<const std::size_t> shape, const Value* values) {
    guarded([&] {
      const std::vector<hsize_t> extents(shape.begin(), shape.end());
      const H5::DataSpace space(static_cast<int>(extents.size()), extents.data());
      H5::DSetCreatPropList properties;
      H5Pset_obj_track_times(properties.getId(), false);  // the same data shall give the same bytes
      if (space.getSimpleExtentNpoints() > 0) {
        const std::vector<hsize_t> chunk = chunk_of(extents, stored.getSize());
        properties.setChunk(static_cast<int>(chunk.size()), chunk.data());
        properties.setFletcher32();
      }
      const H5::DataSet set = file.createDataSet(path_in_file, stored, space, properties);
      if (space.getSimpleExtentNpoints() > 0) set.write(values, given);
    });
  }

  template <class Value>
  void attribute(const std::string& object, const std::string& name, const H5::DataType& type, const Value* value) {
    guarded([&] {
      const H5::DataSpace scalar(H5S_SCALAR);
      const bool is_group = file.childObjType(object) == H5O_TYPE_GROUP;
      const H5::Attribute attribute = is_group ? file.openGroup(object).createAttribute(name, type, scalar)
                                               : file.openDataSet(object).createAttribute(name, type, scalar);
      attribute.write(type, value);
    });
  }
};

Hdf5File::Hdf5File(const std::filesystem::path& path) : handle_(std::make_unique<Handle>()) {
  H5::Exception::dontPrint();
  handle_->path = path;
  handle_->guarded([&] { handle_->file = created(path); });
}

Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
Hdf5File::~Hdf5File() = default;

void Hdf5File::group(const std::string& path) {
  handle_->guarded([&] {
    const H5::PropList properties(H5P_GROUP_CREATE);
    H5Pset_obj_track_times(properties.getId(), false);
    const hid_t made = H5Gcreate2(handle_->file.getId(), path.c_str(), H5P_DEFAULT, properties.getId(), H5P_DEFAULT);
    if (made < 0) throw H5::GroupIException("Hdf5File::group", "the group cannot be made");
    H5Gclose(made);
  });
}

void Hdf5File::array(const std::string& path, std::span<const double> values, std::span<const std::size_t> shape,
                     std::string_view name, std::string_view unit, std::string_view meaning) {
  const std::size_t count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
  require_that(count == values.size(), "array {}: {} values for a shape of {}", path, values.size(), count);
  handle_->array(path, H5::PredType::IEEE_F64LE, H5::PredType::NATIVE_DOUBLE, shape, values.data());
  describe(path, name, unit, meaning);
}

void Hdf5File::array(const std::string& path, std::span<const double> values, std::string_view name,
                     std::string_view unit, std::string_view meaning) {
  const std::size_t length = values.size();
  array(path, values, std::span(&length, 1), name, unit, meaning);
}

void Hdf5File::array(const std::string& path, std::span<const std::int32_t> values, std::string_view name,
                     std::string_view unit, std::string_view meaning) {
  const std::size_t length = values.size();
  handle_->array(path, H5::PredType::STD_I32LE, H5::PredType::NATIVE_INT32, std::span(&length, 1), values.data());
  describe(path, name, unit, meaning);
}

void Hdf5File::describe(const std::string& path, std::string_view name, std::string_view unit,
                        std::string_view meaning) {
  attribute(path, "name", name);
  attribute(path, "unit", unit);
  attribute(path, "meaning", meaning);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, std::string_view text) {
  // HDF5 has no strings of length zero; a single blank stands for one.
  const std::string value = text.empty() ? " " : std::string(text);
  H5::StrType type(H5::PredType::C_S1, value.size());
  type.setCset(H5T_CSET_UTF8);
  handle_->attribute(object, name, type, value.data());
}

void Hdf5File::attribute(const std::string& object, const std::string& name, double value) {
  handle_->attribute(object, name, H5::PredType::NATIVE_DOUBLE, &value);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, int value) {
  handle_->attribute(object, name, H5::PredType::NATIVE_INT, &value);
}

void Hdf5File::close() {
  handle_->guarded([&] {
    handle_->file.flush(H5F_SCOPE_GLOBAL);
    handle_->file.close();
  });
}

namespace {

void data_item(pugi::xml_node parent, const std::string& dimensions, const std::string& location,
               bool integer = false) {
  pugi::xml_node item = parent.append_child("DataItem");
  item.append_attribute("Dimensions") = dimensions.c_str();
  item.append_attribute("NumberType") = integer ? "Int" : "Float";
  item.append_attribute("Precision") = integer ? 4 : 8;
  item.append_attribute("Format") = "HDF";
  item.text() = location.c_str();
}

}  // namespace

std::string xdmf(const std::string& hdf5_name, const std::vector<XdmfFrame>& frames) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("Xdmf");
  root.append_attribute("Version") = "3.0";
  pugi::xml_node series = root.append_child("Domain").append_child("Grid");
  series.append_attribute("Name") = "frames";
  series.append_attribute("GridType") = "Collection";
  series.append_attribute("CollectionType") = "Temporal";
  for (const XdmfFrame& frame : frames) {
    pugi::xml_node grid = series.append_child("Grid");
    const bool curve = frame.topology == XdmfFrame::Topology::polyline;
    grid.append_attribute("Name") = curve ? "surface" : "particles";
    grid.append_child("Time").append_attribute("Value") = fmt::format("{:.17g}", frame.time).c_str();
    pugi::xml_node topology = grid.append_child("Topology");
    topology.append_attribute("TopologyType") = curve ? "Polyline" : "Polyvertex";
    topology.append_attribute("NumberOfElements") = curve ? "1" : fmt::format("{}", frame.points).c_str();
    topology.append_attribute("NodesPerElement") = curve ? fmt::format("{}", frame.points).c_str() : "1";
    pugi::xml_node geometry = grid.append_child("Geometry");
    geometry.append_attribute("GeometryType") = "XYZ";
    data_item(geometry, fmt::format("{} 3", frame.points), hdf5_name + ":" + frame.points_path);
    for (const XdmfField& field : frame.fields) {
      pugi::xml_node attribute = grid.append_child("Attribute");
      attribute.append_attribute("Name") = field.name.c_str();
      attribute.append_attribute("AttributeType") = field.components == 1 ? "Scalar" : "Vector";
      attribute.append_attribute("Center") = "Node";
      const std::string dimensions = field.components == 1 ? fmt::format("{}", frame.points)
                                                           : fmt::format("{} {}", frame.points, field.components);
      data_item(attribute, dimensions, hdf5_name + ":" + field.path, field.integer);
    }
  }
  std::ostringstream out;
  document.save(out, "  ");
  return out.str();
}

}  // namespace seiche::io
