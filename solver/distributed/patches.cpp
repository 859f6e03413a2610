#include "distributed/patches.hpp"

#include <vector>

namespace seiche::distributed {

namespace {

/// Levels of nodes of the lattice, cut to the patch.
std::vector<double> cut(const std::vector<double>& values, const Patch& patch, std::size_t levels) {
  std::vector<double> result;
  result.reserve(levels * patch.shape().nodes());
  for (std::size_t l = 0; l < levels; ++l) {
    for (std::size_t j = patch.rows.begin; j <= patch.rows.end; ++j) {
      const auto row =
          values.begin() + static_cast<std::ptrdiff_t>(l * patch.lattice.nodes() + patch.lattice.node(0, j));
      result.insert(result.end(), row + static_cast<std::ptrdiff_t>(patch.columns.begin),
                    row + static_cast<std::ptrdiff_t>(patch.columns.end + 1));
    }
  }
  return result;
}

}  // namespace

dispersive_shallow_water_2d::Lattice part_of(const dispersive_shallow_water_2d::Lattice& lattice, const Patch& patch) {
  lattice.require_valid();
  return {.shape = patch.shape(),
          .x = cut(lattice.x, patch, 1),
          .y = cut(lattice.y, patch, 1),
          .z = cut(lattice.z, patch, 1),
          .sides = patch.sides(lattice.sides),
          .depth = lattice.depth,
          .bottom = lattice.bottom};
}

dispersive_shallow_water_2d::Lattice part_of(const dispersive_shallow_water_2d::Rectangle& rectangle,
                                             const Patch& patch) {
  // Places of the whole lattice's lines, from a lattice of one row and from one of two columns.
  dispersive_shallow_water_2d::Rectangle line = rectangle;
  line.elevation = {};
  line.rows = 1;
  const auto along = rectangular_lattice(line).x;
  line.rows = rectangle.rows;
  line.columns = 2;
  const auto across = rectangular_lattice(line).y;
  dispersive_shallow_water_2d::Lattice part{.shape = patch.shape(),
                                            .x = {},
                                            .y = {},
                                            .z = {},
                                            .sides = patch.sides(rectangle.sides),
                                            .depth = rectangle.depth,
                                            .bottom = rectangle.bottom};
  for (std::size_t j = patch.rows.begin; j <= patch.rows.end; ++j) {
    for (std::size_t i = patch.columns.begin; i <= patch.columns.end; ++i) {
      part.x.push_back(along[i]);
      part.y.push_back(across[3 * j]);
      part.z.push_back(rectangle.elevation ? rectangle.elevation(part.x.back(), part.y.back()) : 0.0);
    }
  }
  return part;
}

lagrangian_mesh_3d::Mesh part_of(const lagrangian_mesh_3d::Mesh& mesh, const Patch& patch) {
  mesh.require_valid();
  const std::size_t levels = mesh.layers + 1;
  return {.plan = patch.shape(),
          .layers = mesh.layers,
          .x = cut(mesh.x, patch, levels),
          .y = cut(mesh.y, patch, levels),
          .z = cut(mesh.z, patch, levels),
          .sides = patch.sides(mesh.sides),
          .free_bottom = mesh.free_bottom,
          .bottom = mesh.bottom};
}

}  // namespace seiche::distributed
