// Pressure on the free surface of the two-dimensional Lagrangian mesh: uniform, and as a standing pattern that moves
// the water.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::lagrangian_mesh_surface_pressure_test {

using namespace lagrangian_mesh_2d;

const std::vector<std::pair<std::string, Stepping>> schemes{{"One-step scheme", Stepping::one_step},
                                                            {"Conservative scheme", Stepping::conservative}};

/// Still water between a vertical and an inclined wall, nodes inside off their rows and columns.
Mesh distorted_layer() {
  Mesh mesh = layer_mesh_with_slope({.end = 6, .columns = 12, .rows = 4}, 1);
  for (std::size_t j = 1; j < mesh.rows; ++j) {
    for (std::size_t i = 1; i < mesh.columns; ++i) {
      const auto s = static_cast<double>(i + 5 * j);
      mesh.x[mesh.node(i, j)] += 0.04 * std::sin(3 * s);
      mesh.y[mesh.node(i, j)] += 0.02 * std::cos(2 * s);
    }
  }
  return mesh;
}

TEST_CASE("uniform pressure on the surface of the mesh leaves a lake at rest") {
  Check check("lagrangian_mesh_uniform_pressure", "Uniform pressure on a lake at rest",
              "A pressure $p_0$ on all of the free surface gives the pressure $p_0$ in every cell and no motion: the "
              "sum of the areas' gradients is the gradient of the polygon's area, on walls of any inclination. "
              "Distorted mesh of 12 x 4 cells, one wall inclined by 45 degrees.");
  constexpr double p0 = 10, tau = 0.05, steps = 1000;
  const Mesh mesh = distorted_layer();
  for (const auto& [name, stepping] : schemes) {
    Flow flow(mesh, {}, {.stepping = stepping}, {}, {.surface_pressure = [](double, double) { return p0; }});
    Worst pressure;
    for (int n = 0; n < steps; ++n) {
      flow.advance(tau);
      for (const double lambda : flow.multipliers()) pressure.add(lambda - p0);
    }
    const auto lightest = *std::ranges::min_element(flow.model().nodes().mass());
    const double kick = p0 * 0.5 * tau / lightest;  // a node's edge is half a depth long
    check.holds(name + ").",
                {worst(std::array{largest_difference(flow.x(), mesh.x), largest_difference(flow.y(), mesh.y)})},
                Roundoff{48 * steps, kick * tau * std::sqrt(steps),
                         "a step rounds the velocity increment of a node by pressure, p0 h/2 over its mass, once per "
                         "cell; velocities add up as a random walk, positions follow them"});
    check.holds(name + ": all multipliers are the pressure.", {pressure.value()},
                Roundoff{48 * steps, p0,
                         "the solution of 48 equations, and velocities of rounded kicks that must be brought to rest "
                         "again, over 1000 steps"});
  }
}

/// The mode cos(kx) of a level layer under the pressure P cos(kx) sin(sigma t), for small motions.
///
/// Edges press their ends equally by the pressure at the middle, potential energy weighs elevations by (2 + cos kh)/3:
/// the surface is driven towards -P'/(rho g) sin(sigma t),  P' = P 3 cos(kh/2)/(2 + cos kh).
struct DrivenMode {
  double omega, sigma, depression;

  [[nodiscard]] double target(double time) const { return -depression * std::sin(sigma * time); }
  /// The scheme's own steps for a'' = -omega^2 (a - target), from rest.
  [[nodiscard]] std::vector<double> elevations(Stepping stepping, double tau, long steps) const {
    double a = 0, v = 0;
    std::vector<double> all;
    const double w = omega * omega;
    for (long n = 0; n < steps; ++n) {
      const double aim = target((static_cast<double>(n) + 0.5) * tau), free = a + 0.5 * tau * v;
      // The acceleration is that of the middle of the step: free drift, or the mean of both ends.
      const double middle =
          stepping == Stepping::one_step ? free : (free + 0.25 * tau * tau * w * aim) / (1 + 0.25 * tau * tau * w);
      const double before = v;
      v += -tau * w * (middle - aim);
      a += 0.5 * tau * (before + v);
      all.push_back(a);
    }
    return all;
  }
};

TEST_CASE("a pressure pattern on the surface of the mesh drives a standing wave as an oscillator") {
  Check check("lagrangian_mesh_driven_mode", "A standing wave driven by pressure",
              "Water at rest under $P \\cos kx \\sin\\sigma t$. For small pressures the mesh's wave is one oscillator "
              "of the frequency of the mesh's own dispersion law, driven towards the hydrostatic depression; the "
              "scheme steps it by a recursion of two numbers, which is the reference. Runs with $P$ and $-P$ are "
              "subtracted: the remaining nonlinearity is of third order.");
  constexpr std::size_t columns = 24, rows = 4;
  constexpr double length = 6, h = length / columns, k = std::numbers::pi / 3, pressure = 1e-5, tau = 0.1;
  constexpr long steps = 400;
  const double omega = exact::LagrangianMeshDispersion(1, 1, h, rows).frequency(k);
  for (const auto& [name, sigma] : {std::pair{"fast", 1.3}, std::pair{"slow", 0.05}}) {
    const DrivenMode mode{omega, sigma, pressure * 3 * std::cos(k * h / 2) / (2 + std::cos(k * h))};
    auto& panel = check
                      .figure(std::string("elevation-") + name, "Elevation at the wall",
                              "Over the largest pressure; the reference is the oscillator of one mode.")
                      .panel({.x = "t [sqrt(depth/g)]", .y = "elevation/P"});
    for (const auto& [scheme, stepping] : schemes) {
      const auto wall = [&, stepping = stepping, sigma = sigma](double sign) {
        const auto pattern = [=](double x, double t) {
          return sign * pressure * std::cos(k * x) * std::sin(sigma * t);
        };
        Flow flow(layer_mesh({.end = length, .columns = columns, .rows = rows}), {}, {.stepping = stepping}, {},
                  {.surface_pressure = pattern});
        std::vector<double> series;
        for (long n = 0; n < steps; ++n) {
          flow.advance(tau);
          series.push_back(flow.surface_y().front());
        }
        return series;
      };
      const std::vector<double> up = wall(1), down = wall(-1), reference = mode.elevations(stepping, tau, steps);
      std::vector<double> time, computed, expected;
      Worst error;
      for (std::size_t n = 0; n < up.size(); ++n) {
        const double odd = 0.5 * (up[n] - down[n]);
        error.add(odd - reference[n]);
        time.push_back(static_cast<double>(n + 1) * tau);
        computed.push_back(odd / pressure);
        expected.push_back(reference[n] / pressure);
      }
      if (stepping == Stepping::one_step) {
        panel.line("oscillator", time, expected, Role::exact);
        panel.points("mesh", time, computed, Role::computed);
      }
      const double highest = worst(reference);
      check.holds(scheme + ": the elevation agrees with the oscillator.", {error.value() / highest},
                  Bound{steps * tau * omega * highest * highest +
                            4 * std::numeric_limits<double>::epsilon() * std::sqrt(10.0 * steps) / highest,
                        "third-order terms: the square of the elevation, in depths, times the phase that has passed; "
                        "and positions of order one that are rounded in ten operations of each step"});
    }
  }
}

}  // namespace seiche::verification::lagrangian_mesh_surface_pressure_test
