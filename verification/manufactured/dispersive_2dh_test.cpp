// The 2DH model against a manufactured motion of a basin: orders in space and time together, and in time alone.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/plan_manufactured.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_2dh_test {

using namespace dispersive_shallow_water_2d;
using mechanics::Stepping;
using validation::PlanManufactured;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";

const PlanManufactured motion;
constexpr double length = std::numbers::pi;  // of the basin's sides
constexpr double end = 2;

/// Of n x n cells.
PlanManufactured::Label label_of(std::size_t node, std::size_t n) {
  const auto place = [n](std::size_t i) {
    return i == n ? length : length * static_cast<double>(i) / static_cast<double>(n);
  };
  return {place(node % (n + 1)), place(node / (n + 1))};
}

/// n x n cells after so many steps, nodes with equally spaced labels, first velocities exact but made to keep the
/// volumes.
Flow run(std::size_t n, Stepping stepping, long steps) {
  Lattice lattice{.shape = {n, n}, .x = {}, .y = {}, .z = {}, .depth = motion.parameters().depth};
  std::map<std::pair<double, double>, PlanManufactured::Label> labels;  // by the places at the beginning
  for (std::size_t k = 0; k < lattice.shape.nodes(); ++k) {
    const PlanManufactured::Label label = label_of(k, n);
    const auto column = motion.at(label.x, label.y, 0);
    lattice.x.push_back(column.x);
    lattice.y.push_back(column.y);
    lattice.z.push_back(column.depth - lattice.depth);
    labels[{column.x, column.y}] = label;
  }
  const auto column_from = [labels](double x, double y, double time) {
    const auto label = labels.at({x, y});
    return motion.at(label.x, label.y, time);
  };
  const auto velocity = [&](double x, double y) {
    const auto column = column_from(x, y, 0);
    return Velocity{column.u, column.v, column.depth_rate};
  };
  const auto force = [column_from](Point place, double time) {
    const auto column = column_from(place.x, place.y, time);
    return Point{column.bx, column.by};
  };
  Flow flow(std::move(lattice), velocity, {.stepping = stepping},
            {.gravity = motion.parameters().gravity, .inertia = motion.parameters().alpha, .tolerance = 1e-11},
            {.body_force = force}, {}, false);
  for (long k = 0; k < steps; ++k) flow.advance(end / static_cast<double>(steps));
  return flow;
}

/// What a node has, and where it is.
struct Node {
  double x, y, z, u, v;
};

/// Of places, elevations and horizontal velocities: L2 norms over the labels, (integral of squares)^(1/2), by the
/// trapezoidal rule on the nodes.
std::array<double, 3> errors_of(const Flow& flow, const std::function<Node(std::size_t k)>& expected) {
  const std::size_t n = flow.shape().columns;
  const auto share = [n](std::size_t i) { return i % n == 0 ? 0.5 : 1.0; };
  Mean place, elevation, velocity;
  for (std::size_t k = 0; k < flow.shape().nodes(); ++k) {
    const double weight = share(k % (n + 1)) * share(k / (n + 1));
    const Node node = expected(k);
    place.add(std::hypot(flow.x()[k] - node.x, flow.y()[k] - node.y), weight);
    elevation.add(flow.z()[k] - node.z, weight);
    velocity.add(std::hypot(flow.u()[k] - node.u, flow.v()[k] - node.v), weight);
  }
  return {length * place.rms(), length * elevation.rms(), length * velocity.rms()};
}

/// Orders of places, elevations and horizontal velocities.
void check_orders(Check& check, Stepping stepping, Refinement refinement, const Order& order,
                  const std::function<std::array<double, 3>(double)>& errors_at) {
  const std::string id = stepping == Stepping::one_step ? "one-step" : "conservative";
  refinement.id = id;
  refine(check, refinement,
         {{id + "-position", id + ": node positions converge at second order.", order},
          {id + "-elevation", id + ": elevations converge at second order.", order},
          {id + "-velocity", id + ": horizontal velocities converge at second order.", order}},
         errors_at);
}

TEST_CASE("the 2DH model is second-order accurate against a manufactured motion", "[manufactured]") {
  Check check("manufactured_dispersive_2dh", "Manufactured motion of a basin: orders in space and time",
              "A basin of sides $\\pi$ whose columns of water follow a prescribed motion under the body force that "
              "sustains it. $n \\times n$ cells with equally spaced labels, steps of a quarter of a cell, $t = 0$ to "
              "$2$: errors in the $L_2$ norm over the labels.",
              source);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    check_orders(check, stepping, {"width of a cell", widths(length, {12, 16, 24, 32, 48})},
                 {2, 0.05, "second order of smooth solutions"}, [&](double width) {
                   const std::size_t n = cells_of(length, width);
                   const Flow flow = run(n, stepping, std::lround(4 * end / width));
                   return errors_of(flow, [&](std::size_t k) {
                     const auto label = label_of(k, n);
                     const auto column = motion.at(label.x, label.y, end);
                     return Node{column.x, column.y, column.depth - motion.parameters().depth, column.u, column.v};
                   });
                 });
  }
}

TEST_CASE("the 2DH model is second-order accurate in time alone", "[manufactured]") {
  Check check("manufactured_dispersive_2dh_time", "Manufactured motion of a basin: order in time",
              "The same motion on 16 x 16 cells with 16 to 128 steps, against 2048 steps on the same cells: errors of "
              "time alone. The one-step scheme's volumes err by $O(\\tau^2)$ too.",
              source);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const Flow finest = run(16, stepping, 2048);
    const auto of_finest = [&](std::size_t k) {
      return Node{finest.x()[k], finest.y()[k], finest.z()[k], finest.u()[k], finest.v()[k]};
    };
    check_orders(check, stepping, {"step", widths(end, {16, 32, 64, 128})},
                 {2, 0.05, "a symmetric scheme; 2048 steps err by 1/256"},
                 [&](double tau) { return errors_of(run(16, stepping, std::lround(end / tau)), of_finest); });
  }
}

}  // namespace seiche::verification::dispersive_2dh_test
