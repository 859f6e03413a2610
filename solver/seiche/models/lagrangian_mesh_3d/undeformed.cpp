#include "seiche/models/lagrangian_mesh_3d/undeformed.hpp"

#include <cmath>

#include "seiche/linear/cosine_lattice.hpp"

namespace seiche::lagrangian_mesh_3d {

linear::UndeformedLattice undeformed_lattice(const Mesh& mesh, double density) {
  const auto distance = [&](std::size_t a, std::size_t b) {
    return std::hypot(mesh.x[b] - mesh.x[a], mesh.y[b] - mesh.y[a]);
  };
  const auto [columns, rows] = mesh.plan;
  double along = 0;
  double across = 0;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const std::size_t k = mesh.node(i, j, 0);
      if (i < columns) along += distance(k, k + 1);
      if (j < rows) across += distance(k, mesh.node(i, j + 1, 0));
    }
  }
  along /= static_cast<double>(columns * (rows + 1));
  across /= static_cast<double>((columns + 1) * rows);
  double area = 0;
  std::vector<double> heights(mesh.layers, 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    double height = 0;
    for (std::size_t a = 0; a < 4; ++a) height += (mesh.z[r[a + 4]] - mesh.z[r[a]]) / 4;
    heights[cell / mesh.plan.cells()] += height / static_cast<double>(mesh.plan.cells());
    area +=
        hexahedron_volume(corners_of(mesh, mesh.x, mesh.y, mesh.z, cell)) / height / static_cast<double>(mesh.cells());
  }
  // Sides in the proportion of the mean edges, with the mean area of a cell.
  const double to_area = std::sqrt(area / (along * across));
  return {.shape = {.nx = columns, .nz = rows, .layers = mesh.layers},
          .matrix = linear::HexahedralLattice(along * to_area, across * to_area, heights, density, mesh.free_bottom),
          .scaled = true};
}

}  // namespace seiche::lagrangian_mesh_3d
