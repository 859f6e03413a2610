#include "validation/run_up/mesh_slope_climb.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;

Flow MeshSlopeClimb::start() const {
  const auto elevation = [&](double x) { return wave.elevation(x - crest); };
  const auto columns = static_cast<std::size_t>(std::max(1L, std::lround(toe / spacing)));
  auto mesh = lagrangian_mesh_2d::layer_mesh_with_slope(
      {.end = toe, .depth = 1, .columns = columns, .rows = static_cast<std::size_t>(rows), .elevation = elevation},
      tan_slope, blend, rounding * spacing);
  // Sheared columns reach above the surface where it falls.
  const auto velocity = [&](Point r) {
    const exact::Velocity v = wave.velocity(r.x - crest, std::min(r.y, elevation(r.x)));
    return Point{v.u, v.v};
  };
  const double lowest = beyond_tangling ? -std::numeric_limits<double>::infinity() : 0.0;
  return Flow(std::move(mesh), velocity, scheme, {.hourglass = hourglass, .lowest_corner = lowest});
}

std::string MeshSlopeClimb::resolution() const {
  return fmt::format("h1 = {:g}, {} rows, tau = {:g}", spacing, rows, tau);
}

MeshSlopeRun climb_slope(const MeshSlopeClimb& climb, const std::function<void(const Flow&)>& after_step) {
  MeshSlopeRun run{.flow = climb.start()};
  Flow& flow = run.flow;
  if (climb.rezone > 0) flow.keep_upright(climb.rezone);
  const double energy = flow.energy();
  Peak level;
  constexpr double fallen = 0.98;
  const double latest = 3 * climb.toe;
  Worst defect;
  // The level is NaN before the first step.
  const auto climbs = [&] {
    return !(level.value() >= 0.5 * climb.wave.amplitude()) || flow.surface_y().back() > fallen * level.value();
  };
  while (flow.time() < latest && climbs()) {
    flow.advance(climb.tau);
    defect.add(flow.energy() / energy - 1, flow.time());
    if (!(flow.surface_y().back() <= level.value())) run.energy_defect = defect;
    level.add(flow.time(), flow.surface_y().back());
    if (!run.tangle) {
      const lagrangian_mesh_2d::Corner worst = flow.worst_corner();
      if (worst.shape <= 0) {
        run.tangle = {.time = flow.time(), .place = flow.x()[flow.model().mesh().corners(worst.cell)[0]]};
      }
    }
    if (after_step) after_step(flow);
  }
  if (!climbs()) run.runup = level.value();
  run.time = level.time();
  return run;
}

}  // namespace seiche::validation
