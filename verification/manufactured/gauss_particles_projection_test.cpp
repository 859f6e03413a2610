// The projection of free particles' velocities: exact fields to the order of the splines, gradients to zero.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/geometry/curve.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/particles.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_projection_test {

using namespace gauss_particles;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6, formula (21)";

constexpr double length = 2 * std::numbers::pi;

double surface(double x) {
  return 1 + 0.1 * std::cos(x);
}

struct Velocities {
  std::vector<double> u, v;
};

/// 2 by 1, twelve particles to a cell along either axis.
Particles block(int cells, double density = 1) {
  return layer({.end = 2,
                .columns = static_cast<std::size_t>(12 * cells),
                .rows = static_cast<std::size_t>(6 * cells),
                .density = density,
                .surface = [](double) { return 1.0; },
                .bottom = [](double) { return 0.0; },
                .end_corrected = false});
}

Particles water(int cells, int per_side, bool end_corrected) {
  const double h = length / cells;
  return layer({.end = length,
                .columns = static_cast<std::size_t>(cells * per_side),
                .rows = static_cast<std::size_t>(std::lround(per_side / h)),
                .surface = surface,
                .bottom = [](double) { return 0.0; },
                .end_corrected = end_corrected});
}

/// Of the velocity of(x, y).
template <class Field>
Velocities velocities(const Particles& at, const Field& of) {
  Velocities w;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Point v = of(at.x[k], at.y[k]);
    w.u.push_back(v.x);
    w.v.push_back(v.y);
  }
  return w;
}

/// Of the stream function sin x sinh y + (1/2) cos 2x y exp(-y) + y^2/3, zero on the bottom y = 0.
Point solenoidal(double x, double y) {
  return {std::sin(x) * std::cosh(y) + 0.5 * std::cos(2 * x) * std::exp(-y) * (1 - y) + 2 * y / 3,
          -std::cos(x) * std::sinh(y) + std::sin(2 * x) * y * std::exp(-y)};
}

/// Gradient of (surface - y) cos(x - 0.3) exp(y/2), zero on the surface.
Point gradient(double x, double y) {
  const double below = surface(x) - y;
  const double part = std::exp(y / 2);
  return {part * (-0.1 * std::sin(x) * std::cos(x - 0.3) - below * std::sin(x - 0.3)),
          part * std::cos(x - 0.3) * (below / 2 - 1)};
}

Velocities projected(const Particles& at, Velocities w, int degree, int cells) {
  SplineSpace space(LatticePlan{.degree = degree, .cell_x = length / cells, .period = length, .bottom = true});
  space.place({}, at.x, at.y, at.mass, 0);
  space.project(w.u, w.v);
  return w;
}

double norm(const Particles& at, const Velocities& w) {
  double sum = 0;
  for (std::size_t k = 0; k < at.size(); ++k) sum += at.mass[k] * (w.u[k] * w.u[k] + w.v[k] * w.v[k]);
  return std::sqrt(sum);
}

double difference(const Particles& at, const Velocities& a, const Velocities& b) {
  Velocities d = a;
  for (std::size_t k = 0; k < at.size(); ++k) {
    d.u[k] -= b.u[k];
    d.v[k] -= b.v[k];
  }
  return norm(at, d) / norm(at, b);
}

TEST_CASE("the projection finds a smooth field to the order of its splines", "[manufactured]") {
  Check check("gauss_particles_projection", "Gauss-principle particles: the projection of a smooth field",
              "Water between a flat bottom and the surface 1 + 0.1 cos x. Velocities of a known stream function are "
              "projected on splines of degree p: the error, in the norm of the masses, is O(h^p) for particles in rows "
              "and for particles and masses displaced at random by up to half their spacing and half their size.",
              source);
  for (const bool random : {false, true}) {
    for (int degree = 2; degree <= 4; ++degree) {
      const std::string id = fmt::format("{}-degree-{}", random ? "random" : "rows", degree);
      const std::string name = fmt::format("p = {}, {}", degree, random ? "random particles" : "particles in rows");
      refine(check, {"h", widths(length, {20, 40, 80, 160}), id, "Error of the projection, " + name},
             {{id,
               "The projection errs by O(h^p): " + name + ".",
               {static_cast<double>(degree), 0.25,
                "the next term is up to k h of the first, k = 2 being the largest wave number of the field: 0.6 at the "
                "coarsest grid, 0.08 at the finest, a quarter on average"}}},
             [&](double h) {
               const auto cells = static_cast<int>(cells_of(length, h));
               Particles at = water(cells, 4, false);
               if (random) {
                 std::mt19937 generator(1);
                 const auto part = [&] { return static_cast<double>(generator()) / 4294967296.0 - 0.5; };
                 for (std::size_t k = 0; k < at.size(); ++k) {
                   at.x[k] += part() * length / (4 * cells);
                   at.mass[k] *= 1 + part();
                 }
               }
               const Velocities exact = velocities(at, solenoidal);
               return difference(at, projected(at, exact, degree, cells), exact);
             });
    }
  }
}

