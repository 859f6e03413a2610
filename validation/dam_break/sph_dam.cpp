#include "validation/dam_break/sph_dam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "validation/instruments/sph_front.hpp"

namespace seiche::validation {

SphDam SphDam::with_spacing(double spacing) const {
  SphDam other = *this;
  other.geometry.spacing = spacing;
  return other;
}

Curve SphCollapse::free_front() const {
  const auto count = std::isnan(reaches_wall)
                         ? T.size()
                         : static_cast<std::size_t>(std::lower_bound(T.begin(), T.end(), reaches_wall) - T.begin());
  return {std::span(T).first(count), std::span(front).first(count)};
}

SphCollapse collapse(const SphDam& dam, const Watch& watch, const std::vector<double>& frames,
                     const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame,
                     const std::function<void(double)>& progress) {
  wcsph::Scene scene = wcsph::dam_break(dam.geometry, dam.settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, dam.settings);
  const auto [unit, last, samples] = watch;
  SphCollapse result{.spacing = scene.spacing,
                     .sound_speed = dam.settings.sound_speed,
                     .particles = flow.particles().size(),
                     .reaches_wall = std::numeric_limits<double>::quiet_NaN()};
  const double a = dam.geometry.width;
  const double first_energy = flow.totals().energy();
  const double h = flow.smoothing_length();
  std::size_t next = 0;
  for (long n = 0; n <= samples; ++n) {
    const double T = last * static_cast<double>(n) / static_cast<double>(samples);
    for (; next < frames.size() && frames[next] <= T; ++next) {
      march(flow, frames[next] / unit);
      if (on_frame) on_frame(next, flow);
    }
    march(flow, T / unit);
    result.T.push_back(T);
    result.front.push_back((wcsph::front_position(flow.particles(), h) - scene.rear_wall) / a);
    result.height.push_back((wcsph::column_height(flow.particles(), h, scene.rear_wall + 3 * scene.spacing,
                                                  scene.rear_wall + 6 * scene.spacing) -
                             scene.bottom) /
                            a);
    result.energy.push_back(flow.totals().energy() / first_energy);
    if (std::isnan(result.reaches_wall) && result.front.back() * a > scene.far_wall - 2 * h) result.reaches_wall = T;
    if (progress) progress(static_cast<double>(n) / static_cast<double>(samples));
  }
  result.lost =
      flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, std::numeric_limits<double>::max());
  result.steps = flow.steps();
  result.extremes = flow.extremes();
  result.roundings = scene.warnings;
  return result;
}

void exchange(Tape& tape, SphCollapse& s) {
  tape(s.spacing, s.sound_speed, s.particles, s.T, s.front, s.height, s.energy, s.reaches_wall, s.lost, s.steps,
       s.extremes, s.roundings);
}

void measure_run(evidence::Exhibit& exhibit, const SphCollapse& run) {
  exhibit.measure("particles", static_cast<double>(run.particles));
  exhibit.measure("steps", static_cast<double>(run.steps));
  exhibit.measure("largest_mach_number", run.extremes.mach);
  exhibit.measure("lowest_density", run.extremes.lowest_density);
  exhibit.measure("highest_density", run.extremes.highest_density);
  exhibit.measure("rebuilds", static_cast<double>(run.extremes.rebuilds));
  exhibit.measure("particles_lost", static_cast<double>(run.lost));
}

}  // namespace seiche::validation
