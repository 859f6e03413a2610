// Drag on the columns of the 2DH model: it takes the energy that it should, and leaves volumes alone; layers that
// absorb.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "seiche/lattice/water.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/plan_standing_mode.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::drag_2dh_test {

using namespace dispersive_shallow_water_2d;

constexpr double manning = 0.3;
constexpr double depth = 0.8;

Lattice basin(std::size_t rows, std::function<double(double x, double y)> elevation = {}) {
  return rectangular_lattice(
      {.end = 6, .north = 4, .columns = 12, .rows = rows, .elevation = std::move(elevation), .depth = depth});
}

double half_wave_along_x(double x) {
  return std::cos(std::numbers::pi * x / 6);
}
double half_wave_along_y(double y) {
  return std::cos(std::numbers::pi * y / 4);
}

/// Rate at which Manning's law takes energy, g = 1: sum of m n^2 |u|^3/H^(4/3).
double power(const Flow& flow) {
  const auto shape = flow.shape();
  const auto x = flow.x(), y = flow.y();
  std::vector<double> volume(shape.nodes(), 0.0), area(shape.nodes(), 0.0);
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto corners = shape.corners(cell);
    const auto [a, b, c, d] = corners;
    const double cell_area = 0.5 * ((x[c] - x[a]) * (y[d] - y[b]) - (x[d] - x[b]) * (y[c] - y[a]));
    for (const std::size_t k : corners) {
      volume[k] += flow.model().first_volumes()[cell];
      area[k] += cell_area;
    }
  }
  double sum = 0;
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    const double speed = std::hypot(flow.u()[k], flow.v()[k]);
    sum +=
        flow.model().node_masses()[k] * manning * manning * std::pow(speed, 3) / std::pow(volume[k] / area[k], 4.0 / 3);
  }
  return sum;
}

TEST_CASE("friction at the bottom dissipates energy according to Manning's law", "[manufactured]") {
  Check check(
      "drag_2dh", "Friction at the bottom in 2DH",
      "Water sloshes in a basin 6 by 4, depth 0.8, Manning's n = 0.3, until t = 4. What is lost of the energy is "
      "compared with the work of the law, summed over the run by the trapezoidal rule. Volumes of cells stay.",
      "Manning's law");
  double volumes = 0;
  refine(check, {"tau", {0.1, 0.05, 0.025, 0.0125}},
         {{"work",
           "The energy lost is the work of the law, to O(tau).",
           {1, 0.2,
            "friction is implicit in velocities that include gravity but not the columns' volumes, which act later: an "
            "error of O(tau)"}}},
         [&](double tau) {
           const auto sloshing = [](double x, double y) {
             return 0.1 * half_wave_along_x(x) + 0.05 * half_wave_along_y(y);
           };
           Flow flow(basin(8, sloshing), {}, {.stepping = Stepping::conservative},
                     {.gravity = 1, .drag = {.manning = manning}});
           const double before = flow.energy();
           double work = 0, rate = power(flow);
           for (long n = 0; n < std::lround(4 / tau); ++n) {
             flow.advance(tau);
             const double next = power(flow);
             work += 0.5 * tau * (rate + next);
             rate = next;
           }
           flow.observe();
           volumes = flow.ledger().largest_defect("volume_worst");
           return std::abs(before - flow.energy() - work) / before;
         });
  check.that("volumes", "The volume of every cell is conserved to round-off.", "largest defect", {volumes},
             Roundoff{320, 6, "a rounded position, up to 6, per step"});
}

