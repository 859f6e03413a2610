// Overlapping particles: how much they overlap, who is near whom, and gradients that are those of the masses.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/overlapping_particles/model.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/noise.hpp"

namespace seiche::verification::overlapping_particles_test {

using namespace overlapping_particles;
using std::numbers::pi;

constexpr double spacing = 0.1;

/// Particles of unequal masses in a square of the side 1, those of rows moved at random by up to a fifth of the
/// spacing.
Particles jittered_square() {
  Particles particles =
      staggered({.spacing = spacing, .lower = {0.05, 0.04}, .upper = {1, 1}, .through = {0.05, 0.04}});
  Noise noise(3);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    particles.x[k] += 0.2 * spacing * noise();
    particles.y[k] += 0.2 * spacing * noise();
    particles.mass[k] *= 1 + 0.3 * noise();
  }
  return particles;
}

/// Two walls that meet at the origin, turned by some angle with all particles.
struct Turned {
  Particles particles = jittered_square();
  std::vector<Wall> walls;

  explicit Turned(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const double x = particles.x[k], y = particles.y[k];
      particles.x[k] = c * x - s * y;
      particles.y[k] = s * x + c * y;
    }
    walls = {{{0, 0}, {c, s}}, {{0, 0}, {-2 * s, 2 * c}}};
  }
};

std::vector<double> noisy(std::size_t size, std::uint64_t seed) {
  Noise noise(seed);
  std::vector<double> values(size);
  std::ranges::generate(values, std::ref(noise));
  return values;
}

