#include "validation/instruments/particles/sph_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// A fluid particle: `along` is the coordinate that is looked for, `across` the other.
struct Candidate {
  double along, across;
};

/// The largest `along` of candidates with enough others within reach, among those that `counts` admits.
template <class Counts>
double farthest(std::vector<Candidate> candidates, double reach, int neighbours, Counts counts) {
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.along > b.along; });
  std::size_t first = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    while (candidates[first].along > candidates[i].along + reach) ++first;
    if (!counts(candidates[i])) continue;
    int found = -1;  // itself
    for (std::size_t k = first; k < candidates.size() && candidates[k].along > candidates[i].along - reach; ++k) {
      const double distance =
          std::hypot(candidates[k].along - candidates[i].along, candidates[k].across - candidates[i].across);
      if (distance < reach && ++found >= neighbours) return candidates[i].along;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double front_position(const Particles& particles, double smoothing_length, int neighbours) {
  require_positive("smoothing_length", smoothing_length);
  require_at_least("neighbours", neighbours, 0);
  std::vector<Candidate> fluid;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] == Kind::fluid) fluid.push_back({particles.x[i], particles.z[i]});
  }
  return farthest(std::move(fluid), support * smoothing_length, neighbours, [](const Candidate&) { return true; });
}

double column_height(const Particles& particles, double smoothing_length, double left, double right, int neighbours) {
  require_positive("smoothing_length", smoothing_length);
  require_finite("left", left);
  require_positive("right - left", right - left);
  require_at_least("neighbours", neighbours, 0);
  const double reach = support * smoothing_length;
  std::vector<Candidate> fluid;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool near = particles.x[i] > left - reach && particles.x[i] < right + reach;
    if (near && particles.kind[i] == Kind::fluid) fluid.push_back({particles.z[i], particles.x[i]});
  }
  return farthest(std::move(fluid), reach, neighbours,
                  [&](const Candidate& c) { return c.across >= left && c.across <= right; });
}

}  // namespace seiche::wcsph
