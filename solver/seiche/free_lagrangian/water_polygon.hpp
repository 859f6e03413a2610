/// Gravity of the polygon of water within an outline of nodes: its exact potential energy, counted from y = 0, and the
/// forces on the nodes (Frank 1994, formula 7).
///
/// @f[ \Pi = \rho g \sum_{ab} \frac{(x_a - x_b)(y_a^2 + y_a y_b + y_b^2)}{6}, @f]
///
/// the sum over the edges ab of the outline, counter-clockwise.
#pragma once

#include <span>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche::free_lagrangian {

/// @param weight  rho g
double potential_energy(Places at, std::span<const int> outline, double weight);

/// -dPi/dr of all nodes, in place of what is there.
void gravity_forces(Places at, std::span<const int> outline, double weight, std::vector<Point>& force);

}  // namespace seiche::free_lagrangian