std::vector<double> times(const linear::RingMatrix& matrix, const std::vector<double>& x) {
  const Eigen::VectorXd product =
      matrix.lower().selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Map(x.data(), matrix.lower().cols());
  return {product.begin(), product.end()};
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

struct Variant {
  std::string id, what;
  Particles particles;
  Settings settings;
};

std::vector<Variant> variants() {
  const Turned upright(0), oblique(0.4);
  return {{"free", "without walls", jittered_square(), {}},
          {"ball", "balls", jittered_square(), {.shape = Shape::ball, .support = 1.6}},
          {"corner", "in a corner", upright.particles, {.walls = upright.walls}},
          {"oblique-corner",
           "in an oblique corner, stabilised",
           oblique.particles,
           {.stabilisation = 0.1, .walls = oblique.walls}}};
}

TEST_CASE("the smoothed overlap has the integral 1, the overlap of balls the area of their lens", "[geometry]") {
  Check check("overlapping_kernel", "Overlaps of particles and control volumes",
              "Wendland's function of support 0.7, integrated over the plane; the lens of two discs of radius 0.35, "
              "counted on a fine lattice. The slopes beside central differences.",
              "Frank, Discrete models of incompressible fluid (1994), section 5.1");
  constexpr double support = 0.7;
  const Kernel smoothed(Shape::smoothed, support);
  const Kernel ball(Shape::ball, support);
  constexpr int n = 2000;
  double integral = 0;
  for (int i = 0; i < n; ++i) {
    const double d = (i + 0.5) * support / n;
    integral += 2 * pi * d * smoothed.value(d) * support / n;
  }
  check.that("integral", "The integral of the smoothed kernel is 1.", "error", {integral - 1},
             Bound{0.6 / n / n, "midpoint rule: (S/n)^2/24 times the change of (2 pi d Phi)', 14/S^2, is 14/24/n^2"});
  Worst lens;
  constexpr int lattice = 1400;
  const auto place = [](int i) { return (i + 0.5) / lattice * support - support / 2; };
  for (const double d : {0.1, 0.35, 0.6}) {
    long inside = 0;
    for (int i = 0; i < lattice; ++i) {
      for (int j = 0; j < lattice; ++j) {
        const double x = place(i), y = place(j);
        if (std::hypot(x, y) < support / 2 && std::hypot(x - d, y) < support / 2) ++inside;
      }
    }
    const double share = static_cast<double>(inside) * support * support / lattice / lattice;
    lens.add(share / (pi * support * support / 4) - ball.value(d));
  }
  check.that("lens", "Balls: the lens over the area of one.", "largest error", {lens.value()},
             Bound{4.0 / lattice, "cells that the rim cuts: its length times a cell, over the area"});
  for (const auto& [kernel, id] : {std::pair{smoothed, std::string("smoothed")}, {ball, std::string("ball")}}) {
    Worst slope;
    for (const double d : {0.05, 0.2, 0.45, 0.65}) {
      const double difference = (kernel.value(d + 1e-6) - kernel.value(d - 1e-6)) / 2e-6;
      slope.add(kernel.slope_over_distance(d) * d - difference, d);
    }
    check.holds("The slope is the derivative (" + id + ").", {slope.value()},
                Bound{1e-8, "central differences of step 1e-6: rounding of values of some units over the step"});
    check.holds(id + "-end: The kernel is zero beyond its support.", {kernel.value(support)},
                Bound{0, "zero by definition"});
  }
}

TEST_CASE("the cell grid finds the same neighbours as the test of all pairs", "[geometry]") {
  Check check(
      "overlapping_neighbours", "Neighbours on the cell grid",
      "Particles in an oblique corner, moved at random twenty times by up to a tenth of the spacing. For each and for "
      "its images, the control volumes within reach by the grid and by trying all pairs; once more with a particle so "
      "far away that the grid's cells are wider. Lists are reused while they hold all pairs.");
  const Turned setting(0.4);
  const double reach = 2.6 * spacing;
  const Walls walls(setting.walls, reach);
  constexpr int rounds = 20;
  for (const double away : {0.0, 100.0}) {
    Particles p = setting.particles;
    p.x[7] += 0.4 * away;
    p.y[7] += 0.9 * away;
    Neighbourhoods near(reach);
    Noise noise(11);
    double missing = 0, beyond = 0, made = 0;
    for (int round = 0; round < rounds; ++round) {
      const bool anew = near.update(p.x, p.y, walls);
      made += anew ? 1 : 0;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const auto list = near.members().subspan(static_cast<std::size_t>(near.begin()[k]),
                                                 static_cast<std::size_t>(near.begin()[k + 1] - near.begin()[k]));
        for (std::size_t s = 0; s < p.size(); ++s) {
          Smallest distances;
          distances.add(std::hypot(p.x[k] - p.x[s], p.y[k] - p.y[s]));
          for (const Image& image : walls.images()) {
            const Point r = image.of({p.x[k], p.y[k]});
            distances.add(std::hypot(r.x - p.x[s], r.y - p.y[s]));
          }
          const bool listed = std::ranges::find(list, static_cast<int>(s)) != list.end();
          if (distances.value() < reach && !listed) ++missing;
          if (anew && distances.value() > 1.2 * reach && listed) ++beyond;
        }
      }
      for (std::size_t k = 0; k < p.size(); ++k) {
        p.x[k] += 0.1 * spacing * noise();
        p.y[k] += 0.1 * spacing * noise();
      }
    }
    const std::string id = away > 0 ? "wide-" : "";
    all_hold(check, Bound{0, "counted by trying all pairs"},
             {{id + "missing: The neighbour lists miss no pair of particles.", missing},
              {id + "beyond: New lists hold no particle beyond the reach.", beyond}});
    check.holds(id + "kept: Neighbour lists are rebuilt in some steps, not in every step.",
                {made >= 2 && 2 * made <= rounds ? 1.0 : 0.0},
                Qualitative{"lists made in twenty rounds",
                            "random steps of a tenth of the spacing, of which some use up a tenth of the reach"});
  }
}

