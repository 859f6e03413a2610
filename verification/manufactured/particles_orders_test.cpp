// Orders of convergence of the conservative particle method where exact solutions are smooth, and its errors where not.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seiche/exact/shallow_water/simple_wave.hpp"
#include "seiche/exact/shallow_water/thacker.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/manufactured/lagrangian_manufactured.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::particles_orders_test {

using namespace shallow_water_particles;

constexpr double gravity = 9.81;

TEST_CASE("a smooth simple wave converges with first (G1) and second order (M2, H2)", "[manufactured]") {
  Check check("particles_simple_wave", "Smooth simple wave",
              "A right-going hump $h = 1 + 0.2\\cos^6(\\pi(x-6)/6)$ steepens until t = 0.9 s, before it breaks. "
              "Mean-value errors of the depth against the exact simple wave. Hand-over must not mistake the "
              "compression for a jump: H2 equals M2.",
              "Godunov (1959)");
  const auto exact = exact::SimpleWave::hump(gravity, 1, 0.2, 6, 6);
  const auto error = [&](Level level, double width) {
    ParticleFlow flow(particles_from_profile(
                          equal_width_edges(0, 20, cells_of(20, width)), [&](double x) { return exact.at(x, 0).depth; },
                          [&](double x) { return exact.at(x, 0).velocity; }),
                      {}, {}, {.level = level});
    march(flow, 0.9);
    return cell_error(
               flow.measured_profile(), [&](double x) { return exact.at(x, 0.9); }, exact.breakpoints(0.9))
        .depth.l1;
  };
  const Order second{2, 0.5,
                     "the limiter drops to first order over a few particles at the crest, whose share of L1 shrinks "
                     "faster than second order"};
  const auto errors = refine(
      check, {"particle width [m]", widths(20, {200, 400, 800, 1600})},
      {{"order_G1", "The depth of scheme G1 converges at first order.",
        Order{1, 0.2, "first order from below: wide particles smear the crest"}},
       {"order_M2", "The depth of scheme M2 converges at second order.", second},
       {"order_H2", "The depth of scheme H2 converges at second order.", second}},
      [&](double width) {
        return std::array{error(Level::godunov, width), error(Level::muscl, width), error(Level::hand_over, width)};
      });
  check.that("same", "The difference of the errors of H2 and M2 in a smooth compression is zero.",
             "difference of the errors of H2 and M2 [m]",
             {.value = errors[2].back() - errors[1].back(), .resolution = "N = 1600"},
             Bound{0, "without a jump both run the same operations"});
}

TEST_CASE("a manufactured Lagrangian motion converges with second order", "[manufactured]") {
  Check check("particles_manufactured", "Manufactured motion with a momentum source",
              "$x(\\xi,t) = \\xi + A \\sin k\\xi \\sin\\omega t$ between walls, driven by a momentum source only, so "
              "that masses stay exact. Edges and mass-mean velocities have exact references.",
              "method of manufactured solutions");
  const validation::LagrangianManufactured exact(gravity);
  refine(
      check, {"particle width [m]", widths(1, {320, 480, 640, 960})},
      {{"edges", "Positions of the edges converge at second order.",
        Order{2, 0.35,
              "approaches 2 from below (1.65, 1.83, 1.91 from 160 to 1280): errors of the limited extrema and of the "
              "rest cancel on coarse rows"}},
       {"velocities", "Velocities of the particles converge at second order.",
        Order{2, 0.35, "approaches 2 from above: the limited extrema shrink with the width"}}},
      [&](double width) {
        const std::size_t count = cells_of(1, width);
        Particles start;
        start.edge = equal_width_edges(0, 1, count);
        const Array labels = start.edge;
        for (std::size_t i = 0; i < count; ++i) {
          start.mass.push_back(labels[i + 1] - labels[i]);
          start.velocity.push_back(exact.mean_velocity(labels[i], labels[i + 1], 0));
        }
        ParticleFlow flow(start, {}, {.body_force = [&](double x, double t) { return exact.source(x, t); }});
        march(flow, 1);
        double edge = 0, velocity = 0;
        for (std::size_t k = 0; k <= count; ++k) {
          edge += std::abs(flow.particles().edge[k] - exact.position(labels[k], 1)) * width;
        }
        for (std::size_t i = 0; i < count; ++i) {
          velocity += std::abs(flow.particles().velocity[i] - exact.mean_velocity(labels[i], labels[i + 1], 1)) * width;
        }
        if (count == 320) {
          check.from("conservation of momentum")
              .that("momentum", "Momentum equals the impulses of walls and source to round-off.",
                    "momentum error [m^3/s]", {.value = flow.momentum_defect(), .resolution = "N = 320"},
                    Roundoff{6, flow.ledger().left_impulse.value(),
                             "the recorded impulses of the walls and of the source, their sum, and the difference of "
                             "three numbers are rounded once at the size of a wall's impulse, because sums are "
                             "compensated; momenta of single particles are a thousandth of that"});
        }
        return std::array{edge, velocity};
      });
}

TEST_CASE("a planar surface in a parabolic bowl retains its shoreline", "[manufactured]") {
  Check check("particles_thacker", "Planar surface in a parabolic bowl",
              "All water moves alike, the shorelines run up and down the slope. A linear surface is reproduced exactly "
              "in every particle including those at the shorelines, so the remaining error is in time: the step is the "
              "leapfrog map of an oscillator, with the phase error $(\\omega\\tau)^2/24$. Over three periods that "
              "bounds the displacement by $a\\,(6\\pi)(\\omega\\tau)^2/24$ times the amplitude.",
              "Thacker, JFM 107 (1981) 499");
  const exact::Thacker exact(gravity, 1, 0.5, 4);
  const auto errors = refine(
      check, {"particle's mass", widths(2, {25, 50, 100, 200})},
      {{"order", "The error falls at second order in the step.", {2, 0.35, "the phase error of the leapfrog map"}}},
      [&](double mass) {
        const std::size_t count = cells_of(2, mass);
        // h = h0 (1 - y^2) with y measured from the middle of the water, radius 1: int h dy = h0 (y - y^3/3), and the
        // share -1 < s < 1 of it is at y = 2 sin(asin(s)/3).
        const double middle = 0.5 * (exact.left_shoreline(0) + exact.right_shoreline(0));
        Particles start;
        for (std::size_t k = 0; k <= count; ++k) {
          const double share = 2 * static_cast<double>(k) / static_cast<double>(count) - 1;
          start.edge.push_back(middle + 2 * std::sin(std::asin(share) / 3));
        }
        start.mass.assign(count, exact.area() / static_cast<double>(count));
        start.velocity.assign(count, 0.0);
        const Array edges = start.edge;
        ParticleFlow flow(start, {Vacuum{}, Vacuum{}}, {.bed = exact.bed()});
        Worst error;
        march(
            flow, 3 * exact.period(), [&](double) { return flow.largest_step().tau; },
            [&] {
              for (std::size_t k = 0; k <= count; ++k) {
                error.add(flow.particles().edge[k] - exact.carried(edges[k], flow.time()));
              }
            });
        return error.value();
      });
  check.that("shoreline", "The error of edge positions, shorelines included, is below 1e-5 m after 3 periods.",
             "largest error of an edge [m]",
             {.value = errors[0].back(), .resolution = "N = 200, equal masses, Courant 0.4"},
             Bound{1e-5, "1/2 6 pi (omega tau)^2/24 with tau = 1.2e-3 s is 5.6e-6 m; twice that is allowed"});
}

}  // namespace seiche::verification::particles_orders_test
