#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace seiche::validation {

namespace {

struct Columns {
  std::size_t first;
  std::size_t last;
};

Columns columns_in(const lagrangian_mesh_2d::Mesh& mesh, std::span<const double> x, const MeshWindow& window) {
  const auto seen = [&](std::size_t i) {
    for (std::size_t j = 0; j <= mesh.rows; ++j) {
      const double at = x[mesh.node(i, j)];
      if (at >= window.begin && at <= window.end) return true;
    }
    return false;
  };
  Columns part{0, mesh.columns};
  while (part.first < part.last && !seen(part.first)) ++part.first;
  while (part.first < part.last && !seen(part.last)) --part.last;
  if (part.first == part.last) {
    throw std::invalid_argument(
        fmt::format("fewer than two columns of the mesh between {:g} and {:g}", window.begin, window.end));
  }
  // A column more on each side, so that rows go on to the window's ends.
  if (part.first > 0) --part.first;
  if (part.last < mesh.columns) ++part.last;
  return part;
}

}  // namespace

evidence::Axes mesh_axes(const std::string& title, const MeshWindow& window) {
  evidence::Axes axes{.x = "x [depth]", .y = "y [depth]", .title = title, .equal_aspect = true};
  if (std::isfinite(window.begin)) axes.x_min = window.begin;
  if (std::isfinite(window.end)) axes.x_max = window.end;
  return axes;
}

void draw_mesh(evidence::Panel& panel, const std::string& label, const lagrangian_mesh_2d::Mesh& mesh,
               std::span<const double> x, std::span<const double> y, const MeshWindow& window, evidence::Role role) {
  const Columns part = columns_in(mesh, x, window);
  std::vector<double> line_x, line_y;
  const auto through = [&](std::size_t i, std::size_t j) {
    line_x.push_back(x[mesh.node(i, j)]);
    line_y.push_back(y[mesh.node(i, j)]);
  };
  // To and fro: what joins one column or row with the next is an edge of the mesh too.
  const std::size_t across = part.last - part.first;
  for (std::size_t n = 0; n <= across; ++n) {
    for (std::size_t j = 0; j <= mesh.rows; ++j) through(part.first + n, n % 2 == 0 ? j : mesh.rows - j);
  }
  const bool at_top = across % 2 == 0;  // where the columns ended
  for (std::size_t n = 0; n <= mesh.rows; ++n) {
    const std::size_t j = at_top ? mesh.rows - n : n;
    for (std::size_t m = 0; m <= across; ++m) through(n % 2 == 0 ? part.last - m : part.first + m, j);
  }
  panel.line(label, line_x, line_y, role);
}

void draw_mesh(evidence::Panel& panel, const std::string& label, const lagrangian_mesh_2d::Flow& flow,
               const MeshWindow& window, evidence::Role role) {
  draw_mesh(panel, label, flow.model().mesh(), flow.x(), flow.y(), window, role);
}

SurfaceNodes surface_nodes(const lagrangian_mesh_2d::Flow& flow, const MeshWindow& window) {
  SurfaceNodes nodes;
  for (std::size_t i = 0; i < flow.surface_x().size(); ++i) {
    if (flow.surface_x()[i] < window.begin || flow.surface_x()[i] > window.end) continue;
    nodes.x.push_back(flow.surface_x()[i]);
    nodes.y.push_back(flow.surface_y()[i]);
  }
  return nodes;
}

}  // namespace seiche::validation