TEST_CASE("a pressure gradient is projected to zero as the particles' sums become integrals", "[manufactured]") {
  Check check("gauss_particles_gradients", "Gauss-principle particles: projection of a gradient",
              "The gradient of a pressure that vanishes on the surface is orthogonal to every solenoidal field, but "
              "for the error of sums over particles. What the projection leaves of it falls with the square of the "
              "particles' spacing for equal masses in a row, with its fourth power for end-corrected ones. This is the "
              "seed of the instability under gravity.",
              source);
  refine(check, {"spacing in cells", widths(1, {8, 16, 32, 64})},
         {{"midpoint", "Projections with equal masses have order 2.",
           Order{2, 0.1,
                 "the midpoint rule, by its ends; the error from lines of the grid is s^1.5 of it: 0.04 at the largest "
                 "spacing s = 1/8 and 0.002 at the smallest, or 0.02 of an order"}},
          {"end-corrected",
           "Projections with end-corrected masses have order 4.",
           {4, 0.5,
            "the midpoint rule with its first end correction is fourth-order accurate; where rows of particles cross a "
            "line of the grid, at which second derivatives of the velocities jump, a sum errs by s^3 with a sign that "
            "changes along the row: s^3.5 in a mean, not less"}}},
         [](double spacing) {
           const auto left = [&](bool end_corrected) {
             const Particles at = water(40, static_cast<int>(cells_of(1, spacing)), end_corrected);
             const Velocities full = velocities(at, gradient);
             return norm(at, projected(at, full, 3, 40)) / norm(at, full);
           };
           return std::array{left(false), left(true)};
         });
}

TEST_CASE("the penalty of a cubic stream function is its integral", "[manufactured]") {
  Check check(
      "gauss_particles_penalty", "Gauss-principle particles: the penalty on gradients of vorticity",
      "Cubic splines hold the stream functions of these flows on a block of 2 by 1, whose cells are full: the penalty "
      "is the integral of the squared gradient of their vorticity, times h^(7/2), and zero for an irrotational flow.");
  using Flow = Point (*)(double x, double y);
  const Flow shear = [](double, double y) { return Point{y * y / 2, 0}; };
  const Flow crossed = [](double x, double y) { return Point{x * x / 2, -x * y}; };
  const Flow irrotational = [](double x, double y) { return Point{-6 * x * y, 3 * (y * y - x * x)}; };
  constexpr double factor = 1e-13;  // small enough to change nothing
  for (const auto& [text, flow, vorticity_gradient] : {std::tuple{"Stream function y^3/6", shear, 1},
                                                       {"Stream function x^2 y/2", crossed, 1},
                                                       {"Stream function x^3 - 3 x y^2", irrotational, 0}}) {
    for (const int cells : {4, 8}) {
      const double h = 1.0 / cells;
      const Particles at = block(cells);
      SplineSpace space(LatticePlan{.cell_x = h});
      space.place({}, at.x, at.y, at.mass, factor);
      Velocities w = velocities(at, flow);
      space.project(w.u, w.v);
      check.holds(fmt::format("{}, h = 1/{}.", text, cells), {space.facts().penalty / (factor * std::pow(h, 3.5) * 2)},
                  Bound{1e-7,
                        "the penalty itself, 1e-13 of the velocities, and roundings of 1e-15 of stream functions up to "
                        "8, whose third derivatives magnify them by h^-3 = 512 and a few differences",
                        vorticity_gradient});
    }
  }
}

TEST_CASE("the penalty reduces the energy by its integral in a step", "[manufactured]") {
  Check check("gauss_particles_penalty_step", "Gauss-principle particles: energy removed by the penalty in a step",
              "A block of 2 by 1 with the velocity (y^2/2, 0), whose vorticity has the gradient 1, falls freely for "
              "one short step: the penalty reduces its energy by tau C h^(7/2) g^(1/2) rho times the area.");
  constexpr double density = 3, gravity = 4, coefficient = 0.5, tau = 1e-6;
  for (const int cells : {4, 8}) {
    const double h = 1.0 / cells;
    Model model(block(cells, density),
                std::make_unique<SplineSpace>(LatticePlan{.cell_x = h}, SplineSpace::Settings{.density = density}),
                {.gravity = gravity, .density = density, .penalty = coefficient});
    mechanics::State state = model.state([](Point at) { return Point{at.y * at.y / 2, 0}; });
    const auto energy = [&] {
      CompensatedSum sum;
      for (std::size_t i = 0; i < state.u.size(); ++i)
        sum.add(0.5 * model.masses()[i % model.size()] * state.u[i] * state.u[i]);
      sum.add(model.potential_energy(state.q));
      return sum.value();
    };
    const double before = energy();
    mechanics::OneStep<Model>(model).step(state, tau);
    const double by_hand = tau * coefficient * std::pow(h, 3.5) * std::sqrt(gravity) * density * 2;
    const Bound bound{1e-4,
                      "the field that is left differs from the given one by tau C h^(-1/2), some 1e-6, and energies of "
                      "0.15 are rounded to 1e-17 each, of which 1e-9 is the difference",
                      1};
    const std::string cell = ", h = 1/" + std::to_string(cells) + ".";
    check.holds("The energy falls by it" + cell, {(before - energy()) / by_hand}, bound);
    check.holds("The energy is recorded as lost" + cell, {model.penalty_loss() / by_hand}, bound);
  }
}

}  // namespace seiche::verification::gauss_particles_projection_test
