#include "validation/instruments/mesh/crest_track.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "seiche/samples.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {
namespace {

/// Index of the first time that is not before `from`, whatever its last digit.
std::size_t first_at(const std::vector<double>& time, double from) {
  return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from * (1 - 1e-12)) - time.begin());
}

std::span<const double> since(const std::vector<double>& values, std::size_t first) {
  return std::span(values).subspan(first);
}

}  // namespace

double CrestTrack::speed(double from) const {
  const std::size_t first = first_at(time, from);
  const double middle = mean(since(time, first));
  double moment = 0;
  double spread = 0;
  for (std::size_t k = first; k < time.size(); ++k) {
    moment += (time[k] - middle) * (place[k] - place.back());
    spread += (time[k] - middle) * (time[k] - middle);
  }
  return moment / spread;
}

double CrestTrack::mean_elevation(double from) const {
  return mean(since(elevation, first_at(time, from)));
}

CrestTrack follow_crest(lagrangian_mesh_2d::Flow& flow, double time, double tau,
                        const std::function<void()>& after_step) {
  CrestTrack track;
  Smallest corner;
  const auto add = [&] {
    const lagrangian_mesh_2d::Flow::Crest crest = flow.crest();
    track.time.push_back(flow.time());
    track.place.push_back(crest.place);
    track.elevation.push_back(crest.elevation);
    corner.add(flow.worst_corner().shape);
  };
  add();
  try {
    march(flow, time, tau, [&] {
      add();
      if (after_step) after_step();
    });
  } catch (const Divergence& divergence) {
    track.folded = divergence;
  }
  track.worst_corner = corner.value();
  return track;
}

double largest_profile_error(const lagrangian_mesh_2d::Flow& flow, double crest, double reach,
                             const std::function<double(double)>& profile) {
  const std::span<const double> x = flow.surface_x();
  const std::span<const double> y = flow.surface_y();
  Worst largest;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i] - crest) <= reach) largest.add(y[i] - profile(x[i] - crest));
  }
  return largest.value();
}

}  // namespace seiche::validation
