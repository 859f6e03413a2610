#include <cmath>
#include <random>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/check.hpp"

namespace seiche::verification::riemann_test {

using exact::Riemann;

constexpr double g = 9.81;
const std::string source = "Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 5-6";

double flux(shallow_water::State s) {
  return s.depth * s.velocity * s.velocity + shallow_water::thrust(g, s.depth);
}

TEST_CASE("Riemann solutions obey the integral laws for random states, dry beds included", "[exact]") {
  Check check(
      "exact_riemann_integrals", "Riemann problem: integral laws for random states",
      "2000 random pairs of states (depth ratios to 1e4, velocity differences that dry the middle, dry sides). Over an "
      "interval that holds all waves the integrals of $h$ and $h u$ change by the difference of the end fluxes. Across "
      "each jump the two Rankine-Hugoniot conditions hold, and depth rises in the direction that loses energy.",
      source);
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> exponent(-2, 2);
  std::uniform_real_distribution<double> speed(-15, 15);
  std::uniform_int_distribution<int> kind(0, 9);
  Largest mass, momentum, rankine_hugoniot;
  int dry_middles = 0;
  for (int k = 0; k < 2000; ++k) {
    shallow_water::State left{std::pow(10, exponent(random)), speed(random)};
    shallow_water::State right{std::pow(10, exponent(random)), speed(random)};
    const int choice = kind(random);
    if (choice == 0) left = {0, 0};
    if (choice == 1) right = {0, 0};
    const Riemann problem(g, left, right, 3);
    if (choice > 1 && problem.star().depth == 0) ++dry_middles;
    const double t = 0.7;
    const double a = 3 + t * problem.left_wave().slowest - 1;
    const double b = 3 + t * problem.right_wave().fastest + 1;
    const auto mean = validation::cell_average(problem, a, b, t);
    const double expected_mass =
        left.depth * (3 - a) + right.depth * (b - 3) + t * (left.depth * left.velocity - right.depth * right.velocity);
    const double expected_momentum =
        left.depth * left.velocity * (3 - a) + right.depth * right.velocity * (b - 3) + t * (flux(left) - flux(right));
    const double deepest = std::max({left.depth, right.depth, problem.star().depth});
    const double fastest = 1 + std::max(std::abs(problem.left_wave().slowest), std::abs(problem.right_wave().fastest));
    const double scale = deepest * (b - a);
    mass.add(std::abs((b - a) * mean.depth - expected_mass) / (scale * fastest));
    momentum.add(std::abs((b - a) * mean.discharge - expected_momentum) / (scale * fastest * fastest));
    const auto across = [&](Riemann::Wave wave, shallow_water::State outside) {
      if (wave.kind != Riemann::Kind::jump) return;
      CHECK(problem.star().depth >= outside.depth);
      const auto star = problem.star();
      const double a1 = wave.slowest;
      const double mass_jump = star.depth * (star.velocity - a1) - outside.depth * (outside.velocity - a1);
      const double momentum_jump =
          flux(star) - flux(outside) - a1 * (star.depth * star.velocity - outside.depth * outside.velocity);
      rankine_hugoniot.add(std::abs(mass_jump) / (deepest * fastest));
      rankine_hugoniot.add(std::abs(momentum_jump) / (deepest * fastest * fastest));
    };
    across(problem.left_wave(), left);
    across(problem.right_wave(), right);
  }
  CHECK(dry_middles > 10);
  const Roundoff limit{
      .operations = 300,
      .scale = 1,
      .reason =
          "four pieces of ten points with six roundings each, relative to depth x speed; the largest of 2000 draws"};
  check.that("mass", "Mass changes by the fluxes at the ends.", "relative mass error", {mass.value()}, limit);
  check.that("momentum", "Momentum changes by the thrusts and fluxes at the ends.", "relative momentum error",
             {momentum.value()}, limit);
  check.that("rankine-hugoniot", "Every jump satisfies both jump conditions.", "relative error of the jump conditions",
             {rankine_hugoniot.value()}, limit);
}

TEST_CASE("Riemann solutions are symmetric and Galilean invariant", "[exact]") {
  const Riemann problem(g, {2, 0.4}, {0.7, -0.3}, 1);
  const Riemann mirror(g, {0.7, 0.3}, {2, -0.4}, -1);
  const Riemann moving(g, {2, 5.4}, {0.7, 4.7}, 1);
  for (const double x : {-6.0, -3.0, 0.2, 1.0, 2.5, 4.0, 9.0}) {
    // 20 roundings on numbers up to 10.
    const double tolerance = 4e-14;
    CHECK(std::abs(problem.depth(x, 1.3) - mirror.depth(-x, 1.3)) < tolerance);
    CHECK(std::abs(problem.velocity(x, 1.3) + mirror.velocity(-x, 1.3)) < tolerance);
    CHECK(std::abs(problem.depth(x, 1.3) - moving.depth(x + 5 * 1.3, 1.3)) < tolerance);
    CHECK(std::abs(problem.velocity(x, 1.3) + 5 - moving.velocity(x + 5 * 1.3, 1.3)) < tolerance);
  }
}

TEST_CASE("colliding bores meet and pass", "[exact]") {
  Check check("exact_colliding_bores", "Two bores collide",
              "Bores 2 | 1 | 1.5 from x = 30 and 70: when and where they meet, the state between them afterwards, and "
              "mass through the collision.",
              source);
  const exact::CollidingBores bores(g, 2, 1, 1.5, 30, 70);
  Worst defect;
  for (const double t : {0.0, 2.0, 4.1, 4.2, 6.1}) {
    const auto mean = validation::cell_average(bores, 0, 100, t);
    const double inflow = bores.left().depth * bores.left().velocity - bores.right().depth * bores.right().velocity;
    defect.add(100 * mean.depth - (60 + 40 + 45) - t * inflow);
  }
  check.that("mass", "Mass grows by the inflow through the ends, before and after the collision.", "mass error [m^2]",
             {defect.value()}, Roundoff{100, 200, "sums of 50 points up to 200 m^2"});
}

}  // namespace seiche::verification::riemann_test
