// Which fields a space must hold for which invariant of free particles: the conditions are sharp.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::gauss_particles_spaces_test {

using namespace gauss_particles;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6, proposition 4";

constexpr long steps = 1000;
constexpr double tau = 1e-3;

/// The linear fields without one of them: 0, 1 the translations, 2 the rotation.
std::vector<StreamFunction> without(std::size_t field) {
  auto fields = linear_fields();
  fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(field));
  return fields;
}

struct Problem {
  Problem(std::vector<StreamFunction> fields, const std::function<Point(Point)>& velocity)
      : model(disc(1, 4), std::make_unique<PolynomialSpace>(std::move(fields)), {.gravity = 0, .penalty = 0}),
        state(model.state(velocity)) {}

  InvariantsLedger run() {
    OneStep<Model> step(model);
    InvariantsWatch watch(model, state);
    for (long k = 0; k < steps; ++k) {
      step.step(state, tau);
      watch.record(state);
    }
    return watch.ledger();
  }

  Model model;
  State state;
};

void take_steps(Model& model, State& state, long count, double length) {
  OneStep<Model> step(model);
  for (long k = 0; k < count; ++k) step.step(state, length);
}

Point turning(Point r) {
  return {-r.y, r.x};
}

Point mixed(Point r) {
  return {0.3 + 0.5 * r.x - 0.9 * r.y + 0.2 * r.x * r.y, -0.2 + 0.7 * r.x - 0.5 * r.y + 0.1 * r.x * r.x};
}

TEST_CASE("a momentum of Gauss-principle particles is conserved if and only if the space contains its field",
          "[conservation]") {
  Check check(
      "gauss_particles_spaces", "Gauss-principle particles: conservation and the space of fields",
      "Small spaces of polynomial fields on a disc of 48 particles. With all linear fields everything is conserved. "
      "Without the rotation the velocity of a turning disc is orthogonal to the space: the velocity is reversed and "
      "the angular momentum changes sign at every step; likewise the momentum without a translation. Energy is "
      "conserved in any space, here with the single field of the stream function x^3 y^2.");
  const auto kept = [&](const std::string& text, double defect) {
    check.holds(text, {defect},
                Roundoff{steps, 3 * std::acos(-1.0),
                         "one rounded velocity per step; scale: sums of magnitudes, at most 3 times the mass"});
  };
  const InvariantsLedger all = Problem(linear_fields(), mixed).run();
  kept("Energy is conserved to round-off with all linear fields.", all.largest_defect("energy"));
  kept("Momentum is conserved to round-off with all linear fields.", all.largest_defect("momentum"));
  kept("Angular momentum is conserved to round-off with all linear fields.", all.largest_defect("angular"));
  const InvariantsLedger no_rotation = Problem(without(2), mixed).run();
  kept("Energy is conserved to round-off without the rotation.", no_rotation.largest_defect("energy"));
  kept("Momentum is conserved to round-off without the rotation.", no_rotation.largest_defect("momentum"));
  const auto reflected = [&](const std::string& text, std::size_t field, const std::function<Point(Point)>& velocity,
                             const std::string& entry) {
    Problem problem(without(field), velocity);
    // The disc is about the origin where the projection is taken.
    for (std::size_t i = 0; i < problem.state.q.size(); ++i) problem.state.q[i] -= tau / 2 * problem.state.u[i];
    InvariantsWatch watch(problem.model, problem.state);
    const double first = watch.ledger().entry(entry).initial;
    take_steps(problem.model, problem.state, 1, tau);
    watch.record(problem.state);
    check.holds(text, {watch.ledger().entry(entry).value / first}, Roundoff{48, 1, "a sum over 48 particles", -1});
  };
  reflected("The angular momentum changes sign in a space without the rotation.", 2, turning, "angular_momentum_z");
  const auto along_x = [](Point) { return Point{1, 0}; };
  reflected("The momentum along x changes sign in a space without the translation along x.", 0, along_x, "momentum_x");
  kept("Energy is conserved to round-off with the single field of stream function x^3 y^2.",
       Problem({{{1, 3, 2}}}, mixed).run().largest_defect("energy"));
}

TEST_CASE("the projection scheme loses energy at the rate of its accelerations", "[conservation]") {
  Check check("gauss_particles_dissipation", "Gauss-principle particles: the loss of Frank's projection scheme",
              "A disc is stretched into an ellipse without gravity. The scheme (21) to (23) loses energy at the rate "
              "$(\\tau/2)\\sum m\\,|a|^2$, for this drop $(\\tau/2)\\,4\\pi/(a^2+b^2)^3$: the loss up to t = 2 over "
              "that prediction tends to 1 with the step, at least as a sum over steps tends to its integral.");
  const exact::StretchingDrop drop(1, 1, 1);
  constexpr int intervals = 400;
  double integral = 0;
  for (int k = 0; k <= intervals; ++k) {
    const double t = 2.0 * k / intervals;
    const double axes = std::pow(drop.semi_axis(t), 2) + std::pow(drop.other_axis(t), 2);
    const double weight = k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2;
    integral += weight * 2.0 / intervals / 3 * 4 * std::acos(-1.0) / std::pow(axes, 3);
  }
  const double first_rate = 4 * std::acos(-1.0) / std::pow(2.0, 3);
  for (const double length : {0.04, 0.02, 0.01, 0.005}) {
    Model model(disc(1, 10), std::make_unique<PolynomialSpace>(), {.gravity = 0, .penalty = 0});
    State state = model.state([](Point r) { return Point{r.x, -r.y}; });
    const double first = model.kinetic_energy(state.q, state.u);
    ProjectedStep<Model> step(model);
    for (long k = 0; k < std::lround(2 / length); ++k) step.step(state, length);
    const double loss = first - model.kinetic_energy(state.q, state.u);
    check.holds("The loss is the predicted one: 1/tau = " + std::to_string(std::lround(1 / length)) + ".",
                {loss / (length / 2 * integral)},
                Bound{length / 2 * first_rate / integral,
                      "a sum that takes |a|^2, which falls all the time, at an end of each step errs by half a step "
                      "times its first value",
                      1});
  }
}

