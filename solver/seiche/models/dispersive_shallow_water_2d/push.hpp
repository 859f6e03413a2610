/// Horizontal impulses on nodes of the plan model.
#pragma once

#include <cstddef>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"

namespace seiche::dispersive_shallow_water_2d {

struct Impulse {
  double x, y;
};

/// u += W impulse.
inline void push(const InverseMasses& inverse, std::size_t k, Impulse impulse, mechanics::Output u) {
  const std::size_t n = inverse.xx.size();
  u[k] += inverse.xx[k] * impulse.x + inverse.xy[k] * impulse.y;
  u[n + k] += inverse.xy[k] * impulse.x + inverse.yy[k] * impulse.y;
  u[2 * n + k] += inverse.xz[k] * impulse.x + inverse.yz[k] * impulse.y;
}

}  // namespace seiche::dispersive_shallow_water_2d
