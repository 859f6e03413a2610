// Orders of convergence of the conservative particle method where exact solutions are smooth, and its errors where not.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/exact/shallow_water/simple_wave.hpp"
#include "seiche/exact/shallow_water/thacker.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/manufactured/lagrangian_manufactured.hpp"
#include "verification/check.hpp"

namespace particles_orders_test {

using namespace seiche::shallow_water_particles;
using seiche::Largest;
using seiche::largest;
using seiche::Worst;
using namespace seiche::verification;

constexpr double gravity = 9.81;

TEST_CASE("a smooth simple wave converges with first (G1) and second order (M2, H2)", "[manufactured]") {
  Check check("particles_simple_wave", "Smooth simple wave",
              "A right-going hump $h = 1 + 0.2\\cos^6(\\pi(x-6)/6)$ steepens until t = 0.9 s, before it breaks. "
              "Mean-value errors of the depth against the exact simple wave. Hand-over must not mistake the "
              "compression for a jump: H2 equals M2.");
  const double celerity = std::sqrt(gravity);
  const auto depth = [](double x) {
    const double y = x - 6;
    return std::abs(y) < 3 ? 1 + 0.2 * std::pow(std::cos(std::numbers::pi * y / 6), 6) : 1.0;
  };
  const auto slope = [](double x) {
    const double y = x - 6;
    const double a = std::numbers::pi / 6;
    return std::abs(y) < 3 ? -1.2 * a * std::pow(std::cos(a * y), 5) * std::sin(a * y) : 0.0;
  };
  const seiche::exact::SimpleWave exact(gravity, 1, {depth, slope, 3, 9});
  auto& panel = check.figure("convergence", "Error of a smooth wave", "Mean-value L1 error of the depth.")
                    .panel({.x = "particle width [m]", .y = "L1 error of h [m]", .log_x = true, .log_y = true});
  std::vector<double> second_order;
  for (const Level level : {Level::godunov, Level::muscl, Level::hand_over}) {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const std::size_t count : {std::size_t{200}, std::size_t{400}, std::size_t{800}, std::size_t{1600}}) {
      Scheme scheme;
      scheme.level = level;
      ParticleFlow flow(
          particles_from_profile(equal_width_edges(0, 20, count), depth,
                                 [&](double x) { return 2 * (std::sqrt(gravity * depth(x)) - celerity); }),
          {}, {}, scheme);
      march(flow, 0.9);
      sizes.push_back(20.0 / static_cast<double>(count));
      errors.push_back(cell_error(
                           flow.measured_profile(), [&](double x) { return exact.at(x, 0.9); }, exact.breakpoints(0.9))
                           .depth.l1);
    }
    const std::string name = level == Level::godunov ? "G1" : (level == Level::muscl ? "M2" : "H2");
    panel.points(name, sizes, errors);
    if (level == Level::godunov) {
      check.that({.id = "order_G1",
                  .text = "The depth of scheme G1 converges at first order.",
                  .quantity = "order of L1(h)",
                  .source = "Godunov (1959)"},
                 observed_order(sizes, errors),
                 Order{1, 0.2, "first order from below: wide particles smear the crest"});
    } else {
      check.that({.id = "order_" + name,
                  .text = "The depth of scheme " + name + " converges at second order.",
                  .quantity = "order of L1(h)",
                  .source = "van Leer (1979)"},
                 observed_order(sizes, errors),
                 Order{2, 0.5,
                       "the limiter drops to first order over a few particles at the crest, whose share of L1 "
                       "shrinks faster than second order"});
    }
    if (level == Level::muscl) second_order = errors;
    if (level == Level::hand_over) {
      check.that({.id = "same",
                  .text = "No smooth compression is taken for a jump.",
                  .quantity = "difference of the errors of H2 and M2",
                  .unit = "m",
                  .source = "definition of H2"},
                 {.value = errors.back() - second_order.back(), .resolution = "N = 1600"},
                 Bound{0, "without a jump both run the same operations"});
    }
  }
}