TEST_CASE("an absorbing layer makes standing waves decay at half of its rate", "[manufactured]") {
  Check check(
      "absorption_2dh", "Absorption in 2DH",
      "A standing wave of $a/h = 10^{-6}$ in a basin 6 by 4 with uniform damping at the rate r = 0.3: $z'' + r z' + "
      "\\Omega^2 z = 0$, $\\Omega$ of the mesh in closed form. Elevation in a corner at t = 7 against the solution.",
      "z'' + r z' + Omega^2 z = 0");
  constexpr double rate = 0.3;
  constexpr double time = 7;
  constexpr double amplitude = 1e-6;
  const validation::PlanTank tank{.columns = 12, .rows = 8, .length = 6, .width = 4, .depth = depth};
  const double omega = tank.frequency(std::numbers::pi / 6, std::numbers::pi / 4);
  const double damped = std::sqrt(omega * omega - 0.25 * rate * rate);
  const double expected =
      std::exp(-0.5 * rate * time) * (std::cos(damped * time) + 0.5 * rate / damped * std::sin(damped * time));
  const auto errors = refine(
      check, {"tau", {0.2, 0.1, 0.05, 0.025}},
      {{"decay", "The difference of the wave from the damped oscillator falls at first order in the step.",
        Order{1, 0.2, "absorption acts before the forces of a step and not with them"}}},
      [&](double tau) {
        const auto standing = [](double x, double y) {
          return amplitude * half_wave_along_x(x) * half_wave_along_y(y);
        };
        Flow flow(basin(8, standing), {}, {}, {.tolerance = 1e-13, .drag = {.absorption = [](Point) { return rate; }}});
        march(flow, time, tau);
        return std::abs(flow.z()[0] / amplitude - expected);
      });
  check.that("size", "The error at the smallest step is at most r tau/2 of the amplitude, half a step of decay.",
             "difference over the first amplitude", {.value = errors[0].back(), .resolution = "tau = 0.025"},
             Bound{0.5 * rate * 0.025,
                   "half a step of decay between positions and velocities: r tau/2 of the amplitude; other errors are "
                   "of second order"});
}

InverseMasses inverse_of(std::span<const double> masses) {
  InverseMasses inverse(masses.size());
  for (std::size_t k = 0; k < masses.size(); ++k) inverse.xx[k] = inverse.yy[k] = 1 / masses[k];
  return inverse;
}

/// Of a node; nodes have 13 to a row.
using VelocityOf = std::function<Point(std::size_t node)>;

/// Velocities (u, v, w) of all nodes before and after a drag has slowed them.
struct Slowed {
  std::vector<double> before, after;

  Slowed(const Drag& drag, std::span<const double> masses, const VelocityOf& velocity, double time)
      : before(3 * masses.size(), 0.0) {
    for (std::size_t k = 0; k < masses.size(); ++k) {
      const Point given = velocity(k);
      before[k] = given.x;
      before[masses.size() + k] = given.y;
    }
    after = before;
    drag.slow(masses, inverse_of(masses), 1, time, after);
  }
  /// Largest change of a component.
  [[nodiscard]] double change() const { return largest_difference(mechanics::Input(after), before); }
};

double energy(std::span<const double> masses, const std::vector<double>& u) {
  double sum = 0;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    sum += masses[k] * (u[k] * u[k] + u[masses.size() + k] * u[masses.size() + k]) / 2;
  }
  return sum;
}

