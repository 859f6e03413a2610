#include "seiche/models/wcsph/lattice.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {
namespace {

/// Lengths are whole numbers of dx to this part of dx.
constexpr double tolerance = 1e-9;

/// Dx that a segment is long.
long steps_between(const Place& from, const Place& to, double spacing) {
  const double steps = std::hypot(to.x - from.x, to.z - from.z) / spacing;
  const double whole = std::round(steps);
  require_that(whole >= 1 && std::abs(steps - whole) <= tolerance * whole,
               "segment of a wall from ({:g}, {:g}) to ({:g}, {:g}) is {:.12g} dx long: must "
               "be a whole number of dx, at least 1",
               from.x, from.z, to.x, to.z, steps);
  return static_cast<long>(whole);
}

}  // namespace

Lattice lattice_named(std::string_view name) {
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    if (name == name_of(lattice)) return lattice;
  }
  throw std::invalid_argument(fmt::format("lattice = '{}': must be square or body_centred", name));
}

std::string_view name_of(Lattice lattice) {
  return lattice == Lattice::square ? "square" : "body_centred";
}

double area_per_particle(Lattice lattice) {
  return lattice == Lattice::square ? 1 : 0.5;
}

std::vector<LatticeLine> lattice_lines(Lattice lattice, double spacing, double left, long columns) {
  std::vector<LatticeLine> lines;
  for (long i = 0; i < columns; ++i) {
    const auto cell = static_cast<double>(i);
    if (lattice == Lattice::square) {
      lines.push_back({.x = left + (cell + 0.5) * spacing, .width = spacing, .offset = 0.5});
    } else {
      lines.push_back({.x = left + (cell + 0.25) * spacing, .width = spacing / 2, .offset = 0.25});
      lines.push_back({.x = left + (cell + 0.75) * spacing, .width = spacing / 2, .offset = 0.75});
    }
  }
  return lines;
}

std::vector<Place> rectangle(Lattice lattice, double spacing, double left, double bottom, long columns, long rows) {
  require_positive("spacing", spacing);
  std::vector<Place> places;
  for (const LatticeLine& line : lattice_lines(lattice, spacing, left, columns)) {
    for (long j = 0; j < rows; ++j) {
      places.push_back({line.x, bottom + (static_cast<double>(j) + line.offset) * spacing});
    }
  }
  return places;
}

std::vector<Place> shape(Lattice lattice, double spacing, const Box& box,
                         const std::function<bool(double x, double z)>& inside) {
  require_positive("spacing", spacing);
  for (const double side : {box.left, box.right, box.bottom, box.top}) require_finite("side of the box", side);
  const auto cells = [&](double length) { return static_cast<long>(std::ceil(length / spacing)); };
  std::vector<Place> places =
      rectangle(lattice, spacing, box.left, box.bottom, cells(box.right - box.left), cells(box.top - box.bottom));
  std::erase_if(places, [&](const Place& p) { return p.x > box.right || p.z > box.top || !inside(p.x, p.z); });
  return places;
}

std::vector<Place> wall(std::span<const Place> corners, double spacing, int rows, bool corners_twice) {
  require_positive("spacing", spacing);
  require_within("rows of a wall", rows, 1, 3);
  std::vector<Place> places;
  for (std::size_t s = 0; s + 1 < corners.size(); ++s) {
    const Place& from = corners[s];
    const Place& to = corners[s + 1];
    const long steps = steps_between(from, to, spacing);
    const Place along{(to.x - from.x) / static_cast<double>(steps), (to.z - from.z) / static_cast<double>(steps)};
    const Place behind{along.z / 2, -along.x / 2};
    for (int row = 0; row < rows; ++row) {
      const double shift = row % 2 == 0 ? 0 : 0.5;
      const bool has_corner = row == 0 && s > 0 && !corners_twice;  // the segment before has it
      for (long k = has_corner ? 1 : 0; k + (row % 2) <= steps; ++k) {
        const double step = static_cast<double>(k) + shift;
        places.push_back({from.x + step * along.x + row * behind.x, from.z + step * along.z + row * behind.z});
      }
    }
  }
  return places;
}

}  // namespace seiche::wcsph
