#include "seiche/models/lagrangian_mesh_2d/lattice.hpp"

#include "seiche/linear/cosine_lattice.hpp"

namespace seiche::lagrangian_mesh_2d {

std::optional<linear::UndeformedLattice> undeformed_lattice(const Mesh& mesh, double density) {
  const auto free = [](const Side& side) { return std::holds_alternative<FreeSide>(side); };
  if (!free(mesh.sides.top) || free(mesh.sides.left) || free(mesh.sides.right) || free(mesh.sides.bottom)) return {};
  double area = 0;
  double height = 0;
  std::vector<double> heights(mesh.rows, 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto [r0, r1, r2, r3] = mesh.corners(cell);
    heights[cell / mesh.columns] +=
        0.5 * (mesh.y[r3] + mesh.y[r2] - mesh.y[r0] - mesh.y[r1]) / static_cast<double>(mesh.columns);
    area += cell_area(mesh, mesh.x, mesh.y, cell);
  }
  for (const double row : heights) height += row;
  const double width = area / (height * static_cast<double>(mesh.columns));
  return linear::UndeformedLattice{.shape = {.nx = mesh.columns, .nz = 1, .layers = mesh.rows},
                                   .matrix = linear::HexahedralLattice(width, 1, heights, density)};
}

}  // namespace seiche::lagrangian_mesh_2d
