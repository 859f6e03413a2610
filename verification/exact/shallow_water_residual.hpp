/// How well a solution satisfies the shallow-water equations at a point, by fourth-order central differences.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "seiche/samples.hpp"
#include "seiche/shallow_water/relations.hpp"
#include "verification/difference.hpp"

namespace seiche::verification {

/// Larger of the two residuals h_t + (h u)_x and (h u)_t + (h u^2 + g h^2/2)_x + g h z_x - h f.
///
/// @param state   callable (x, t) -> State, smooth within two differences of the point
/// @param spans   half-widths of the differences in x [m] and t [s]
/// @param slope   z_x at x;  @param force  f at (x, t)
template <class StateAt>
double shallow_water_residual(const StateAt& state, double gravity, double x, double t, double span_x, double span_t,
                              double slope = 0, double force = 0) {
  const auto discharge = [&](double dx, double dt) {
    const shallow_water::State s = state(x + dx, t + dt);
    return s.depth * s.velocity;
  };
  const auto thrust = [&](double dx) {
    const shallow_water::State s = state(x + dx, t);
    return s.depth * s.velocity * s.velocity + shallow_water::thrust(gravity, s.depth);
  };
  const double mass = difference([&](double dt) { return state(x, t + dt).depth; }, span_t) +
                      difference([&](double dx) { return discharge(dx, 0); }, span_x);
  const double depth = state(x, t).depth;
  const double momentum = difference([&](double dt) { return discharge(0, dt); }, span_t) + difference(thrust, span_x) +
                          gravity * depth * slope - depth * force;
  return worst(std::array{mass, momentum});
}

}  // namespace seiche::verification
