#include "seiche/models/lagrangian_mesh_3d/bottom.hpp"

#include <cmath>
#include <utility>

namespace seiche::lagrangian_mesh_3d {

Bottom::Bottom(std::shared_ptr<const PlanBottom> bottom, std::vector<HorizontalFreedom> freedom)
    : bottom_(std::move(bottom)), freedom_(std::move(freedom)), normal_(freedom_.size()) {}

void Bottom::set(std::size_t node, double along_x, double along_y) {
  const HorizontalFreedom& free = freedom_[node];
  const double x = -(free.xx * along_x + free.xy * along_y);
  const double y = -(free.xy * along_x + free.yy * along_y);
  const double length = std::sqrt(x * x + y * y + 1);
  normal_[node] = {x / length, y / length, 1 / length};
}

void Bottom::linearise(std::span<const double> x, std::span<const double> y) {
  for (std::size_t k = 0; k < nodes(); ++k) {
    const PlanBottom::Slope slope = bottom_->slope(x[k], y[k]);
    set(k, slope.along_x, slope.along_y);
  }
}

void Bottom::linearise_between(std::span<const double> x0, std::span<const double> y0, std::span<const double> x1,
                               std::span<const double> y1) {
  static const double outer = 0.5 * std::sqrt(0.6);
  for (std::size_t k = 0; k < nodes(); ++k) {
    double along_x = 0;
    double along_y = 0;
    for (const auto& [part, weight] : {std::pair{0.5 - outer, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + outer, 5.0 / 18}}) {
      const PlanBottom::Slope slope = bottom_->slope(x0[k] + part * (x1[k] - x0[k]), y0[k] + part * (y1[k] - y0[k]));
      along_x += weight * slope.along_x;
      along_y += weight * slope.along_y;
    }
    set(k, along_x, along_y);
  }
}

Vector Bottom::along(std::size_t node, const Vector& v) const {
  const HorizontalFreedom& free = freedom_[node];
  const Vector& m = normal_[node];
  const double through = m.x * v.x + m.y * v.y + m.z * v.z;
  return {free.xx * v.x + free.xy * v.y - through * m.x, free.xy * v.x + free.yy * v.y - through * m.y,
          v.z - through * m.z};
}

}  // namespace seiche::lagrangian_mesh_3d
