#include "validation/run_up/gauss_climb.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "seiche/models/gauss_particles/spline_space.hpp"

namespace seiche::validation {
namespace {

using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

constexpr double rounding = 0.25;  ///< half-length of the rounded toe
constexpr double markers_per_cell = 10;
constexpr double shown = 4;          ///< depths before the toe that frames show
constexpr double highest_place = 4;  ///< that the water may reach

std::size_t count(double number) {
  return static_cast<std::size_t>(std::lround(number));
}

GaussFrame frame_of(const gauss_particles::Flow& flow, double from) {
  GaussFrame frame{.time = flow.time()};
  const std::vector<Point> markers = flow.markers();
  const std::size_t massive = flow.model().size() - markers.size();
  for (std::size_t k = 0; k < massive; ++k) {
    if (flow.x()[k] < from) continue;
    frame.x.push_back(flow.x()[k]);
    frame.y.push_back(flow.y()[k]);
    frame.u.push_back(flow.u()[k]);
    frame.v.push_back(flow.v()[k]);
  }
  for (const Point& marker : markers) {
    if (marker.x < from) continue;
    frame.line_x.push_back(marker.x);
    frame.line_y.push_back(marker.y);
  }
  return frame;
}

/// How far the particles are behind bottom and walls.
double farthest_beyond(const gauss_particles::Flow& flow, const GaussClimb& climb) {
  Largest beyond;
  beyond.add(0);
  const std::size_t massive = flow.model().size() - flow.markers().size();
  for (std::size_t k = 0; k < massive; ++k) {
    const double x = flow.x()[k];
    beyond.add(climb.bottom(x) - flow.y()[k]);
    beyond.add(-x);
    if (climb.cot_slope == 0) beyond.add(x - climb.toe());
  }
  return beyond.value();
}

}  // namespace

double GaussClimb::crest() const {
  constexpr double cut_off = 0.001;  // the tail is 4 exp(-k x) times the height, or less
  return std::ceil(-std::log(cut_off) / wave.decay_rate());
}

double GaussClimb::bottom(double x) const {
  const double z = (x - toe()) / rounding;
  if (cot_slope == 0 || z <= -1) return -1;
  if (z >= 1) return -1 + (x - toe()) / cot_slope;
  const double s = (z + 1) / 2;
  return -1 + 2 * rounding / cot_slope * s * s * s * s * (2.5 + s * (s - 3));
}

double GaussClimb::bottom_slope(double x) const {
  const double z = (x - toe()) / rounding;
  if (cot_slope == 0 || z <= -1) return 0;
  if (z >= 1) return 1 / cot_slope;
  const double s = (z + 1) / 2;
  return s * s * s * (10 + s * (6 * s - 15)) / cot_slope;
}

double GaussClimb::tau() const {
  return (cot_slope == 0 ? 0.15 : 0.12) * spacing() / wave.speed();
}

std::string GaussClimb::resolution() const {
  return fmt::format("{} cells to a depth, {} particles to a side", cells, per_cell);
}

gauss_particles::Flow GaussClimb::start() const {
  const double end = toe() + cot_slope;
  const auto columns = static_cast<double>(cells) * end;
  LatticePlan plan{.cell_x = spacing(), .left_wall = 0.0, .bottom = true, .ground = {.level = -1}};
  if (cot_slope == 0) {
    plan.right_wall = end;
  } else {
    plan.ground = {.profile = std::make_shared<SmoothBottom>([of = *this](double x) { return of.bottom(x); },
                                                             [of = *this](double x) { return of.bottom_slope(x); }, -1,
                                                             toe() + (1 + highest_place) * cot_slope)};
  }
  const auto elevation = [this](double x) { return wave.elevation(x - crest()); };
  return gauss_particles::Flow(
      gauss_particles::layer({.begin = 0,
                              .end = end,
                              .columns = count(columns * static_cast<double>(per_cell)),
                              .rows = static_cast<std::size_t>(cells * per_cell),
                              .surface = [&](double x) { return std::max(elevation(x), bottom(x)); },
                              .bottom = [this](double x) { return bottom(x); },
                              .markers = count(columns * markers_per_cell),
                              .marker_at_end = true}),
      std::make_unique<SplineSpace>(plan, SplineSpace::Settings{.inner_fraction = 0.25}),
      [&](Point r) {
        if (cot_slope != 0 && r.x > toe() - rounding) return Point{0, 0};
        // The surface itself is the end of the exact field: points above it by rounding are put on it.
        const auto v = wave.velocity(r.x - crest(), std::min(r.y, elevation(r.x) - 1e-13));
        return Point{v.u, v.v};
      },
      {.gravity = 1, .penalty = 0.01});
}

GaussClimbRun climb(const GaussClimb& climb) {
  gauss_particles::Flow flow = climb.start();
  GaussClimbRun run;
  run.particles = static_cast<double>(flow.model().size() - flow.markers().size());
  run.wave_energy = climb.wave.kinetic_energy() + climb.wave.potential_energy();
  const double arrival = (climb.crest() - 3) / climb.wave.speed();
  const double latest = (climb.crest() + 4 * climb.cot_slope + 10) / climb.wave.speed();
  const double edge = climb.cot_slope == 0 ? climb.toe() - climb.spacing() : climb.toe();
  Largest beyond;
  const auto shore = [&] {
    Largest level;
    for (const Point& marker : flow.markers()) {
      if (marker.x >= edge) level.add(marker.y);
    }
    return level.value();
  };
  while (!run.fell && flow.time() < latest) {
    flow.advance(climb.tau());
    flow.observe();
    beyond.add(farthest_beyond(flow, climb));
    run.times.push_back(flow.time());
    run.levels.push_back(shore());
    if (flow.time() < arrival) continue;
    if (run.levels.back() > run.highest) {
      run.highest = run.levels.back();
      run.time = flow.time();
      run.at_highest = frame_of(flow, climb.toe() - shown);
    }
    run.fell = run.highest > climb.wave.amplitude() && run.levels.back() < 0.98 * run.highest;
  }
  run.at_end = frame_of(flow, climb.toe() - shown);
  run.energy_defect = flow.ledger().largest_defect("energy") / run.wave_energy;
  run.penalty_loss = flow.model().penalty_loss() / run.wave_energy;
  run.beyond = beyond.value();
  run.free_particles = flow.most_free_particles();
  run.steps = flow.steps();
  return run;
}

void add_frame(evidence::Exhibit& exhibit, const GaussFrame& frame) {
  exhibit.snapshot({.time = frame.time,
                    .x = frame.x,
                    .z = frame.y,
                    .unit = "depth",
                    .fields = {{"u", "sqrt(g depth)", frame.u}, {"w", "sqrt(g depth)", frame.v}},
                    .joined = false});
}

}  // namespace seiche::validation