TEST_CASE("the mesh's own pattern decays at its rate and smooth motions do not", "[manufactured]") {
  Check check("pattern_2dh", "The pattern + - + - in 2DH",
              "Velocities of 12 x 10 equal cells before and after a short time in which the pattern + - + - is slowed "
              "down: that pattern, velocities of second degree in x and y, and random ones.",
              "seiche/models/dispersive_shallow_water_2d/drag.hpp");
  const Lattice lattice = basin(10);
  const std::size_t n = lattice.shape.nodes();
  const std::vector<double> equal(n, 1.0);
  std::vector<double> masses(n);
  for (std::size_t k = 0; k < n; ++k) masses[k] = 1 + 0.3 * std::sin(1.7 * static_cast<double>(k));
  constexpr double rate = 2;
  constexpr double h = 1e-6;
  const Drag drag({.lattice_rate = rate}, lattice, 1.0 / 3);
  const std::size_t inner = lattice.shape.node(6, 5);
  const auto decay = [&](const VelocityOf& velocity) {
    const Slowed slowed(drag, equal, velocity, h);
    return 1 - slowed.after[inner] / slowed.before[inner];
  };
  const auto pattern = [](std::size_t k) {
    const double sign = (k % 13 + k / 13) % 2 == 0 ? 1 : -1;
    return Point{sign, -0.5 * sign};
  };
  check.that("rate", "The pattern decays at the given rate within 1e-4.", "rate of an inner node over the given one",
             {decay(pattern) / (rate * h)},
             Bound{1e-4, "pairs act in turn: each reduces the velocity left for the next, some 10 rate h", 1});
  const auto plane_wave = [](std::size_t k) {
    const double wave = std::cos(0.9 * static_cast<double>(k % 13) + 0.6 * static_cast<double>(k / 13));
    return Point{wave, wave};
  };
  const double s1 = std::pow(std::sin(0.45), 2), s2 = std::pow(std::sin(0.3), 2);
  check.that("waves", "Velocities of a plane wave decay at the rate of the law.", "rate of an inner node over that",
             {decay(plane_wave) / (rate * h * s1 * s2 * (s1 + s2) / 2)},
             Bound{1e-4, "one pair after the other, some 10 rate h, and rounding over 1e-8", 1});
  const auto smooth = [&](std::size_t k) {
    const double x = lattice.x[k], y = lattice.y[k];
    return Point{1 + x - 2 * y + x * x - 0.7 * x * y + 0.2 * y * y, 3 - y + 0.4 * x * x + 0.3 * x * y};
  };
  check.that("smooth", "Motions of second degree are not changed by damping the pattern.",
             "largest change of a velocity", {Slowed(drag, masses, smooth, 0.1).change()},
             Roundoff{200, 40, "twelve roundings in each of sixteen pairs of velocities up to 40"});
  const auto random = [](std::size_t k) {
    const auto at = static_cast<double>(k);
    return Point{std::sin(12.9 * at * at), std::cos(7.3 * at * at)};
  };
  const auto [wild, tamed] = Slowed(drag, masses, random, 0.1);
  double momentum = 0;
  for (std::size_t k = 0; k < n; ++k) momentum += masses[k] * (tamed[k] - wild[k] + tamed[n + k] - wild[n + k]);
  check.that("momentum", "Momentum is conserved by the drag to round-off.", "change of its two components together",
             {momentum}, Roundoff{16 * 2 * static_cast<double>(n), 1, "sixteen pairs at every node"});
  check.that("energy", "Energy of random motions falls when the pattern is damped.",
             "energy after over that before is less than 1", {energy(masses, tamed) < energy(masses, wild) ? 1.0 : 0.0},
             Qualitative{"after less than before", "every pair takes energy"});
}

