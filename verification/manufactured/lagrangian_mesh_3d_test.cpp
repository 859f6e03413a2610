// Hexahedra against a manufactured motion of water over an uneven bottom: orders in space, and in time alone.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/manufactured/hexahedral_motion.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_3d_test {

using namespace lagrangian_mesh_3d;
using Motion = HexahedralMotion;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";
constexpr double duration = 0.6;

Mesh mesh_of(std::size_t n) {
  const auto bottom = Motion::bottom();
  return layer_mesh({.end = Motion::length,
                     .north = Motion::length,
                     .columns = n,
                     .rows = n,
                     .layers = n,
                     .elevation = [=](double x, double y) { return bottom->slope(x, y).elevation + Motion::depth; },
                     .bottom = bottom});
}

Flow flow_of(std::size_t n, Stepping stepping, long steps) {
  Flow flow(mesh_of(n), VelocityAt([](Place p) {
              return Motion::at({p.x, p.y, p.z}, 0).velocity;
            }),
            {.stepping = stepping}, {.gravity = Motion::gravity, .tolerance = 1e-11}, {}, false,
            {.body_force = [](Place label, double time) {
              return Motion::at({label.x, label.y, label.z}, time).force;
            }});
  for (long step = 0; step < steps; ++step) flow.advance(duration / static_cast<double>(steps));
  return flow;
}

double length(Vector v) {
  return std::sqrt(dot(v, v));
}

/// Is a node in the middle half of the mesh, each way?
bool in_the_middle(std::size_t index, std::size_t n) {
  return 4 * index >= n && 4 * index <= 3 * n;
}

/// Root mean squares at the end: of places and velocities in the middle half of the water, each way; of lambda in the
/// middles of cells there, one step before the end; distances of the surface's nodes from the exact surface, in its
/// middle half each way, and along it; displacements of nodes along the bottom, in its middle half.
using Errors = std::array<double, 6>;

Errors errors_of(const Flow& flow) {
  const Mesh& mesh = flow.model().mesh();
  const std::size_t n = mesh.layers;
  Mean interior, velocity, lambda, shape, slip, on_bottom;
  for (std::size_t k = 0; k < mesh.x.size(); ++k) {
    const std::size_t i = k % (n + 1), j = k / (n + 1) % (n + 1), l = k / ((n + 1) * (n + 1));
    if (!in_the_middle(i, n) || !in_the_middle(j, n)) continue;
    const Motion::Sample exact = Motion::at({mesh.x[k], mesh.y[k], mesh.z[k]}, duration);
    const Vector off = vector_at(flow.state().q, k) - exact.place;
    const double distance = length(off);
    if (in_the_middle(l, n)) {
      interior.add(distance);
      velocity.add(length(vector_at(flow.state().u, k) - exact.velocity));
    }
    if (l == 0) on_bottom.add(distance);
    if (l == n) {
      const double through = dot(off, exact.normal) / length(exact.normal);
      shape.add(through);
      slip.add(std::sqrt(std::abs(distance * distance - through * through)));
    }
  }
  const std::vector<double> pressure = flow.dynamic_pressure();
  const double tau = flow.time() / static_cast<double>(flow.steps());
  const auto inside = [n](std::size_t index) { return 4 * index >= n && 4 * (index + 1) <= 3 * n; };
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    if (!inside(cell % n) || !inside(cell / n % n) || !inside(cell / (n * n))) continue;
    Vector middle;
    for (const std::size_t k : mesh.corners(cell)) middle = middle + Vector{mesh.x[k], mesh.y[k], mesh.z[k]} / 8;
    lambda.add(pressure[cell] - Motion::at(middle, duration - tau).lambda);
  }
  return {interior.rms(), velocity.rms(), lambda.rms(), shape.rms(), slip.rms(), on_bottom.rms()};
}

const Order inside{2, 0.15,
                   "second order; coarse meshes' interiors still feel the layer at the surface and the bottom"};
const Order along{1, 0.15,
                  "a node feels the pressure gradient half a cell inside; the next term is second-order accurate"};
const std::vector<Refined> quantities = {
    {"interior", "The interior node positions over the uneven bed converge at second order.", inside},
    {"velocity", "The interior velocities over the uneven bed converge at second order.", inside},
    {"pressure", "The interior pressure over the uneven bed converges at second order.", inside},
    {"shape", "The surface shape over the uneven bed converges at second order.",
     Order{2, 0.2, "second order: the first-order error is along the surface"}},
    {"slip", "The slip of surface nodes over the uneven bed converges at first order.", along},
    {"bottom", "The slip of bed nodes along the uneven bed converges at first order.", along},
};

