// Sides of the 2DH model that waves pass: a window that follows a wave, a driven side that lets one in, a slanted wall
// that sends one back.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/plan_soliton.hpp"
#include "verification/check.hpp"
#include "verification/noise.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_2dh_sides_test {

using namespace dispersive_shallow_water_2d;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 4.3";

/// The wave of a run in a window from 30 behind its crest to 30 ahead, which follows it.
Flow window_flow(const validation::PlanSolitonRun& run) {
  const exact::SerreSolitary wave(run.amplitude);
  Rectangle window{.begin = -30, .end = 30, .columns = cells_of(60, run.spacing), .rows = run.rows};
  window.north = run.spacing * static_cast<double>(run.rows);
  window.sides.west = plan_lattice::HeldSide{};
  Lattice lattice = rectangular_lattice(window);
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    lattice.x[k] = wave.place_of(lattice.x[k]);
    lattice.z[k] = wave.elevation(lattice.x[k]);
  }
  const auto velocity = [&](double x, double) {
    const double u = wave.depth_averaged_velocity(x);
    return Velocity{u, 0, (u - wave.speed()) * wave.elevation_slope(x)};
  };
  return Flow(std::move(lattice), velocity, run.scheme, {.tolerance = run.tolerance}, {},
              {.reach = [c = wave.speed()](double time) { return 28 + c * time; }});
}

/// Largest distance of the surface from the exact wave within 6 depths of its crest when the crest that a driven west
/// side lets in is at x = 15.
double inflow_error(double spacing) {
  const exact::SerreSolitary wave(0.2);
  const double start = -18;
  const plan_lattice::DrivenSide west{[=](Place place, double time) {
    return Point{wave.depth_averaged_velocity(place.x - start - wave.speed() * time), 0};
  }};
  Flow flow(rectangular_lattice(
      {.end = 30, .north = spacing, .columns = cells_of(30, spacing), .rows = 1, .sides = {.west = west}}));
  march(flow, (15 - start) / wave.speed(), 0.1 * spacing);
  Worst error;
  for (std::size_t k = 0; k < flow.x().size(); ++k) {
    const double distance = flow.x()[k] - 15;
    if (std::abs(distance) < 6) error.add(flow.z()[k] - wave.elevation(distance));
  }
  return error.value();
}

TEST_CASE("the wave in a moving window of the 2DH model agrees with a long tank", "[conservation]") {
  Check check("dispersive_2dh_window", "A moving window around a solitary wave",
              "A solitary wave of H/h = 0.3 in a window 60 long that follows it for 60 units of time, and in a tank "
              "that holds its whole way: columns are dropped behind and appended ahead, where the wave is lower than "
              "1e-9. Disturbances from the cut are left behind, because the solitary wave is the fastest.",
              source);
  const validation::PlanSolitonRun run{.spacing = 0.5, .tau = 0.2, .time = 60, .rows = 2, .tolerance = 1e-12};
  Flow tank = validation::plan_soliton_flow(run);
  Flow window = window_flow(run);
  std::vector<double> times, differences;
  while (tank.time() < run.time - 0.5 * run.tau) {
    tank.advance(run.tau);
    window.advance(run.tau);
    // Nodes of the two keep their numbers but for the shifts.
    const auto shift = static_cast<std::size_t>(window.shifts());
    Worst difference;
    for (std::size_t i = 0; i <= window.shape().columns; ++i) {
      const double x = window.x()[i];
      const double crest = std::sqrt(1 + run.amplitude) * window.time();
      if (std::abs(x - crest) > 15) continue;
      difference.add(window.z()[i] - tank.z()[i + shift]);
      difference.add(x - tank.x()[i + shift]);
    }
    times.push_back(window.time());
    differences.push_back(difference.value());
  }
  check
      .figure("difference", "A moving window against a long tank",
              "Largest difference of positions and elevations within 15 h of the crest.")
      .panel({.x = "t sqrt(g/H)", .y = "difference / H", .log_y = true})
      .line("window", times, differences);
  check.that("same", "The wave in the moving window agrees with the long tank within 1e-7 h.",
             "largest difference of a position or elevation within 15 h of the crest",
             {.value = largest(differences), .resolution = "h = 0.5, tau = 0.2"},
             Bound{1e-7, "the wave where columns are appended, 1e-9 each time, some 70 times; positions add them up"});
  check.from("interface of the model")
      .that("shifts", "The distance of the moving window from the crest is 28 h within 1.5 h.",
            "x of the east side minus x of the crest",
            {window.x()[window.shape().columns] - std::sqrt(1.3) * window.time()},
            Bound{1.5, "28 and up to one column of 0.5 more or less", 28});
}

TEST_CASE("a driven side of the 2DH model generates a solitary wave", "[conservation]") {
  Check check("dispersive_2dh_inflow", "A solitary wave through a driven side",
              "Still water; the west side moves with the velocity of a solitary wave of H/h = 0.2 whose crest starts "
              "18 h west of it. When the crest is 15 h inside, the surface within 6 h of it converges to the exact "
              "wave at second order; steps of a tenth of a cell.",
              source);
  refine(check, {"h", {0.75, 0.5, 0.375, 0.25, 0.1875}},
         {{"order",
           "The error of the surface within 6 h of the crest converges at second order.",
           {2, 0.3, "second order in h and tau; coarse cells have parts of fourth"}}},
         inflow_error);
}

TEST_CASE("velocities transferred to another bottom conserve energy, along walls too", "[conservation]") {
  constexpr double inertia = 0.4;
  const Lattice lattice = rectangular_lattice({.end = 4, .north = 3, .columns = 4, .rows = 3});
  const std::size_t n = lattice.shape.nodes();
  const NodeMasses masses(lattice.shape, lattice.sides, lattice.x, lattice.y, inertia);
  Noise noise(7);
  Normals from, to;
  std::vector<double> u(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    for (Normals* const normals : {&from, &to}) {
      const Vector3 up{0.8 * noise(), 0.8 * noise(), 1};
      normals->push_back(1 / std::sqrt(dot(up, up)) * up);
    }
    const bool west_or_east = std::fmod(lattice.x[k], 4) == 0, south_or_north = std::fmod(lattice.y[k], 3) == 0;
    u[k] = west_or_east ? 0 : noise();
    u[n + k] = south_or_north ? 0 : noise();
    u[2 * n + k] = west_or_east && south_or_north ? 0 : noise();
  }
  const auto energy = [&](const Normals& normals, std::size_t k) {
    const Vector3 w{u[k], u[n + k], u[2 * n + k]};
    return dot(w, w) - (1 - inertia) * std::pow(dot(w, normals[k]), 2);
  };
  std::vector<double> before;
  for (std::size_t k = 0; k < n; ++k) before.push_back(energy(from, k));
  masses.carry(from, to, u);
  for (std::size_t k = 0; k < n; ++k) {
    INFO(k);
    CHECK(std::abs(energy(to, k) - before[k]) <= 40 * 1.2e-16 * before[k] / inertia);  // some 40 roundings
  }
}

}  // namespace seiche::verification::dispersive_2dh_sides_test
