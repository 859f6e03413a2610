#include "validation/steady_flow/settled_flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

std::vector<long> numbers_of_particles(long coarsest) {
  std::vector<long> numbers;
  for (int k = 0; k < numbers_of_resolutions; ++k) {
    numbers.push_back(std::lround(static_cast<double>(coarsest) * std::pow(2.0, 0.5 * k)));
  }
  return numbers;
}

Settled settle(const OpenReach& reach, long particles, double time, const Run::Progress& progress,
               const std::function<void(const Profile&)>& look) {
  using namespace shallow_water_particles;
  Open outflow;
  if (reach.outflow_depth) outflow.depth = [h = *reach.outflow_depth](double) { return h; };
  const auto velocity = [&](double x) { return reach.discharge / reach.start_depth(x); };
  ParticleFlow flow(
      particles_from_profile(equal_width_edges(0, reach.length, static_cast<std::size_t>(particles)), reach.start_depth,
                             velocity),
      {.left = Open{.discharge = [q = reach.discharge](double) { return q; }, .depth = {}}, .right = outflow},
      reach.forcing);
  double next = 0.8 * time;
  while (flow.time() < time * (1 - 1e-12)) {
    flow.advance(std::min(flow.largest_step().tau, time - flow.time()));
    progress(flow.time() / time);
    if (flow.time() < next) continue;
    next += 0.2 * time / 32;
    look(flow.measured_profile());
  }
  return {flow.measured_profile(), flow.mass_defect(), flow.momentum_defect()};
}

Profile part_of(const Profile& whole, double from, double to) {
  Profile part;
  for (std::size_t i = 0; i < whole.means.size(); ++i) {
    if (whole.edges[i] < from || whole.edges[i + 1] > to) continue;
    if (part.edges.empty()) part.edges.push_back(whole.edges[i]);
    part.edges.push_back(whole.edges[i + 1]);
    part.means.push_back(whole.means[i]);
  }
  if (part.means.empty()) {
    throw std::runtime_error(fmt::format(
        "no particle lies wholly between x = {:g} and {:g} at some time: the flow there is not resolved", from, to));
  }
  return part;
}

double mean_discharge_error(const Profile& profile, double discharge) {
  Mean error;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    const State& s = profile.means[i];
    error.add(std::abs(s.depth * s.velocity / discharge - 1), profile.edges[i + 1] - profile.edges[i]);
  }
  return error.value();
}

}  // namespace seiche::validation
