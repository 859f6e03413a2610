#include "validation/drop/affine_motion.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace seiche::validation {

std::function<Point(Point)> linear_velocity(const Eigen::Matrix2d& gradient) {
  return [gradient](Point r) {
    const Eigen::Vector2d u = gradient * Eigen::Vector2d(r.x, r.y);
    return Point{u.x(), u.y()};
  };
}

void draw_drop(evidence::Figure& figure, const std::string& title, const std::string& label, std::span<const double> x,
               std::span<const double> y, const exact::AffineDrop& drop, double time) {
  evidence::Panel& panel = figure.panel({.x = "x", .y = "y", .title = title, .equal_aspect = true});
  panel.points(label, x, y);
  std::vector<double> outline_x, outline_y;
  const Eigen::Matrix2d deformation = drop.at(time).deformation;
  for (int k = 0; k <= 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    const Eigen::Vector2d place = deformation * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    outline_x.push_back(place.x());
    outline_y.push_back(place.y());
  }
  panel.line("exact", outline_x, outline_y, evidence::Role::exact);
}

}  // namespace seiche::validation