TEST_CASE("steep converging water exchanges momentum and other water does not", "[manufactured]") {
  Check check("breaking_2dh", "Breaking in 2DH",
              "12 x 10 equal cells 0.5 by 0.4, level bottom 0.8 deep, g = 1; the surface steps up by 1.2 along the "
              "sixth column, fronts steeper than 2 begin to break. Velocities before and after a short time. Then the "
              "step falls to 0.6, a bore of Froude number 1.55, and to 0.2, of 1.19.");
  check.source("seiche/models/dispersive_shallow_water_2d/drag.hpp");
  Lattice lattice = basin(10);
  const std::size_t n = lattice.shape.nodes();
  const std::vector<double> volumes(lattice.shape.cells(), 0.5 * 0.4 * (depth + 0.6));
  const Model model(lattice);
  const std::span<const double> masses = model.node_masses();
  Drag drag({.breaking_slope = 2}, lattice, 1.0 / 3);
  const auto slowed = [&](Drag& by, std::size_t column, double step, const VelocityOf& velocity, double h) {
    for (std::size_t k = 0; k < n; ++k) lattice.z[k] = k % 13 > column ? step : 0.0;
    by.measure(lattice, volumes, lattice::joined({lattice.x, lattice.y, lattice.z}));
    Slowed result(by, masses, velocity, h);
    by.breaking().settle();
    return result;
  };
  const auto momentum = [&](const std::vector<double>& u, std::size_t axis) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += masses[k] * u[axis * n + k];
    return sum;
  };
  const auto meet_at = [](std::size_t column) {
    return [column](std::size_t k) { return Point{k % 13 > column ? -0.5 : 0.5, k % 13 > column ? 0.2 : 0.0}; };
  };
  const auto together = meet_at(5);
  const auto away = [&](std::size_t k) { return Point{-together(k).x, together(k).y}; };
  constexpr double h = 1e-6;
  const auto [before, after] = slowed(drag, 5, 1.2, together, h);
  const std::size_t inner = lattice.shape.node(5, 5);
  const double mean_depth = depth + 0.6;
  const double behind = depth + 1.2;
  const double subcritical = std::sqrt(1 - depth * (depth + behind) / (2 * behind * behind));
  const double viscosity = 2 * std::sqrt(1.0 / 3) * mean_depth * std::sqrt(mean_depth) * subcritical;
  const double force = viscosity * mean_depth * 0.4 / 0.5;  // of the difference of two velocities
  check.that("rate", "The momentum that two neighbours exchange agrees with the viscosity within 1e-4.",
             "force over nu H times the width and the gradient of the velocity",
             {(after[inner] - before[inner]) * masses[inner] / (h * -1.0 * force)},
             Bound{1e-4, "implicit: an error of twice h times the rate of some 10, and rounding over 1e-6", 1});
  const auto [wild, tamed] = slowed(drag, 5, 1.2, together, 10);
  check.that("momentum", "Momentum is conserved to round-off over any time.", "change of its two components together",
             {momentum(tamed, 0) - momentum(wild, 0) + momentum(tamed, 1) - momentum(wild, 1)},
             Roundoff{4 * static_cast<double>(n), 1, "one pair in each row"});
  // The step's last velocities are twice the mean less the first.
  std::vector<double> last = tamed;
  for (std::size_t k = 0; k < last.size(); ++k) last[k] = 2 * tamed[k] - wild[k];
  check.that("no-return", "Both velocities converge to one value over a long time.",
             "difference of the last velocities over the first difference",
             {(last[inner + 1] - last[inner]) / (wild[inner + 1] - wild[inner])},
             Bound{0.05, "1/(1 + 2 x), x some tens, is positive and small", 0.05});
  check.that("energy", "Energy decreases where two velocities become equal.",
             "energy after over that before is less than 1", {energy(masses, last) < energy(masses, wild) ? 1.0 : 0.0},
             Qualitative{"after less than before", "an implicit exchange"});
  const double goes_on = slowed(drag, 5, 0.6, together, 0.1).change();
  Drag other({.breaking_slope = 2}, lattice, 1.0 / 3);
  other.breaking().continue_from(drag.breaking());
  other.breaking().shift_east();
  const double shifted = slowed(other, 4, 0.6, meet_at(4), 0.1).change();
  check.that("goes-on",
             "A breaking front continues to break when it is no longer steep; likewise in a flow resumed from it, one "
             "column further west after its window has moved.",
             "both change velocities", {goes_on > 0.01 && shifted > 0.01 ? 1.0 : 0.0},
             Qualitative{"more than 0.01 of 0.5", "0.1 times a rate of some 10 changes a third of them"});
  Worst others;
  others.add(slowed(drag, 5, 0.2, together, 0.1).change());
  others.add(slowed(drag, 5, 1.2, away, 0.1).change());
  others.add(slowed(drag, 5, 0.6, together, 0.1).change());
  check.that("others",
             "Velocities of a former bore, of diverging water, and of a gentle step that did not break, are unchanged.",
             "largest change of a velocity", {others.value()}, Roundoff{1, 1, "no computation starts"});
}

}  // namespace seiche::verification::drag_2dh_test
