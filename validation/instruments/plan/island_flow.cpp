#include "validation/instruments/plan/island_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seiche/require.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {

using dispersive_shallow_water_2d::Flow;
using dispersive_shallow_water_2d::Lattice;
using dispersive_shallow_water_2d::Velocity;

namespace {

/// Rows are closer at the shore, where the water is shallow: relative distances of the first row to that of the mean.
constexpr double first_row = 0.35;

double graded(double share) {
  return share * (first_row + (1 - first_row) * share);
}

/// The place on the ray through `to` where the bottom is at the still-water level.
Point shore_on_ray(const PlanBottom& bottom, Point to, double radius) {
  const double length = std::hypot(to.x, to.y);
  const Point ray{to.x / length, to.y / length};
  for (int iteration = 0; iteration < 20; ++iteration) {
    const auto b = bottom.slope(radius * ray.x, radius * ray.y);
    radius -= b.elevation / (b.along_x * ray.x + b.along_y * ray.y);
  }
  return {radius * ray.x, radius * ray.y};
}

}  // namespace

ConicalIsland::ConicalIsland(Settings settings)
    : settings_(settings),
      wave_((require_within("height", settings.height, 0.01, 0.3), require_within("depth", settings.depth, 0.2, 0.6),
             settings.height * settings.depth),
            settings.depth, gravity) {
  require_within("spacing", settings_.spacing, 0.05, 1);
  require_within("raster", settings_.raster, 0.01, 0.3);
  const double decay = std::sqrt(3 * settings_.height / (4 * (1 + settings_.height))) / settings_.depth;
  reach_ = std::log(4 / 1e-3) / (2 * decay);
  const double beyond = 4 * settings_.raster;
  bottom_ = std::make_shared<SplineBottom>(SplineBottom::sampled({.begin = crest() - reach_ - beyond,
                                                                  .end = rear_wall + beyond,
                                                                  .south = -side_wall - beyond,
                                                                  .north = side_wall + beyond,
                                                                  .spacing = settings_.raster},
                                                                 [this](double x, double y) { return bottom(x, y); }));
}

double ConicalIsland::bottom(double x, double y) const {
  const double radius = std::clamp(std::hypot(x, y), top_radius, base_radius);
  return slope * (base_radius - radius) - settings_.depth;
}

/// Along the walls, from the line of symmetry in front of the island to that behind it.
std::vector<Point> ConicalIsland::outer_places() const {
  const std::array corners{Point{crest() - reach_, 0}, Point{crest() - reach_, side_wall}, Point{rear_wall, side_wall},
                           Point{rear_wall, 0}};
  std::vector<Point> places{corners[0]};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    const Point from = corners[side];
    const Point to = corners[side + 1];
    const double count = std::ceil(std::hypot(to.x - from.x, to.y - from.y) / settings_.spacing);
    for (double k = 1; k <= count; ++k) {
      places.push_back({(from.x * (count - k) + to.x * k) / count, (from.y * (count - k) + to.y * k) / count});
    }
  }
  return places;
}

Lattice ConicalIsland::lattice() const {
  const std::vector<Point> outer = outer_places();
  const double shore = base_radius - settings_.depth / slope;
  const double rows = std::ceil((side_wall - shore) / settings_.spacing * 1.4);
  Lattice lattice{.shape = {outer.size() - 1, static_cast<std::size_t>(rows)}, .x = {}, .y = {}, .z = {}};
  std::vector<Point> inner;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    // Evenly around the shore: columns that crowd towards the basin's corners shear first.
    const double angle = std::numbers::pi * (1 - static_cast<double>(i) / static_cast<double>(outer.size() - 1));
    const bool symmetric = i == 0 || i + 1 == outer.size();
    inner.push_back(shore_on_ray(*bottom_, {std::cos(angle), symmetric ? 0.0 : std::sin(angle)}, shore));
  }
  for (double j = 0; j <= rows; ++j) {
    const double share = graded(j / rows);
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const double x = inner[i].x + share * (outer[i].x - inner[i].x);
      const double y = inner[i].y + share * (outer[i].y - inner[i].y);
      lattice.x.push_back(x);
      lattice.y.push_back(y);
      lattice.z.push_back(j == 0 ? bottom_->slope(x, y).elevation : wave_.elevation(x - crest()));
    }
  }
  lattice.sides.south = plan_lattice::ShoreSide{};
  lattice.bottom = bottom_;
  return lattice;
}

Velocity ConicalIsland::velocity(double x, double) const {
  const double eta = wave_.elevation(x - crest());
  const double along = wave_.depth_averaged_velocity(x - crest());
  return {.u = along, .v = 0, .w = eta > 0 ? (along - wave_.speed()) * wave_.elevation_slope(x - crest()) : 0.0};
}

dispersive_shallow_water_2d::Settings ConicalIsland::model_settings() const {
  return {.gravity = gravity, .solver = linear::SolverMethod::banded, .drag = settings_.drag};
}

Flow ConicalIsland::flow() const {
  return Flow(
      lattice(), [this](double x, double y) { return velocity(x, y); }, settings_.scheme, model_settings(), {}, {},
      false);
}

RezonedFlow ConicalIsland::rezoned_flow() const {
  return {lattice(), [this](double x, double y) { return velocity(x, y); }, settings_.scheme, model_settings(), {}};
}

RunupEnvelope::RunupEnvelope(const Flow& flow) : angle_(angles(flow)), highest_(angle_.size()) {
  observe(flow);
}

std::vector<double> RunupEnvelope::angles(const Flow& flow) {
  std::vector<double> all;
  for (std::size_t i = 0; i <= flow.shape().columns; ++i) {
    all.push_back(180 - std::atan2(flow.y()[i], flow.x()[i]) * 180 / std::numbers::pi);
  }
  return all;
}

void RunupEnvelope::observe(const Flow& flow, double time) {
  const std::vector<double> now = angles(flow);
  std::size_t i = 1;
  for (std::size_t k = 0; k < angle_.size(); ++k) {
    while (i + 1 < now.size() && now[i] < angle_[k]) ++i;
    const double share = std::clamp((angle_[k] - now[i - 1]) / (now[i] - now[i - 1]), 0.0, 1.0);
    highest_[k].add(std::lerp(flow.z()[i - 1], flow.z()[i], share), time);
  }
}

std::vector<double> RunupEnvelope::runup() const {
  return each(highest_, [&](const Largest& one) { return one.value(); });
}

double RunupEnvelope::at(double angle) const {
  const auto above = std::upper_bound(angle_.begin() + 1, angle_.end() - 1, angle);
  const auto i = static_cast<std::size_t>(above - angle_.begin());
  const double share = (angle - angle_[i - 1]) / (angle_[i] - angle_[i - 1]);
  const double here = highest_[i - 1].value();
  return here + share * (highest_[i].value() - here);
}

}  // namespace seiche::validation
