/// Points of a surface, from the arrays that flows keep.
#pragma once

#include <span>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche::validation {

inline std::vector<Point> joined(Places at) {
  std::vector<Point> points;
  for (int k = 0; k < at.size(); ++k) points.push_back(at[k]);
  return points;
}

/// Of these nodes alone.
inline std::vector<Point> chosen(std::span<const int> nodes, Places at) {
  std::vector<Point> points;
  for (const int node : nodes) points.push_back(at[node]);
  return points;
}

}  // namespace seiche::validation
