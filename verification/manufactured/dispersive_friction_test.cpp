// Friction at the bottom in the dispersive shallow-water model: decay, normal flow, a manufactured motion, the energy
// taken.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/dispersive_manufactured.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_friction_test {

using namespace dispersive_shallow_water_1d;
using validation::DispersiveManufactured;

constexpr double gravity = 9.81;
constexpr double depth = 0.8;
const std::vector<double> steps{0.1, 0.05, 0.025, 0.0125};

struct Law {
  std::string id, text;
  Friction friction;
  double per_length;  ///< C/H over `depth`, by the law's textbook form
};

const std::vector<Law> laws{
    {"manning", "Manning", {FrictionLaw::manning, 0.15}, gravity * 0.15 * 0.15 / std::pow(depth, 4.0 / 3)},
    {"quadratic", "A quadratic law", {FrictionLaw::quadratic, 0.25}, 0.25 / depth}};

/// Uniform flow in a periodic channel, the component of gravity along its slope as a force per unit mass.
Flow uniform_flow(const Friction& friction, double velocity, double push) {
  const Channel channel{
      .bottom = std::make_shared<LevelBottom>(depth), .period = 4, .gravity = gravity, .friction = friction};
  Markers markers = still_markers(channel, equal_labels(channel, 0, 4, 8));
  markers.u.assign(markers.size(), velocity);
  Forcing forcing;
  forcing.body_force = [push](double, std::span<double> along, std::span<double>) {
    for (double& f : along) f += push;
  };
  return {channel, markers, {}, forcing};
}

/// Velocity at `time`.
double velocity_at(Flow flow, double time, double tau) {
  for (long n = 0; n < std::lround(time / tau); ++n) flow.advance(tau);
  return flow.p().front();
}

/// The manufactured motion in the presence of friction, which its forces make up for.
double manufactured_error(Kinetics kinetics, const Friction& friction, std::size_t n) {
  const DispersiveManufactured exact({.green_naghdi = kinetics == Kinetics::green_naghdi});
  const DispersiveManufactured::Parameters& all = exact.parameters();
  const Channel channel{
      .bottom = std::make_shared<CosineBottom>(all.depth, all.bottom_amplitude, 2 * std::numbers::pi / all.length),
      .period = all.length,
      .kinetics = kinetics,
      .friction = friction};
  const std::vector<double> labels = equal_labels(channel, 0, all.length, n);
  Markers start;
  for (const double label : labels) {
    start.x.push_back(exact.at(label, 0).x);
    start.y.push_back(exact.at(label, 0).y);
  }
  start.u.assign(n, 0.0);
  start.v.assign(n, 0.0);
  Forcing forcing;
  forcing.body_force = [&](double time, std::span<double> along, std::span<double> across) {
    for (std::size_t i = 0; i < n; ++i) {
      const DispersiveManufactured::Sample s = exact.at(labels[i], time);
      const double water = s.y - exact.bottom(s.x).height;
      along[i] += s.source_p + friction.coefficient / water * std::abs(s.p) * s.p;
      across[i] += s.source_r;
    }
  };
  Flow flow(channel, start, {}, forcing);
  const double end = 5;
  const auto count = static_cast<long>(2 * n);
  for (long step = 0; step < count; ++step) flow.advance(end / static_cast<double>(count));
  Mean error;
  for (std::size_t i = 0; i < n; ++i) error.add(flow.p()[i] - exact.at(labels[i], end).p);
  return error.rms();
}