TEST_CASE("gradients of the masses in control volumes agree with central differences", "[geometry]") {
  Check check("overlapping_gradients", "Gradients of overlapping particles",
              "Particles of unequal masses at random positions: smoothed and as balls, free and in corners with their "
              "mirror images. Rates of the masses for random velocities beside central differences of the masses "
              "themselves; the reactions to multipliers are the transpose, and the assembled matrix their product.");
  for (const Variant& v : variants()) {
    Model model(v.particles, v.settings);
    const mechanics::State state = model.state();
    const std::size_t n = model.size();
    model.linearise({}, state.q);
    const std::vector<double> u = noisy(2 * n, 21);
    std::vector<double> rates(n);
    model.constraint_rates(u, rates);
    constexpr double step = 1e-6;
    const auto masses_after = [&](double way) {
      std::vector<double> there = state.q, masses(n);
      for (std::size_t i = 0; i < u.size(); ++i) there[i] += way * u[i];
      model.constraint_values(there, masses);
      return masses;
    };
    const std::vector<double> ahead = masses_after(step), behind = masses_after(-step);
    Worst off;
    for (std::size_t s = 0; s < n; ++s) off.add((ahead[s] - behind[s]) / (2 * step) - rates[s]);
    const double size = worst(rates);
    check.holds("Rates of the masses equal differences (" + v.what + ").", {off.value() / size},
                Bound{1e-8,
                      "central differences of step 1e-6: their rounding 1e-10, their truncation (step/h)^2 = 1e-10, "
                      "and ten times as much where balls part"});
    const std::vector<double> mu = noisy(n, 22);
    std::vector<double> reaction(2 * n, 0.0);
    model.react(mu, reaction);
    double work = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) work += model.particles().mass[i % n] * reaction[i] * u[i];
    const double power = dot(mu, rates);
    check.holds("Reactions are the transposed of the rates (" + v.what + ").",
                {(work - power) / (size * static_cast<double>(n))},
                Roundoff{40.0 * static_cast<double>(n), 1, "sums of twenty terms a particle"});
    const std::vector<double> product = times(model.matrix(), mu);
    std::vector<double> expected(n);
    model.constraint_rates(reaction, expected);
    if (v.settings.stabilisation > 0) {
      const double form = dot(mu, product);
      check.holds(v.id + "-loss: The stabilisation is in the matrix.",
                  {(form - dot(mu, expected) - model.stabilisation_loss(mu) / 2) / form},
                  Roundoff{60.0 * static_cast<double>(n), 1, "sixty entries a row"});
    } else {
      check.holds("The matrix is G W G^T (" + v.what + ").", {largest_difference(product, expected) / worst(expected)},
                  Roundoff{60, 4, "sixty entries a row, of either sign"});
    }
  }
}

TEST_CASE("masses in control volumes do not change by translation and rotation", "[geometry]") {
  Check check("overlapping_rigid", "Rigid motions of overlapping particles",
              "Rates of the masses in rigid motions: along x, along y, about the origin; beside a wall, along it. "
              "Therefore momenta are conserved.");
  const auto rigid = [&](const std::string& motion, Model& model, const VelocityAt& velocity) {
    const mechanics::State state = model.state(velocity);
    model.linearise({}, state.q);
    std::vector<double> rates(model.size());
    model.constraint_rates(state.u, rates);
    std::vector<double> random(model.size());
    model.constraint_rates(noisy(2 * model.size(), 5), random);
    check.holds(motion + " leaves the masses of all volumes unchanged.", {worst(rates) / worst(random)},
                Roundoff{20, 10,
                         "twenty terms of either sign for speeds up to 1, each of differences of positions that are "
                         "ten times as large"});
  };
  for (const Shape shape : {Shape::smoothed, Shape::ball}) {
    Model model(jittered_square(), {.shape = shape, .support = shape == Shape::ball ? 1.6 : 2.6});
    rigid("Translation along x", model, [](Point) { return Point{1, 0}; });
    rigid("Translation along y", model, [](Point) { return Point{0, 1}; });
    rigid("Rotation about the origin", model, [](Point r) { return Point{-r.y, r.x}; });
  }
  const Turned oblique(0.4);
  Model beside(oblique.particles, {.walls = {oblique.walls[0]}});
  rigid("Translation along a wall", beside, [&](Point) { return Point{-std::sin(0.4), std::cos(0.4)}; });
}

}  // namespace seiche::verification::overlapping_particles_test
