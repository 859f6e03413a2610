#include "validation/breaking/free_particle_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "seiche/samples.hpp"
#include "validation/instruments/particles/gauss_outline.hpp"

namespace seiche::validation {
namespace {

constexpr double wavelength = 2 * std::numbers::pi;

/// Whether the water is outside the closed line, which has it on its left: where particles have been drawn apart
/// within.
bool is_hole(const std::vector<Point>& line) {
  double area = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Point& next = line[(k + 1) % line.size()];
    area += line[k].x * next.y - next.x * line[k].y;
  }
  return area < 0;
}

}  // namespace

Polylines water_outline(const gauss_particles::Flow& flow, double spacing, double below) {
  const std::vector<double>& masses = flow.model().particles().mass;
  constexpr double margin = 0.5;
  std::vector<double> x, y, mass;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    const double place = flow.x()[k] - wavelength * std::round(flow.x()[k] / wavelength);
    for (const int image : {-1, 0, 1}) {
      const double at = place + image * wavelength;
      if (std::abs(at) > wavelength / 2 + margin) continue;
      x.push_back(at);
      y.push_back(flow.y()[k]);
      mass.push_back(masses[k]);
    }
  }
  Polylines pieces;
  for (const auto& line : gauss_particles::surface_contours(x, y, mass, 1, spacing)) {
    if (is_hole(line)) continue;
    Polyline piece;
    for (std::size_t k = 0; k <= line.size(); ++k) {
      const Point& point = line[k % line.size()];
      const bool on_surface = point.y > below && std::abs(point.x) <= wavelength / 2;
      if (on_surface) {
        piece.x.push_back(point.x);
        piece.y.push_back(point.y);
      }
      if ((!on_surface || k == line.size()) && !piece.x.empty()) {
        Polyline complete = std::exchange(piece, {});
        if (complete.x.size() > 1) pieces.push_back(std::move(complete));
      }
    }
  }
  return pieces;
}

Polyline marker_line(const gauss_particles::Flow& flow) {
  Polyline line;
  const std::vector<Point> markers = flow.markers();
  for (const Point& marker : markers) {
    line.x.push_back(marker.x);
    line.y.push_back(marker.y);
  }
  line.x.push_back(markers.front().x + wavelength);
  line.y.push_back(markers.front().y);
  return line;
}

bool goes_backwards(const std::vector<Point>& line) {
  return !std::ranges::is_sorted(line, {}, &Point::x);
}

double thin_part(const Polyline& surface, double diameter) {
  const std::size_t n = surface.x.size() - 1;
  const auto distance = [&](Point from, std::size_t to) {
    const double dx = from.x - surface.x[to];
    return std::hypot(dx - wavelength * std::round(dx / wavelength), from.y - surface.y[to]);
  };
  // A disc that touches the surface from within at point k has its centre here, and fits where no other point is
  // nearer.
  const double radius = diameter / 2;
  std::vector<Point> centres;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n;
    double dx = surface.x[k + 1] - surface.x[before];
    dx -= wavelength * std::round(dx / wavelength);
    const double dy = surface.y[k + 1] - surface.y[before];
    const double length = std::hypot(dx, dy);
    const Point centre{surface.x[k] + radius * dy / length, surface.y[k] - radius * dx / length};
    Smallest nearest;
    for (std::size_t j = 0; j < n; ++j) nearest.add(distance(centre, j));
    if (nearest.value() > 0.999 * radius) centres.push_back(centre);
  }
  Largest out;
  for (std::size_t j = 0; j < n; ++j) {
    Smallest nearest;
    for (const Point& centre : centres) nearest.add(distance(centre, j));
    out.add(nearest.value() - radius);
  }
  return out.value();
}

}  // namespace seiche::validation
