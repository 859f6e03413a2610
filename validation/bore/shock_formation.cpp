/*
A piston accelerates gently, $u = u_p \sin^2(\pi t/4)$ for 2 s and $u_p = 1.5$ m/s from then on, into still water 1 m
deep. The compression wave steepens until the characteristics cross, and a bore forms inside smooth flow, at a position
and time that are not given to the scheme.

**What is compared.** The bore position at $t = 10$ s with the finest run; the bore width; the depth at the piston,
which starts at the depth of a simple wave and must tend to the depth behind a bore.

**What to look at.** Variant `H2` detects the bore and confines it to one particle as soon as it exceeds the surrounding
gradient.
*/
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/shallow_water/relations.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation::cases::shock_formation {

namespace particles = shallow_water_particles;

constexpr double length = 60;
constexpr double depth = 1;
constexpr double time = 10;

/// What the parameters decide.
struct SetUp {
  double gravity;
  double speed;         ///< of the piston, at last
  double bore;          ///< depth behind a bore that takes up this velocity
  double simple;        ///< depth at the piston in a simple wave
  std::vector<long> n;  ///< numbers of particles

  [[nodiscard]] std::string finest() const { return fmt::format("N = {}", n.back()); }
};

/// Depth of a bore in which still water takes up the velocity at once, by bisection.
double bore_depth(double gravity, double speed) {
  double low = depth;
  double high = 100 * depth;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (shallow_water::velocity_change(gravity, middle, depth) < speed ? low : high) = middle;
  }
  return low;
}

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  const double speed = values.real("piston_velocity");
  const long n = values.integer("particles");
  return {.gravity = gravity,
          .speed = speed,
          .bore = bore_depth(gravity, speed),
          .simple = std::pow(shallow_water::celerity(gravity, depth) + 0.5 * speed, 2) / gravity,
          .n = {n, 2 * n, 4 * n, 8 * n}};
}

struct Results {
  SetUp set_up;
  std::vector<double> sizes, positions;
  Profile finest;

  /// @throws std::invalid_argument where a position is not a number
  [[nodiscard]] evidence::GridConvergence convergence() const {
    return evidence::grid_convergence(sizes, positions, 1);
  }
};

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto here = claims.at(s.finest());
  const double known = values.table("regression_shock_formation").column("front_position")[0];
  here.only_if(s.gravity == 9.81 && s.speed == 1.5, "the position is known for 9.81 m/s^2 and 1.5 m/s")
      .check(
          "front", "The position of the bore agrees with a run on 6400 cells within the expanded uncertainty of both.",
          "position of the bore [m]",
          [](const Results& r) -> Measurement {
            return {.value = r.positions.back(), .uncertainty = r.convergence().uncertainty};
          },
          Uncertainty{.expected = known,
                      .data = 0.005,
                      .useful = 0.06,
                      .reason = "half a cell width of the fine run (60 m/6400) and the grid convergence here; the "
                                "uncertainty must stay below 0.1 % of the distance travelled"});
  here.from("the hand-over of the method")
      .check(
          "width", "The width of the bore formed by the piston is a single particle.",
          "particles between 5 % and 95 % of the depth difference",
          [](const Results& r) {
            return front_width(r.finest,
                               {.behind = r.set_up.bore, .ahead = depth, .position = r.positions.back(), .reach = 5});
          },
          Bound{.limit = 1, .reason = "one particle holds the bore; none at the instant of hand-over"});
  here.from("shock relations and Riemann invariants")
      .check(
          "plateau",
          "The depth at the piston is no farther from the depth behind a bore than the depth of a simple wave is.",
          "depth at the piston [m]", [](const Results& r) { return r.finest.means.front().depth; },
          Bound{.limit = s.simple - s.bore,
                .reason = "the depth starts at the value of a simple wave; reflections from the forming bore bring "
                          "it to the depth behind a bore, and never exceed the initial difference",
                .expected = s.bore});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  const Front near{.behind = s.bore, .ahead = depth, .position = 0.5 * length, .reach = 0.5 * length};
  const auto piston = [speed = s.speed](double t) {
    return t < 2 ? speed * std::pow(std::sin(std::numbers::pi * t / 4), 2) : speed;
  };
  for (const long count : s.n) {
    particles::ParticleFlow flow(
        particles::uniform_stretches({{0, length, {depth, 0}}}, static_cast<std::size_t>(count)),
        {.left = particles::Piston{piston}, .right = particles::Wall{}}, {.gravity = s.gravity}, {.theta = 1.5});
    march(flow, time);
    r.finest = flow.measured_profile();
    r.sizes.push_back(length / static_cast<double>(count));
    r.positions.push_back(front_position(r.finest, near));
    run.progress(static_cast<double>(count) / static_cast<double>(15 * s.n.front()));
  }
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& panel = add_panel(exhibit, "profile", "Formation of a bore inside a compression wave",
                          fmt::format("Depth at t = {:g} s.", time), {.x = "x [m]", .y = "depth h [m]"});
  const std::vector<double> depths = means_of(r.finest).depth;
  panel.steps(fmt::format("{} particles", r.set_up.n.back()), r.finest.edges, depths, Role::computed);
  const evidence::GridConvergence study = r.convergence();
  exhibit.measure("front_position_extrapolated", study.extrapolated);
  exhibit.measure("front_uncertainty", study.uncertainty);
  exhibit.measure("piston_depth_simple_wave", r.set_up.simple);
  exhibit.measure("largest_depth", largest(depths));
}

void shock_formation(Case& c) {
  c.title = "Formation of a bore ahead of a piston";
  c.source = "J. J. Stoker, Water Waves, 1957, 10.6";
  c.parameters = {
      integer("particles", {50, 200, 800}, {20, 1e5}, "coarsest number of particles; 2, 4 and 8 times as many run too"),
      real("piston_velocity", 1.5, "m/s", {0.1, 10}, "final velocity of the piston"),
      real("gravity", 9.81, "m/s^2", {0.1, 1e3}, "acceleration of gravity"),
  };
  c.study = Study(claims, compute, show,
                  "regression: reference implementation of the same scheme with 6400 particles, table "
                  "reference_data/regression_shock_formation");
}

}  // namespace seiche::validation::cases::shock_formation
