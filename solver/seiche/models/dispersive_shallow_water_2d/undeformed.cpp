#include "seiche/models/dispersive_shallow_water_2d/undeformed.hpp"

#include <cmath>

#include "seiche/geometry/bilinear_patch.hpp"

namespace seiche::dispersive_shallow_water_2d {

linear::UndeformedLattice undeformed_lattice(const Lattice& lattice, double inertia) {
  const Shape shape = lattice.shape;
  double volume = 0;
  double area = 0;
  double length = 0;
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto [c0, c1, c2, c3] = shape.corners(cell);
    const bilinear_patch::Corners x{lattice.x[c0], lattice.x[c1], lattice.x[c2], lattice.x[c3]};
    const bilinear_patch::Corners y{lattice.y[c0], lattice.y[c1], lattice.y[c2], lattice.y[c3]};
    const auto depth = [&](std::size_t k) {
      return lattice.z[k] -
             (lattice.bottom ? lattice.bottom->slope(lattice.x[k], lattice.y[k]).elevation : -lattice.depth);
    };
    const auto j = bilinear_patch::jacobians(x, y);
    volume += bilinear_patch::volume(x, y, {depth(c0), depth(c1), depth(c2), depth(c3)});
    area += 0.5 * (j.c0 + j.c2);
    length += std::hypot(x.c1 - x.c0, y.c1 - y.c0);
  }
  const double h1 = length / static_cast<double>(shape.cells());
  const double h2 = area / length;
  const double depth = volume / area;
  const auto symbol = [=](double theta, double psi, std::span<double> diagonal, std::span<double>) {
    const double s1 = std::pow(std::sin(theta / 2), 2);
    const double s2 = std::pow(std::sin(psi / 2), 2);
    const double c1 = 1 - s1;
    const double c2 = 1 - s2;
    diagonal[0] = 4 * depth * (h2 / h1 * s1 * c2 + h1 / h2 * s2 * c1) + h1 * h2 * c1 * c2 / (inertia * depth);
  };
  return {.shape = {.nx = shape.columns, .nz = shape.rows, .layers = 1}, .matrix = symbol, .scaled = true};
}

}  // namespace seiche::dispersive_shallow_water_2d
