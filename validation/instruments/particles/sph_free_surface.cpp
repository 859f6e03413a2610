#include "validation/instruments/particles/sph_free_surface.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::wcsph {
namespace {

/// Twice the area to the left of a directed segment, seen from the origin.
double sector(double x0, double z0, double x1, double z1) {
  return x0 * z1 - x1 * z0;
}

}  // namespace

double Contour::area() const {
  if (!closed) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t next = (i + 1) % x.size();
    sum += sector(x[i] - x[0], z[i] - z[0], x[next] - x[0], z[next] - z[0]);
  }
  return sum / 2;
}

Place Contour::centroid() const {
  Place first{0, 0};
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t next = (i + 1) % x.size();
    const double part = sector(x[i] - x[0], z[i] - z[0], x[next] - x[0], z[next] - z[0]);
    sum += part;
    first.x += part * (x[i] + x[next] - 2 * x[0]) / 3;
    first.z += part * (z[i] + z[next] - 2 * z[0]) / 3;
  }
  return {x[0] + first.x / sum, z[0] + first.z / sum};
}

double Contour::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) sum += std::hypot(x[i + 1] - x[i], z[i + 1] - z[i]);
  return closed ? sum + std::hypot(x[0] - x.back(), z[0] - z.back()) : sum;
}

double Contour::distance(double px, double pz) const {
  Smallest nearest;
  const std::size_t segments = closed || x.size() == 1 ? x.size() : x.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t next = (i + 1) % x.size();
    const double along_x = x[next] - x[i];
    const double along_z = z[next] - z[i];
    const double square = along_x * along_x + along_z * along_z;
    const double part = ((px - x[i]) * along_x + (pz - z[i]) * along_z) / square;
    const double foot = square > 0 ? std::clamp(part, 0.0, 1.0) : 0;
    nearest.add(std::hypot(px - x[i] - foot * along_x, pz - z[i] - foot * along_z));
  }
  return nearest.value();
}

std::vector<Contour> free_surface(const VolumeFraction& fraction, const Box& box, double step) {
  require_positive("step", step);
  require_positive("width of the box", box.right - box.left);
  require_positive("height of the box", box.top - box.bottom);
  const long columns = std::max(1L, std::lround((box.right - box.left) / step));
  const double side = (box.right - box.left) / static_cast<double>(columns);
  const auto rows = static_cast<long>(std::ceil((box.top - box.bottom) / side * (1 - 1e-12)));
  return level_curves({.left = box.left,
                       .bottom = box.bottom,
                       .step = side,
                       .columns = columns + 1,
                       .rows = rows + 1,
                       .values = fraction.on_grid(box.left, box.bottom, side, columns + 1, rows + 1)},
                      0.5);
}

const Contour* main_surface(const std::vector<Contour>& curves) {
  const auto open = std::find_if(curves.begin(), curves.end(), [](const Contour& curve) { return !curve.closed; });
  if (open != curves.end()) return &*open;
  return curves.empty() ? nullptr : &curves.front();
}

Overhang overhang(const Contour& surface) {
  const std::vector<double>& x = surface.x;
  const std::vector<double>& z = surface.z;
  Overhang result;
  std::size_t farthest = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] > x[farthest]) farthest = i;
    if (x[farthest] - x[i] > result.extent) {
      result.extent = x[farthest] - x[i];
      begin = farthest;
      end = i;
    }
  }
  if (result.extent == 0) return result;
  // Around the tip of a jet the curve turns to the right, in the hollow behind it to the left.
  const std::size_t before = begin >= 2 ? begin - 2 : 0;
  const std::size_t after = std::min(begin + 2, end);
  result.towards_right =
      sector(x[begin] - x[before], z[begin] - z[before], x[after] - x[begin], z[after] - z[begin]) < 0;
  const std::size_t tip = result.towards_right ? begin : end;
  result.tip = {x[tip], z[tip]};
  return result;
}

bool overturns(const std::vector<Contour>& curves, double least) {
  const Contour* surface = main_surface(curves);
  return surface != nullptr && !surface->closed && overhang(*surface).extent > least;
}

bool touches_down(const std::vector<Contour>& curves, double least) {
  return cavity_area(curves, least) > 0;
}

double cavity_area(const std::vector<Contour>& curves, double least) {
  double sum = 0;
  for (const Contour& curve : curves) {
    if (curve.air > least) sum += curve.air;
  }
  return sum;
}

}  // namespace seiche::wcsph
