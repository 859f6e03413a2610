#include "validation/studies/shallow_water/profile_measures.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::validation {

void ProfileCurve::add(double place, State state) {
  x.push_back(place);
  depth.push_back(state.depth);
  velocity.push_back(state.velocity);
}

double centre_of(const Profile& profile, std::size_t cell) {
  return 0.5 * (profile.edges[cell] + profile.edges[cell + 1]);
}

ProfileCurve exact_curve(const FlowProblem& problem, double from, double to, double t) {
  constexpr int samples = 400;
  std::vector<double> x;
  for (int k = 0; k <= samples; ++k) x.push_back(from + (to - from) * k / samples);
  for (const double p : problem.breakpoints(t)) {
    if (p <= from || p >= to) continue;
    const double hair = 1e-9 * (to - from);
    x.insert(x.end(), {p - hair, p + hair});
  }
  std::sort(x.begin(), x.end());
  ProfileCurve curve;
  for (const double at : x) curve.add(at, problem.exact(at, t));
  return curve;
}

ProfileCurve exact_curve(const FlowProblem& problem, const Profile& profile, double t) {
  return exact_curve(problem, std::min(problem.start, profile.edges.front()),
                     std::max(problem.end, profile.edges.back()), t);
}

ProfileCurve computed_curve(const Profile& profile) {
  ProfileCurve curve;
  constexpr int samples = 4;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    std::vector<double> places;
    const double a = profile.edges[i];
    const double b = profile.edges[i + 1];
    const double hair = 1e-9 * (b - a);
    for (int k = 0; k <= samples; ++k) places.push_back(a + hair + (b - a - 2 * hair) * k / samples);
    for (const double p : profile.breaks) {
      if (p > a && p < b) places.insert(places.end(), {p - hair, p + hair});
    }
    std::sort(places.begin(), places.end());
    for (const double x : places) curve.add(x, profile.reconstruction(x));
  }
  return curve;
}

ProfileCurve means_of(const Profile& profile) {
  ProfileCurve means;
  for (std::size_t i = 0; i < profile.means.size(); ++i) means.add(centre_of(profile, i), profile.means[i]);
  return means;
}

namespace measures = shallow_water;

ProfileErrors ProfileErrors::none() {
  constexpr measures::Norms norms{nan, nan, nan};
  return {.cell = {norms, norms}, .reconstructed = {norms, norms}, .constant = {norms, norms}};
}

ProfileErrors profile_errors(const Profile& profile, const FlowProblem& problem, double t) {
  const auto exact = [&](double x) { return problem.exact(x, t); };
  const std::vector<double> breaks = problem.breakpoints(t);
  return {.cell = measures::cell_error(profile, exact, breaks),
          .reconstructed = measures::reconstruction_error(profile, exact, breaks),
          .constant = measures::piecewise_constant_error(profile, exact, breaks)};
}

Worst excursion(const Profile& profile, double lowest, double highest) {
  Worst outside;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    const double depth = profile.means[i].depth;
    outside.add(depth - std::clamp(depth, lowest, highest), centre_of(profile, i));
  }
  return outside;
}

double front_width(const Profile& profile, const Front& front) {
  if (std::isnan(front_position(profile, front))) return nan;
  const double from = front.position - front.reach;
  const double to = front.position + front.reach;
  Count between;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    if (profile.edges[i + 1] <= from || profile.edges[i] >= to) continue;
    between.add((profile.means[i].depth - front.ahead) / (front.behind - front.ahead),
                [](double share) { return share > 0.05 && share < 0.95; });
  }
  return between.value();
}

double front_position(const Profile& profile, const Front& front) {
  const double middle = 0.5 * (front.behind + front.ahead);
  Smallest nearest;
  const auto consider = [&](double x) {
    const double distance = std::abs(x - front.position);
    if (!(distance > front.reach)) nearest.add(distance, x);
  };
  // A jump inside a cell is where the method says it is.
  for (const double x : profile.breaks) {
    const double hair = 1e-9 * front.reach;
    const double left = profile.reconstruction(x - hair).depth;
    const double right = profile.reconstruction(x + hair).depth;
    const bool inside = std::find(profile.edges.begin(), profile.edges.end(), x) == profile.edges.end();
    if (inside && (left - middle) * (right - middle) < 0) consider(x);
  }
  if (std::isfinite(nearest.where())) return nearest.where();
  // A captured jump is where the means cross the mid-depth.
  for (std::size_t i = 0; i + 1 < profile.means.size(); ++i) {
    const double a = profile.means[i].depth - middle;
    const double b = profile.means[i + 1].depth - middle;
    if (a * b > 0 || a == b) continue;
    const double left = centre_of(profile, i);
    consider(left + (centre_of(profile, i + 1) - left) * a / (a - b));
  }
  return nearest.where();
}

}  // namespace seiche::validation