TEST_CASE("spray of Gauss-principle particles moves ballistically", "[conservation]") {
  Check check(
      "gauss_particles_spray", "Gauss-principle particles: spray",
      "A drop falls from rest beside three particles and a marker, thinner than a cell and beyond the extrapolation of "
      "the fields: these move on their parabolas, to round-off, and the drop is unaffected by them.",
      source);
  Particles particles = disc(1, 12);
  const std::size_t drop = particles.size();
  for (const double place : {4.0, 4.05, 4.1}) particles.add(place, 4, 0.001);
  particles.add(4.075, 4, 0);
  Model model(particles, std::make_unique<SplineSpace>(LatticePlan{.cell_x = 0.3}), {.gravity = 1, .penalty = 0});
  State state = model.state([](Point r) { return r.x > 3 ? Point{0.5, 1} : Point{0, 0}; });
  constexpr int count = 64;
  take_steps(model, state, count, 1.0 / count);
  Worst spray, fallen;
  for (std::size_t k = 0; k < model.size(); ++k) {
    const bool flies = k >= drop;
    Worst& worst = flies ? spray : fallen;
    worst.add(state.q[k] - particles.x[k] - (flies ? 0.5 : 0));
    worst.add(state.q[model.size() + k] - particles.y[k] - (flies ? 1 : 0) + 0.5);
  }
  check.at("432 particles and 3, 64 steps");
  check.that("spray", "Spray particles move on their exact parabolas.",
             "largest distance along an axis from the exact position", {spray.value()},
             Roundoff{count, 5, "one rounding of positions up to 5 per step"});
  check.that("drop", "The drop falls as a whole.", "largest distance along an axis from the exact position",
             {fallen.value()},
             Roundoff{count * count, 1,
                      "velocities up to 1 that are rounded in each step displace the drop in all later ones"});
}

TEST_CASE("thin water at a wall of Gauss-principle particles slides along it", "[conservation]") {
  Particles particles = disc(1, 12);
  for (double& y : particles.y) y += 2;
  const std::size_t drop = particles.size();
  for (int k = 0; k < 25; ++k) {
    for (const double side : {-1, 1}) particles.add(side * (3.775 + 0.05 * (k % 5)), 2.025 + 0.05 * (k / 5), 0.001);
  }
  Model model(
      particles,
      std::make_unique<SplineSpace>(LatticePlan{.cell_x = 0.25, .left_wall = -4, .right_wall = 4, .bottom = true}),
      {.gravity = 1, .penalty = 0});
  State state = model.state([](Point r) { return std::abs(r.x) > 3 ? Point{r.x / 4, 1} : Point{0, 0}; });
  take_steps(model, state, 1, 0.1);
  for (std::size_t k = drop; k < particles.size(); k += 2) {
    CHECK(state.q[k + 1] < 4);  // in free flight the outer ones would have left
    CHECK(state.q[k + 1] == Approx(-state.q[k]));
  }
}

TEST_CASE("markers among Gauss-principle particles are never reflected", "[conservation]") {
  Check check("gauss_particles_markers", "Gauss-principle particles: markers ride on the field",
              "A disc of 48 particles moves uniformly; a marker in it is given another velocity. After one step it has "
              "the velocity of the water, whereas the velocity of a particle would be reflected.",
              source);
  Particles particles = disc(1, 4);
  particles.add(0.3, -0.2, 0);
  const std::size_t count = particles.size(), marker = count - 1;
  const Point water{0.3, -0.2}, own{0.5, 0.4};
  Model model(std::move(particles), std::make_unique<PolynomialSpace>(linear_fields()), {.gravity = 0, .penalty = 0});
  State state = model.state([&](Point) { return water; });
  state.u[marker] = own.x;
  state.u[count + marker] = own.y;
  take_steps(model, state, 1, tau);
  check.that("velocity", "The velocity of the marker equals the water velocity to round-off.",
             "distance of the velocities", {std::hypot(state.u[marker] - water.x, state.u[count + marker] - water.y)},
             Roundoff{100, 1, "a projection of 48 particles onto five fields"});
}

}  // namespace seiche::verification::gauss_particles_spaces_test
