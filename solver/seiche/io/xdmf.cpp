#include "seiche/io/xdmf.hpp"

#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace seiche::io {
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
