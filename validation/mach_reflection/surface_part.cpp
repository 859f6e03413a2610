#include "validation/mach_reflection/surface_part.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {

SurfacePart part_of(const SurfaceLattice& surface, const Extent& extent, double origin) {
  std::vector<std::size_t> columns, rows;
  for (std::size_t i = 0; i <= surface.columns; ++i) {
    const double x = surface.x[surface.node(i, 0)];
    if (x >= extent.from && x <= extent.to) columns.push_back(i);
  }
  for (std::size_t j = 0; j <= surface.rows; ++j) {
    if (surface.y[surface.node(0, j)] <= extent.top) rows.push_back(j);
  }
  if (columns.size() < 2 || rows.size() < 2) {
    throw std::invalid_argument(
        fmt::format("no cells of the surface lie in x = {:g} .. {:g}, y <= {:g}", extent.from, extent.to, extent.top));
  }
  SurfacePart part{.columns = columns.size() - 1, .rows = rows.size() - 1};
  for (const std::size_t j : rows) {
    for (const std::size_t i : columns) {
      const std::size_t n = surface.node(i, j);
      part.x.push_back(surface.x[n] - origin);
      part.y.push_back(surface.y[n]);
      part.z.push_back(surface.z[n]);
    }
  }
  return part;
}

}  // namespace seiche::validation
