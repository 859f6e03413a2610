#include <cmath>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::finite_volume_faces_test {

using shallow_water::State;
using shallow_water_finite_volume::End;
using shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

constexpr double g = 9.81;
constexpr std::size_t cells = 40;

/// 40 m of cells 1 m wide, one state left of the middle and another right of it.
FiniteVolumeFlow two_states(FiniteVolumeFlow::Settings settings, State left, State right) {
  std::vector<double> depth, discharge;
  for (std::size_t i = 0; i < cells; ++i) {
    const State state = i < cells / 2 ? left : right;
    depth.push_back(state.depth);
    discharge.push_back(state.depth * state.velocity);
  }
  return {settings, 0, static_cast<double>(cells), depth, discharge};
}

FiniteVolumeFlow stationary_jump(State upstream, State downstream) {
  return two_states(
      {.scheme = Scheme::roe, .courant = 0.8, .left = End::inflow(upstream), .right = End::inflow(downstream)},
      upstream, downstream);
}

TEST_CASE("fluxes through a face equal the schemes' closed forms", "[manufactured]") {
  Check check(
      "finite_volume_faces", "Finite volumes: fluxes in closed form",
      "Steps so short that the states beside a face do not change. A stream of depth $h$ and velocity $u$ that meets a "
      "wall is a collision with its mirror image: Einfeldt's speeds are $\\pm(c + u/2)$, and the thrust on the wall is "
      "$g h^2/2 + h u^2 + h u (c + u/2)$. Water that ends at a dry bed: speeds $-c$ and $2c$, through the face pass "
      "$\\frac23 c h$ of mass and $\\frac13 g h^2$ of momentum. Roe's linearisation leaves a stationary jump where it "
      "is, and dissolves the same states in the wrong order, which gain energy.",
      "Einfeldt, SIAM J. Numer. Anal. 25 (1988) 294; Harten and Hyman, J. Comput. Phys. 50 (1983) 235");
  constexpr double tau = 1e-9;
  const auto expected = [](double value) {
    return Bound{
        .limit = 1e-7,
        .reason =
            "the states beside the face change by the courant number, 1e-8; ten times that for numbers up to 10 c h",
        .expected = value,
        .relative = true};
  };
  constexpr double h = 0.8;
  constexpr double u = 1.1;
  const double c = std::sqrt(g * h);
  auto stream = two_states({.scheme = Scheme::muscl_hll, .left = End::inflow({h, u})}, {h, u}, {h, u});
  stream.advance(tau);
  check.that("collision", "The thrust on a wall that stops a stream equals the HLL flux with Einfeldt's speeds.",
             "thrust on the wall over density [m^3/s^2]", {-stream.ledger().impulse_right / tau},
             expected(0.5 * g * h * h + h * u * u + h * u * (c + u / 2)));
  auto dam = two_states({.scheme = Scheme::muscl_hll, .right = End::inflow({0, 0})}, {h, 0}, {h, 0});
  dam.advance(tau);
  check.that("dry-mass", "The discharge onto a dry bed in the first instant is 2/3 c h.",
             "discharge onto the dry bed [m^2/s]", {-dam.ledger().mass_right / tau}, expected(2 * c * h / 3));
  check.that("dry-momentum", "The momentum flux through the face is g h^2/3.",
             "momentum flux onto the dry bed [m^3/s^2]", {-dam.ledger().impulse_right / tau}, expected(g * h * h / 3));

  const double flux = shallow_water::jump_mass_flux(g, 0.5, 1.2);
  const State shallow{0.5, flux / 0.5};
  const State deep{1.2, flux / 1.2};
  auto jump = stationary_jump(shallow, deep);
  constexpr double end = 10;
  const long steps = march(jump, end);
  Worst moved;
  for (std::size_t i = 0; i < cells; ++i) moved.add(jump.depth()[i] - (i < cells / 2 ? shallow : deep).depth);
  check.that("roe-jump", "Roe's scheme preserves a stationary hydraulic jump.",
             "largest change of the depth in ten seconds [m]",
             {.value = moved.value(), .resolution = std::to_string(steps) + " steps"},
             Roundoff{4e6, 1.2,
                      "at most 100 steps of some 40 roundings of numbers up to 1.2 m, which repeat from step to step: "
                      "1e3 steps squared"});
  auto expansion = stationary_jump(deep, shallow);
  march(expansion, 1);
  Largest kept;
  for (std::size_t i = 0; i + 1 < cells; ++i) kept.add(std::abs(expansion.depth()[i + 1] - expansion.depth()[i]));
  check.that("roe-expansion",
             "A discontinuity that would gain energy spreads into a fan with steps of at most 0.35 m after one second.",
             "largest difference of neighbouring depths after one second [m]",
             {.value = kept.value(), .resolution = "40 cells of 1 m"},
             Bound{0.35,
                   "u - c grows from -1.6 to 2.3 m/s: a fan over four cells; half of the whole difference of 0.7 m in "
                   "one cell is no fan"});
}

TEST_CASE("friction and bed forces equal their entries in the ledger", "[manufactured]") {
  Check check("finite_volume_sources", "Finite volumes: friction and bed",
              "Uniform flow between free ends under Manning's friction obeys $u' = -k u |u|$, $k = g n^2/h^{4/3}$: the "
              "implicit step $u/(1 + \\tau k |u|)$ is exact, $u = u_0/(1 + k u_0 t)$. Water that sloshes over a slope "
              "between walls: its momentum changes by the impulses of walls and bed alone.",
              "Manning's law, integrated");
  constexpr double h = 0.3;
  constexpr double n = 0.03;
  auto river = two_states({.scheme = Scheme::muscl_hll, .manning = n, .left = End::free(), .right = End::free()},
                          {h, 2}, {h, 2});
  constexpr long steps = 400;
  for (long k = 0; k < steps; ++k) river.advance(0.1);
  const double rate = g * n * n / std::pow(h, 4.0 / 3);
  check.that("friction", "The deceleration of uniform flow agrees with Manning's law.", "velocity after 40 s [m/s]",
             {river.velocity()[cells / 2]},
             Roundoff{10.0 * steps, 2, "ten roundings per step of a velocity that starts with 2 m/s",
                      2 / (1 + 2 * rate * 0.1 * steps)});
  const Bed slope{[](double x) { return 0.1 * x; }, [](double x) { return 0.05 * x * x; }};
  std::vector<double> depth;
  for (std::size_t i = 0; i < cells; ++i) depth.push_back(0.7 - 0.15 * 0.1 * (static_cast<double>(i) + 0.5));
  FiniteVolumeFlow water({.scheme = Scheme::muscl_hll}, 0, 4, depth, std::vector<double>(cells, 0.0), slope);
  constexpr long swings = 4000;
  for (long k = 0; k < swings; ++k) water.advance(0.002);
  check.from("finite-volume form: the flux out of a cell enters its neighbour or the bed")
      .that("bed-impulse", "The momentum change equals the impulses of walls and bed to round-off.",
            "momentum error after eight seconds [m^3/s]",
            {.value = water.momentum_defect(), .resolution = "40 cells, 4000 steps"},
            Roundoff{3.0 * cells * swings, 0.005,
                     "three roundings per cell and step of thrusts up to g (0.7 m)^2/2 = 2.4 m^3/s^2 times tau"});
}

}  // namespace seiche::verification::finite_volume_faces_test
