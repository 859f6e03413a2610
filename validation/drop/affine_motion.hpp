/// A round drop of radius 1 whose motion is affine: how it begins, and how its exact outline is drawn.
#pragma once

#include <functional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "reports/evidence/figure.hpp"
#include "seiche/geometry/curve.hpp"
#include "validation/instruments/exact/affine_drop.hpp"

namespace seiche::validation {

std::function<Point(Point)> linear_velocity(const Eigen::Matrix2d& gradient);

/// A panel with computed places of particles and the exact outline.
void draw_drop(evidence::Figure& figure, const std::string& title, const std::string& label, std::span<const double> x,
               std::span<const double> y, const exact::AffineDrop& drop, double time);

}  // namespace seiche::validation