TEST_CASE("the manufactured motion over a bottom conserves volumes and follows from its force", "[manufactured]") {
  Check check(
      "hexahedral_motion", "The manufactured motion over an uneven bottom: identities",
      "Volumes, walls and the bottom are preserved by identities. Velocities are the rates of positions, and the force "
      "over the acceleration is the gradient of the pressure, $F^T (f - r_{tt}) = \\nabla \\lambda$ over the labels: "
      "both by sixth-order differences over steps of 1/50, independent of the formulas for derivatives.",
      source);
  const auto bottom = Motion::bottom();
  /// At labels X, Y, height and a time.
  using At = std::array<double, 4>;
  const auto sample = [&](const At& at) {
    return Motion::at({at[0], at[1], bottom->slope(at[0], at[1]).elevation + at[2]}, at[3]);
  };
  constexpr double h = 0.02;
  const auto derivative = [&](const At& at, std::size_t along, const auto& part) {
    const auto difference = [&](int k) {
      At ahead = at, behind = at;
      ahead[along] += k * h;
      behind[along] -= k * h;
      return part(sample(ahead)) - part(sample(behind));
    };
    return 45 / (60 * h) * difference(1) + -9 / (60 * h) * difference(2) + 1 / (60 * h) * difference(3);
  };
  const auto place = [](const Motion::Sample& s) { return s.place; };
  const auto velocity_of = [](const Motion::Sample& s) { return s.velocity; };
  const auto lambda = [](const Motion::Sample& s) { return s.lambda; };
  Worst volume, walls, velocity, balance;
  for (const double t : {0.0, 0.4, 1.0}) {
    for (const double a : {0.0, 0.3, 0.7, 1.1, 1.6, 2.0}) {
      for (const double c : {0.0, 0.5, 1.2, 2.0}) {
        for (const double height : {0.0, 0.4, 1.0}) {
          const At at{a, c, height, t};
          const Motion::Sample s = sample(at);
          volume.add(s.volume - 1);
          if (a == 0 || a == 2) walls.add(s.place.x - a);
          if (c == 0 || c == 2) walls.add(s.place.y - c);
          if (height == 0) walls.add(s.place.z - bottom->slope(s.place.x, s.place.y).elevation);
          const Vector off = derivative(at, 3, place) - s.velocity;
          for (const double component : {off.x, off.y, off.z}) velocity.add(component);
          const Vector excess = s.force - derivative(at, 3, velocity_of);
          for (std::size_t label = 0; label < 3; ++label) {
            balance.add(dot(excess, derivative(at, label, place)) - derivative(at, label, lambda));
          }
        }
      }
    }
  }
  check.that("volume", "The exact motion conserves volumes: det F = 1.", "largest det F - 1", {volume.value()},
             Roundoff{100, 4, "products of three of some tens of roundings each"});
  check.that("walls", "The distance of the exact motion from walls and bed is zero to round-off.",
             "largest distance from them", {walls.value()},
             Roundoff{20, 2, "some twenty roundings of positions up to 2"});
  const Bound bound{.limit = 2e-8,
                    .reason =
                        "h^6/140 of a seventh derivative, some 4^7 of functions of order 1: 8e-9, in two terms; a "
                        "missing term of the pressure or a wrong sign makes 1e-2"};
  check.that("velocity", "Velocities of the exact motion are the rates of its positions.",
             "largest difference from that by differences", {velocity.value()}, bound);
  check.that("force", "The force over the acceleration is the gradient of the pressure within 2e-8.",
             "largest difference by differences", {balance.value()}, bound);
}

TEST_CASE("hexahedra over an uneven bottom are second-order accurate against a manufactured motion",
          "[manufactured][full]") {
  Check check(
      "lagrangian_mesh_3d_manufactured", "Hexahedra: manufactured motion over an uneven bottom",
      "Water 1 deep over a bottom bent along both axes, between walls 2 apart each way, follows a prescribed motion "
      "under the body force that sustains it: columns are sheared along x and along y, the bottom's nodes slide on it "
      "by up to 0.1. $n^3$ cells, steps of about half the height of a cell, until $t = 0.6$; root mean squares. A node "
      "of the surface, of the bottom or of a wall feels the pressure gradient half a cell inside and slips along it to "
      "first order, in a layer of one cell, which the pressure there feels. Everything else is second-order accurate.",
      source);
  check.source(source);
  refine(check, {"height of a cell", widths(1, {16, 20, 24, 32, 40})}, quantities, [](double height) {
    const std::size_t n = cells_of(1, height);
    return errors_of(flow_of(n, Stepping::one_step, 5 * static_cast<long>(n) / 4));
  });
}

TEST_CASE("hexahedra over an uneven bottom are second-order accurate in time alone", "[manufactured]") {
  Check check("lagrangian_mesh_3d_manufactured_time", "Hexahedra: manufactured motion, order in time",
              "The same motion on $6^3$ cells with 8 to 64 steps, against 512 steps on the same cells: errors of time "
              "alone, with the bottom's nodes among them.",
              source);
  constexpr std::size_t n = 6;
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const Flow finest = flow_of(n, stepping, 512);
    const std::string id = stepping == Stepping::one_step ? "one-step" : "conservative";
    const Order second{2, 0.1, "a symmetric scheme; 512 steps err by 1/64 of 64"};
    refine(check, {.axis = "step", .sizes = widths(duration, {8, 16, 32, 64}), .id = id},
           {{id + "-places", id + ": node positions are second-order in time.", second},
            {id + "-velocities", id + ": velocities are second-order in time.", second}},
           [&](double tau) {
             const Flow flow = flow_of(n, stepping, std::lround(duration / tau));
             Mean place, velocity;
             for (std::size_t k = 0; k < 3 * flow.x().size(); ++k) {
               place.add(flow.state().q[k] - finest.state().q[k]);
               velocity.add(flow.state().u[k] - finest.state().u[k]);
             }
             return std::array{place.rms(), velocity.rms()};
           });
  }
}

}  // namespace seiche::verification::lagrangian_mesh_3d_test