TEST_CASE("a manufactured Lagrangian motion converges with second order", "[manufactured]") {
  Check check("particles_manufactured", "Manufactured motion with a momentum source",
              "$x(\\xi,t) = \\xi + A \\sin k\\xi \\sin\\omega t$ between walls, driven by a momentum source only, so "
              "that masses stay exact. Edges and mass-mean velocities have exact references.");
  const seiche::validation::LagrangianManufactured exact(gravity);
  std::vector<double> sizes;
  std::vector<double> edge_errors;
  std::vector<double> velocity_errors;
  for (const std::size_t count : {std::size_t{320}, std::size_t{480}, std::size_t{640}, std::size_t{960}}) {
    Particles start;
    start.edge = equal_width_edges(0, 1, count);
    const Array labels = start.edge;
    for (std::size_t i = 0; i < count; ++i) {
      start.mass.push_back(labels[i + 1] - labels[i]);
      start.velocity.push_back(exact.mean_velocity(labels[i], labels[i + 1], 0));
    }
    Forcing forcing;
    forcing.body_force = [&](double x, double t) { return exact.source(x, t); };
    ParticleFlow flow(start, {}, forcing);
    march(flow, 1);
    double edge = 0;
    double velocity = 0;
    const auto n = static_cast<double>(count);
    for (std::size_t k = 0; k <= count; ++k) {
      edge += std::abs(flow.particles().edge[k] - exact.position(labels[k], 1)) / n;
    }
    for (std::size_t i = 0; i < count; ++i) {
      velocity += std::abs(flow.particles().velocity[i] - exact.mean_velocity(labels[i], labels[i + 1], 1)) / n;
    }
    sizes.push_back(1 / n);
    edge_errors.push_back(edge);
    velocity_errors.push_back(velocity);
    if (count == 320) {
      check.that({.id = "momentum",
                  .text = "Momentum equals the impulses of walls and source.",
                  .quantity = "momentum defect",
                  .unit = "m^3/s",
                  .source = "conservation of momentum"},
                 {.value = flow.momentum_defect(), .resolution = "N = 320"},
                 Roundoff{6, flow.ledger().left_impulse.value(),
                          "the books of the walls and of the source, their sum, and what is left of three numbers "
                          "are rounded once, as large as the impulse of a wall, for sums are compensated; momenta "
                          "of single particles are a thousandth of that"});
    }
  }
  check.that({.id = "edges",
              .text = "Positions of the edges converge at second order.",
              .quantity = "order of L1(x)",
              .source = "method of manufactured solutions"},
             observed_order(sizes, edge_errors),
             Order{2, 0.35,
                   "approaches 2 from below (1.65, 1.83, 1.91 from 160 to 1280): errors of the limited "
                   "extrema and of the rest cancel on coarse rows"});
  check.that({.id = "velocities",
              .text = "Velocities of the particles converge at second order.",
              .quantity = "order of L1(u)",
              .source = "method of manufactured solutions"},
             observed_order(sizes, velocity_errors),
             Order{2, 0.35, "approaches 2 from above: the limited extrema shrink with the width"});
  auto& panel = check.figure("convergence", "Manufactured motion", "Errors at t = 1.")
                    .panel({.x = "particle width [m]", .y = "L1 error", .log_x = true, .log_y = true});
  panel.points("edges [m]", sizes, edge_errors);
  panel.points("velocities [m/s]", sizes, velocity_errors);
}

TEST_CASE("a planar surface in a parabolic bowl keeps its shoreline", "[manufactured]") {
  Check check("particles_thacker", "Planar surface in a parabolic bowl",
              "All water moves alike, the shorelines run up and down the slope. A linear surface is reproduced exactly "
              "in every particle including those at the shorelines, so what is left is the error in time: the step is "
              "the leapfrog map of an oscillator, with the phase error $(\\omega\\tau)^2/24$. Over three periods that "
              "bounds the displacement by $a\\,(6\\pi)(\\omega\\tau)^2/24$ times the amplitude.");
  const seiche::exact::Thacker exact(gravity, 1, 0.5, 4);
  Convergence errors;
  for (const std::size_t count : {std::size_t{25}, std::size_t{50}, std::size_t{100}, std::size_t{200}}) {
    const double left = exact.left_shoreline(0);
    const double right = exact.right_shoreline(0);
    const auto volume = [&](double x) {
      // h = h0 (1 - y^2) with y measured from the middle of the water, radius 1.
      const double y = x - 0.5 * (left + right);
      return 0.5 * (y - y * y * y / 3);
    };
    const Array edges = equal_mass_edges(volume, left, right, count);
    Forcing forcing;
    forcing.bed = exact.bed();
    ParticleFlow flow(particles_from_primitives(edges, volume, [](double) { return 0.0; }), {Vacuum{}, Vacuum{}},
                      forcing);
    Worst error;
    const double end = 3 * exact.period();
    while (flow.time() < end * (1 - 1e-12)) {
      flow.advance(std::min(flow.largest_step().tau, end - flow.time()));
      for (std::size_t k = 0; k <= count; ++k) {
        error.add(flow.particles().edge[k] - exact.carried(edges[k], flow.time()));
      }
    }
    errors.add(2.0 / static_cast<double>(count), error.value());
    if (count == 200) {
      check.that({.id = "shoreline",
                  .text = "No edge, shorelines included, is off by more than 1e-5 m in 3 periods.",
                  .quantity = "largest error of an edge",
                  .unit = "m",
                  .source = "Thacker, JFM 107 (1981) 499"},
                 {.value = error.value(), .resolution = "N = 200, equal masses, Courant 0.4"},
                 Bound{1e-5, "1/2 6 pi (omega tau)^2/24 with tau = 1.2e-3 s is 5.6e-6 m; twice that is allowed"});
    }
  }
  check.that({.id = "order",
              .text = "The error falls with the square of the step.",
              .quantity = "order",
              .source = "Thacker, JFM 107 (1981) 499"},
             errors.order(), Order{2, 0.35, "the phase error of the leapfrog map"});
}

}  // namespace particles_orders_test