TEST_CASE("friction at the bottom slows a uniform current as its law says", "[manufactured]") {
  Check check("dispersive_friction", "Friction at the bottom of a channel",
              "Dispersive shallow water in one dimension, depth 0.8 m. A current of 1 m/s decays, $u = u_0/(1 + k u_0 "
              "t)$ with $k = C/H$; from rest down a slope of 1:20 the flow becomes normal, $u = U \\tanh(g S t/U)$, $U "
              "= \\sqrt{g S/k}$. Friction is implicit, alone exact for a uniform current, and acts half before and "
              "half after every step, which together is of second order.",
              "Chow (1959), chapters 5 and 6");
  const double slope = 0.05;
  for (const Law& law : laws) {
    std::vector<double> start;
    const double k = law.per_length;
    const double normal = std::sqrt(gravity * slope / k);
    for (const double tau : steps) {
      start.push_back(std::abs(velocity_at(uniform_flow(law.friction, 0, gravity * slope), 2, tau) -
                               normal * std::tanh(2 * gravity * slope / normal)));
    }
    check.holds(
        law.text + " slows a current down at the rate of the law.",
        {velocity_at(uniform_flow(law.friction, 1, 0), 4, 0.1)},
        Roundoff{40 * 20, 1, "two sweeps of the midpoint rule give u/(1 + k u tau) exactly; twenty operations a step",
                 1 / (1 + 4 * k)});
    check.that(law.id + "-normal", law.text + " and the slope: the flow starts towards the normal one.",
               "order of the velocity's error after 2 s", observed_order(steps, start),
               Order{2, 0.1, "a symmetric splitting of friction and step"});
  }
  std::vector<double> settled;
  for (const double tau : steps) {
    const double u = velocity_at(uniform_flow(laws[0].friction, 1, gravity * slope), 40, tau);
    settled.push_back(std::abs(u - std::sqrt(gravity * slope / laws[0].per_length)));
  }
  check.from("Chow (1959), chapter 6")
      .that("settled", "What the flow settles at is the normal flow of Manning's law.",
            "order of the velocity's error after 40 s", observed_order(steps, settled),
            Order{2, 0.1, "a symmetric splitting of friction and step"});
}

TEST_CASE("friction over an uneven bottom: a manufactured motion", "[manufactured]") {
  Check check("dispersive_friction_manufactured", "Friction over an uneven bottom",
              "The manufactured motion of `dispersive_manufactured` with a quadratic law, $C = 1$, and the force that "
              "makes up for it, until t = 5.",
              "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4");
  const std::vector<double> spacings{0.4, 0.2, 0.1, 0.05};
  for (const auto& [id, kinetics] : {std::pair<std::string, Kinetics>{"frank", Kinetics::frank},
                                     std::pair<std::string, Kinetics>{"green_naghdi", Kinetics::green_naghdi}}) {
    std::vector<double> errors;
    for (const double h : spacings) {
      errors.push_back(
          manufactured_error(kinetics, {FrictionLaw::quadratic, 1}, static_cast<std::size_t>(std::lround(10 / h))));
    }
    check.that(id, "The velocity along the bottom converges with spacing and step.", "order of its error",
               observed_order(spacings, errors), Order{2, 0.1, "second order in space and time, steps of h/4"});
  }
}

TEST_CASE("what friction takes is booked to round-off", "[manufactured]") {
  Check check("dispersive_friction_ledger", "What friction takes",
              "A solitary wave of 0.3 m in a periodic channel of depth 1 m, Manning's n = 0.05, conservative scheme, "
              "200 steps of 0.05 s. Energy and momentum, less what friction took, stay.",
              "energy balance");
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0),
                        .period = 30,
                        .gravity = gravity,
                        .friction = {FrictionLaw::manning, 0.05}};
  Flow flow(channel, solitary_markers(channel, 0, 30, 0.25, {.amplitude = 0.3, .crest = 15}),
            {.stepping = Stepping::conservative});
  const double energy = flow.energy();
  const double momentum = flow.model().momentum(flow.state().q, flow.state().u)[0];
  for (int n = 0; n < 200; ++n) {
    flow.advance(0.05);
    flow.observe();
  }
  check.that("energy", "Energy and what friction took of it stay.", "largest defect over the energy",
             {flow.ledger().largest_defect("energy") / energy},
             Roundoff{200 * 120, 2, "a rounded term per marker and step; kinetic and potential energy are halves"});
  check.from("momentum balance")
      .that("momentum", "Momentum plus the booked impulse of friction is conserved to round-off.",
            "largest defect over the momentum", {flow.ledger().largest_defect("momentum") / momentum},
            Roundoff{200 * 120, 2, "a rounded term per marker and step"});
  check.from("Manning's law")
      .that("taken", "Friction takes what its law takes of the wave at the start, in the order of magnitude.",
            "share of the energy lost in 10 s over the rate of the start times 10 s",
            {flow.lost().friction / energy /
             (10 *
              [&] {
                Flow fresh(channel, solitary_markers(channel, 0, 30, 0.25, {.amplitude = 0.3, .crest = 15}));
                double power = 0;
                for (std::size_t i = 0; i < fresh.p().size(); ++i) {
                  const double water = 1 + fresh.y()[i];
                  power += fresh.model().masses()[i] * gravity * 0.05 * 0.05 * std::pow(std::abs(fresh.p()[i]), 3) /
                           std::pow(water, 4.0 / 3);
                }
                return power / fresh.energy();
              }())},
            Bound{0.2, "the wave decays by less than a fifth of its height meanwhile", 1});
}

}  // namespace seiche::verification::dispersive_friction_test
