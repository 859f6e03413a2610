#include "reports/evidence/record_files.hpp"

#include <array>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "reports/evidence/provenance.hpp"
#include "reports/evidence/record_lock.hpp"
#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"

namespace seiche::evidence {
namespace {

constexpr std::array role_names{"exact", "computed", "peer", "data", "guide", "bed", "water"};
constexpr std::array style_names{"line", "points", "steps", "fill", "vertical", "surface", "plan"};

void write_series(io::Hdf5File& file, const std::string& path, const Series& series, const Axes& axes) {
  file.group(path);
  file.attribute(path, "label", series.label);
  file.attribute(path, "role", std::string_view(role_names.at(static_cast<std::size_t>(series.role))));
  file.attribute(path, "style", std::string_view(style_names.at(static_cast<std::size_t>(series.style))));
  if (series.row_points > 0) {
    const std::array<std::size_t, 2> shape{series.x.size() / series.row_points, series.row_points};
    file.array(path + "/x", series.x, shape, axes.x, "see name", "points of the lattice, row by row");
    file.array(path + "/y", series.y, shape, axes.y, "see name", "points of the lattice, row by row");
    file.array(path + "/z", series.z, shape, axes.z, "see name", series.label);
    return;
  }
  file.array(path + "/x", series.x, axes.x, "see name", series.style == Style::steps ? "cell edges" : "abscissa");
  file.array(path + "/y", series.y, axes.y, "see name", series.label);
  if (!series.y_error.empty()) file.array(path + "/y_error", series.y_error, axes.y, "see name", "half-width");
}

void write_panel(io::Hdf5File& file, const std::string& path, const Panel& panel) {
  const Axes& axes = panel.axes();
  file.group(path);
  file.attribute(path, "title", axes.title);
  file.attribute(path, "x_label", axes.x);
  file.attribute(path, "y_label", axes.y);
  file.attribute(path, "log_x", axes.log_x ? 1 : 0);
  file.attribute(path, "log_y", axes.log_y ? 1 : 0);
  file.attribute(path, "aspect", std::string_view(axes.equal_aspect ? "equal" : "auto"));
  if (!axes.z.empty()) file.attribute(path, "z_label", axes.z);
  const std::array<std::pair<const char*, const std::optional<double>*>, 9> numbers{
      {{"x_min", &axes.x_min},
       {"x_max", &axes.x_max},
       {"y_min", &axes.y_min},
       {"y_max", &axes.y_max},
       {"z_min", &axes.z_min},
       {"z_max", &axes.z_max},
       {"azimuth", &axes.view.azimuth},
       {"elevation", &axes.view.elevation},
       {"exaggeration", &axes.view.exaggeration}}};
  for (const auto& [name_of, number] : numbers) {
    if (*number) file.attribute(path, name_of, **number);
  }
  for (std::size_t k = 0; k < panel.series().size(); ++k) {
    write_series(file, fmt::format("{}/series_{:02}", path, k), panel.series()[k], axes);
  }
}

void write_figures(io::Hdf5File& file, const Record& record) {
  file.group("/figures");
  for (const Figure& figure : record.figures()) {
    const std::string path = "/figures/" + figure.id;
    file.group(path);
    file.attribute(path, "title", figure.title);
    file.attribute(path, "caption", figure.caption);
    file.attribute(path, "drawing", figure.drawing);
    std::size_t k = 0;
    for (const Panel& panel : figure.panels()) write_panel(file, fmt::format("{}/panel_{:02}", path, k++), panel);
  }
}

void write_arrays(io::Hdf5File& file, const Record& record) {
  file.group("/arrays");
  for (const Array& a : record.arrays()) file.array("/arrays/" + a.name, a.values, a.name, a.unit, a.meaning);
}

std::vector<io::XdmfFrame> write_snapshots(io::Hdf5File& file, const Record& record) {
  std::vector<io::XdmfFrame> frames;
  file.group("/snapshots");
  for (const Snapshot& snapshot : record.snapshots()) {
    const std::string path = fmt::format("/snapshots/{:04}", frames.size());
    file.group(path);
    file.attribute(path, "time", snapshot.time);
    const std::size_t n = snapshot.x.size();
    std::vector<double> points(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      points[3 * i] = snapshot.x[i];
      points[3 * i + 2] = snapshot.z.at(i);
    }
    const std::array<std::size_t, 2> shape{n, 3};
    file.array(path + "/points", points, shape, "points", snapshot.unit, "coordinates x, y, z");
    using Topology = io::XdmfFrame::Topology;
    io::XdmfFrame frame{.time = snapshot.time,
                        .points = n,
                        .points_path = path + "/points",
                        .fields = {},
                        .topology = snapshot.joined ? Topology::polyline : Topology::polyvertex};
    for (const Snapshot::Field& field : snapshot.fields) {
      const std::string here = path + "/" + field.name;
      file.array(here, field.values, field.name, field.unit, "value at the points");
      frame.fields.push_back({.name = field.name, .path = here});
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

void write(const Record& record, const std::filesystem::path& directory) {
  const bool has_data = !(record.figures().empty() && record.arrays().empty() && record.snapshots().empty());
  std::map<std::string, std::string> digests;
  std::vector<std::unique_ptr<io::AtomicFile>> files;
  const auto begin = [&](const char* extension) -> const io::AtomicFile& {
    return *files.emplace_back(std::make_unique<io::AtomicFile>(directory / (record.stem() + extension)));
  };
  if (has_data) {
    const io::AtomicFile& arrays = begin(".h5");
    io::Hdf5File file(arrays.path());
    write_figures(file, record);
    write_arrays(file, record);
    const std::vector<io::XdmfFrame> frames = write_snapshots(file, record);
    file.close();
    digests[record.stem() + ".h5"] = sha256_of_file(arrays.path());
    if (!frames.empty()) {
      const std::string text = io::xdmf(record.stem() + ".h5", frames);
      begin(".xdmf").write(text);
      digests[record.stem() + ".xdmf"] = sha256(text);
    }
  }
  begin(".json").write(to_json(record, digests));
  const FolderLock moment(directory);
  for (const auto& file : files) file->commit();
}

}  // namespace seiche::evidence
