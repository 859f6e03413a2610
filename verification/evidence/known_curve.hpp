/// Curves whose points are known.
#pragma once

#include <cmath>
#include <vector>

#include "validation/instruments/agreement.hpp"

namespace seiche::verification {

struct Points {
  std::vector<double> x, y;
  [[nodiscard]] validation::Curve curve() const { return {x, y}; }
};

/// At the ends of equal intervals of a range.
template <class Function>
Points sampled(double from, double to, int intervals, const Function& f) {
  Points points;
  for (int k = 0; k <= intervals; ++k) {
    points.x.push_back(std::lerp(from, to, static_cast<double>(k) / intervals));
    points.y.push_back(f(points.x.back()));
  }
  return points;
}

}  // namespace seiche::verification
