#include "validation/breaking/free_particle_surface.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
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
    std::vector<Point> piece;
    for (std::size_t k = 0; k <= line.size(); ++k) {
      const Point& point = line[k % line.size()];
      const bool on_surface = point.y > below && std::abs(point.x) <= wavelength / 2;
      if (on_surface) piece.push_back(point);
      if (on_surface && k < line.size()) continue;
      if (piece.size() > 1) pieces.push_back(line_through(piece));
      piece.clear();
    }
  }
  return pieces;
}

gauss_particles::Flow ParticleWave::start(const mechanics::VelocityAt& velocity,
                                          gauss_particles::Forcing forcing) const {
  using gauss_particles::LatticePlan;
  return {gauss_particles::layer({.begin = -wavelength / 2,
                                  .end = wavelength / 2,
                                  .columns = static_cast<std::size_t>(cells * side),
                                  .rows = rows,
                                  .surface = surface,
                                  .bottom = [this](double) { return -depth; },
                                  .markers = markers}),
          std::make_unique<gauss_particles::SplineSpace>(LatticePlan{.cell_x = wavelength / static_cast<double>(cells),
                                                                     .left_wall = -wavelength / 2,
                                                                     .period = wavelength,
                                                                     .bottom = true,
                                                                     .ground = {.level = -depth},
                                                                     .shift = true}),
          velocity,
          {},
          std::move(forcing)};
}

Polyline exact_wave(const exact::overturning::MovingSurface& exact, double time) {
  auto profile = exact.profile(time, 1601);
  return {std::move(profile.x), std::move(profile.y)};
}

Polyline line_through(const std::vector<Point>& points) {
  return {each(points, &Point::x), each(points, &Point::y)};
}

Polyline marker_line(const gauss_particles::Flow& flow) {
  std::vector<Point> markers = flow.markers();
  markers.push_back({markers.front().x + wavelength, markers.front().y});
  return line_through(markers);
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

double largest_distance(const exact::overturning::MovingSurface& exact, double time, double cell) {
  if (time <= exact.vertical_tangent_time().value_or(exact.end_time())) {
    return std::min(exact.largest_curvature(time) * cell * cell / 8, cell / 2);
  }
  return cell / 2 + thin_part(exact_wave(exact, time), cell);
}

}  // namespace seiche::validation
