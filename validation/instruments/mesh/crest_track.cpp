#include "validation/instruments/mesh/crest_track.hpp"

#include <algorithm>
#include <array>
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

/// Highest point of the polynomial of degree four through the highest surface node and two neighbours on each side.
Point crest_of(std::span<const double> xs, std::span<const double> ys) {
  const auto highest = static_cast<std::size_t>(std::max_element(ys.begin(), ys.end()) - ys.begin());
  if (highest < 2 || highest + 2 >= xs.size()) return {xs[highest], ys[highest]};
  // Newton's divided differences around the highest node, then its maximum by Newton's iteration on the derivative.
  std::array<double, 5> s{};
  std::array<double, 5> c{};
  for (std::size_t i = 0; i < 5; ++i) {
    s[i] = xs[highest - 2 + i] - xs[highest];
    c[i] = ys[highest - 2 + i];
  }
  for (std::size_t order = 1; order < 5; ++order) {
    for (std::size_t i = 4; i >= order; --i) c[i] = (c[i] - c[i - 1]) / (s[i] - s[i - order]);
  }
  struct Local {
    double value, slope, curvature;
  };
  const auto at = [&](double z) {
    Local p{c[4], 0, 0};
    for (std::size_t i = 4; i-- > 0;) {
      p.curvature = 2 * p.slope + (z - s[i]) * p.curvature;
      p.slope = p.value + (z - s[i]) * p.slope;
      p.value = c[i] + (z - s[i]) * p.value;
    }
    return p;
  };
  double z = 0;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Local p = at(z);
    if (!(p.curvature < 0)) break;
    z = std::clamp(z - p.slope / p.curvature, s[1], s[3]);
  }
  return {xs[highest] + z, at(z).value};
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
    const Point crest = crest_of(flow.surface_x(), flow.surface_y());
    track.time.push_back(flow.time());
    track.place.push_back(crest.x);
    track.elevation.push_back(crest.y);
    corner.add(flow.worst_corner().shape);
  };
  add();
  try {
    march(flow, time, tau, [&] {
      add();
      if (after_step) after_step();
    });
  } catch (const Divergence& divergence) {
    track.tangled = divergence;
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
