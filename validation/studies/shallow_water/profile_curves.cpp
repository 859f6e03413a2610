#include "validation/studies/shallow_water/profile_curves.hpp"

#include <algorithm>

namespace seiche::validation {

ExactCurve exact_curve(const FlowProblem& problem, double from, double to, double t) {
  constexpr int samples = 400;
  std::vector<double> x;
  for (int k = 0; k <= samples; ++k) x.push_back(from + (to - from) * k / samples);
  for (const double p : problem.breakpoints(t)) {
    if (p <= from || p >= to) continue;
    const double hair = 1e-9 * (to - from);
    x.insert(x.end(), {p - hair, p + hair});
  }
  std::sort(x.begin(), x.end());
  ExactCurve curve{.x = x, .depth = {}, .velocity = {}};
  for (const double at : x) {
    const State s = problem.exact(at, t);
    curve.depth.push_back(s.depth);
    curve.velocity.push_back(s.velocity);
  }
  return curve;
}

ExactCurve exact_curve(const FlowProblem& problem, const Profile& profile, double t) {
  return exact_curve(problem, std::min(problem.start, profile.edges.front()),
                     std::max(problem.end, profile.edges.back()), t);
}

ExactCurve computed_curve(const Profile& profile) {
  ExactCurve curve;
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
    for (const double x : places) {
      const State s = profile.reconstruction(x);
      curve.x.push_back(x);
      curve.depth.push_back(s.depth);
      curve.velocity.push_back(s.velocity);
    }
  }
  return curve;
}

Means means_of(const Profile& profile) {
  Means means;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    means.centre.push_back(0.5 * (profile.edges[i] + profile.edges[i + 1]));
    means.depth.push_back(profile.means[i].depth);
    means.velocity.push_back(profile.means[i].velocity);
  }
  return means;
}

}  // namespace seiche::validation
