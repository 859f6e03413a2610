// Friction at the bottom in the dispersive shallow-water model: decay, normal flow, the energy taken.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_friction_test {

using namespace dispersive_shallow_water_1d;

constexpr double gravity = 9.81;
constexpr double depth = 0.8;

struct Law {
  std::string text;
  Friction friction;
  double per_length;  ///< C/H over `depth`, by the law's textbook form
};

const std::vector<Law> laws{{"Manning", {FrictionLaw::manning, 0.15}, gravity * 0.15 * 0.15 / std::pow(depth, 4.0 / 3)},
                            {"A quadratic law", {FrictionLaw::quadratic, 0.25}, 0.25 / depth}};

/// Uniform flow in a periodic channel, the component of gravity along its slope as a force per unit mass.
Flow uniform_flow(const Friction& friction, double velocity, double push) {
  const Channel channel{
      .bottom = std::make_shared<LevelBottom>(depth), .period = 4, .gravity = gravity, .friction = friction};
  Markers markers = still_markers(channel, equal_labels(channel, 0, 4, 8));
  markers.u.assign(markers.size(), velocity);
  return {channel, markers, {}, {.body_force = [push](double, std::span<double> along, std::span<double>) {
            for (double& f : along) f += push;
          }}};
}

/// Velocity at `time`.
double velocity_at(Flow flow, double time, double tau) {
  for (long n = 0; n < std::lround(time / tau); ++n) flow.advance(tau);
  return flow.p().front();
}

TEST_CASE("friction at the bottom slows a uniform current according to its law", "[manufactured]") {
  Check check("dispersive_friction", "Friction at the bottom of a channel",
              "Dispersive shallow water in one dimension, depth 0.8 m. A current of 1 m/s decays, $u = u_0/(1 + k u_0 "
              "t)$ with $k = C/H$; from rest down a slope of 1:20 the flow becomes normal, $u = U \\tanh(g S t/U)$, $U "
              "= \\sqrt{g S/k}$. Friction is implicit, alone exact for a uniform current, and acts half before and "
              "half after every step, which is second-order accurate.",
              "Chow (1959), chapters 5 and 6");
  const double slope = 0.05;
  const auto normal = [&](const Law& law) { return std::sqrt(gravity * slope / law.per_length); };
  for (const Law& law : laws) {
    check.holds(
        law.text + " slows a current down at the rate of the law.",
        {velocity_at(uniform_flow(law.friction, 1, 0), 4, 0.1)},
        Roundoff{40 * 20, 1, "two sweeps of the midpoint rule give u/(1 + k u tau) exactly; twenty operations a step",
                 1 / (1 + 4 * law.per_length)});
  }
  const Order second{2, 0.1, "a symmetric splitting of friction and step"};
  refine(check, {"step", {0.1, 0.05, 0.025, 0.0125}},
         {{"manning-normal", "Manning and the slope: after 2 s the flow starts to approach the normal one.", second},
          {"quadratic-normal", "A quadratic law and the slope: after 2 s the flow starts to approach the normal one.",
           second},
          {"settled", "The flow after 40 s agrees with the normal flow of Manning's law.", second}},
         [&](double tau) {
           const auto start = [&](const Law& law) {
             return std::abs(velocity_at(uniform_flow(law.friction, 0, gravity * slope), 2, tau) -
                             normal(law) * std::tanh(2 * gravity * slope / normal(law)));
           };
           const double settled = velocity_at(uniform_flow(laws[0].friction, 1, gravity * slope), 40, tau);
           return std::array{start(laws[0]), start(laws[1]), std::abs(settled - normal(laws[0]))};
         });
}

TEST_CASE("the energy and momentum removed by friction are recorded to round-off", "[manufactured]") {
  Check check("dispersive_friction_ledger", "What friction takes",
              "A solitary wave of 0.3 m in a periodic channel of depth 1 m, Manning's n = 0.05, conservative scheme, "
              "200 steps of 0.05 s. Energy and momentum plus the recorded losses by friction are constant.",
              "energy balance");
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0),
                        .period = 30,
                        .gravity = gravity,
                        .friction = {FrictionLaw::manning, 0.05}};
  Flow flow(channel, solitary_markers(channel, 0, 30, 0.25, {.amplitude = 0.3, .crest = 15}),
            {.stepping = Stepping::conservative});
  const double energy = flow.energy();
  const double momentum = flow.model().momentum(flow.state().q, flow.state().u)[0];
  double power = 0;
  for (std::size_t i = 0; i < flow.p().size(); ++i) {
    power += flow.model().masses()[i] * gravity * 0.05 * 0.05 * std::pow(std::abs(flow.p()[i]), 3) /
             std::pow(1 + flow.y()[i], 4.0 / 3);
  }
  for (int n = 0; n < 200; ++n) {
    flow.advance(0.05);
    flow.observe();
  }
  check.that("energy", "The sum of energy and frictional dissipation is conserved to round-off.",
             "largest error over the energy", {flow.ledger().largest_defect("energy") / energy},
             Roundoff{200 * 120, 2, "a rounded term per node and step; kinetic and potential energy are halves"});
  check.from("momentum balance")
      .that("momentum", "Momentum plus the booked impulse of friction is conserved to round-off.",
            "largest error over the momentum", {flow.ledger().largest_defect("momentum") / momentum},
            Roundoff{200 * 120, 2, "a rounded term per node and step"});
  check.from("Manning's law")
      .that("taken", "The energy loss by friction has the order of magnitude of its law for the initial wave.",
            "share of the energy lost in 10 s over the rate of the start times 10 s",
            {flow.lost().friction / energy / (10 * power / energy)},
            Bound{0.2, "the wave decays by less than 20 % of its height meanwhile", 1});
}

}  // namespace seiche::verification::dispersive_friction_test
