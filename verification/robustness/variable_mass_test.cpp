// What particles of variable mass refuse, and how they break down.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/message_of.hpp"
#include "verification/robustness/breakdown.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::variable_mass_test {

using namespace free_lagrangian;
using namespace variable_mass;

Mesh box() {
  return layer_mesh({.end = 1, .columns = 8, .rows = 8});
}

/// A run until it breaks down, with the masses among what must be as before.
Breakdown run_until_break(Flow& flow, double end, double tau) {
  std::vector<double> masses;
  Breakdown result = run_until_breakdown(flow, end, [&](Flow& f) {
    masses.assign(f.masses().begin(), f.masses().end());
    f.advance(tau);
  });
  result.kept = result.kept && std::equal(masses.begin(), masses.end(), flow.masses().begin());
  return result;
}

TEST_CASE("bad input of variable masses is rejected by name", "[robustness]") {
  Check check("variable_mass_bad_input", "Bad input of particles of variable mass",
              "Controls out of range or without a surface to follow, steps too long for them, invalid channels.");
  Refusals refusals(check);
  const auto control = [&](const std::vector<std::string>& words, const Control& c, const Mesh& mesh) {
    refusals.refused(words, [&] { Flow flow(mesh, {}, c); });
  };
  refusals.outside_ranges("Control", "rate non-negative and finite; surface_rate non-negative and finite", Control{},
                          [](const Control& c) { Flow(box(), {}, c); });
  control({"no surface between two walls", "centroid"}, {ControlKind::mapped, 1, 0}, free_patch(4, 4, {0, 0}, {1, 1}));
  control({"surface_rate = 0", "not 0.5"}, {ControlKind::centroid, 1, 0.5}, free_patch(4, 4, {0, 0}, {1, 1}));
  refusals.refused({"two free stretches", "one"}, [] {
    Mesh mesh = box();
    for (std::size_t k = 0; k < mesh.nodes(); ++k) {
      if (mesh.x[k] == 1 && mesh.y[k] == -0.5) mesh.held[k] = {};
    }
    Flow flow(mesh);
  });
  refusals.refused({"goes back in x"},
                   [] { Flow flow(layer_mesh({.end = 1, .columns = 8, .rows = 8, .right_wall = false})); });
  refusals.refused({"\"eulerian\"", "fixed_x"}, [] { (void)control_named("eulerian"); });
  refusals.refused({"elevation at x", "nan"},
                   [] { Flow flow(box(), {.elevation = [](double) { return not_a_number; }}); });
  refusals.refused({"outline"}, [] { Flow flow(box(), {.elevation = [](double) { return -1.5; }}); });
  refusals.refused({"u[", "nan", "finite"}, [] {
    Flow flow(box(), {.velocity = [](Point) { return Point{not_a_number, 0}; }});
  });
  refusals.refused({"drift_feedback", "= 1.5", "[0, 1]"}, [] { Flow flow(box(), {}, {}, {}, 1.5); });
  refusals.refused({"singular configuration", "set stabilisation > 0"}, [] {
    Flow flow(layer_mesh({.end = 3, .columns = 24, .rows = 8, .staggered = false}), {}, {}, {.stabilisation = 0});
  });
  Flow flow(box(), {}, {ControlKind::mapped, 4, 8});
  refusals.refused({"rate * tau", "= 1.2", "[0, 1]"}, [&] { flow.advance(0.3); });
  refusals.refused({"surface_rate * tau", "= 1.6"}, [&] { flow.advance(0.2); });
  const auto channel = refusals.with<SteppedChannel>([&](const SteppedChannel& c) { (void)stepped_channel_mesh(c); });
  channel({"step - begin", "= -1"}, {.step = -1});
  channel({"end - step", "= -5"}, {.step = 25});
  channel({"shelf - bottom", "= -0.5"}, {.bottom = -0.5, .shelf = -1});
  channel({"level - shelf", "= -0.1"}, {.shelf = 0.1});
  channel({"rows", "= 1", "at least 2"}, {.rows = 1});
}

TEST_CASE("a step that exchanges more mass than available, or does not converge, is rejected", "[robustness]") {
  Check check("variable_mass_exchange_limits", "Exchanges that no step can hold",
              "Three bodies of mass 1. One gives away more mass than it has; or the three exchange a large mass in a "
              "ring, which leaves their masses unchanged but prevents convergence.");
  const std::vector<double> masses(3, 1.0), x{0.25, 0.5, 0.75}, y(3, 0.0);
  Convection convection;
  const std::string given = message_of<mechanics::Infeasible>([&] {
    convection.begin(masses, std::vector<Exchange>{{1, 2, 1.5}}, {x, y});
  });
  INFO(given);
  check.holds(
      "The run stops before a mass becomes negative or zero.",
      {given.find("mass of node 2 at (0.75, 0) becomes -0.5") != std::string::npos ? 1.0 : 0.0},
      Qualitative{"mechanics::Infeasible with the node, its position and the mass", "the root of it is needed"});
  convection.begin(masses, std::vector<Exchange>{{0, 1, 30}, {1, 2, 30}, {2, 0, 30}}, {x, y});
  const std::vector<double> u{1, 0, -0.5, 0, 0.3, 0.2};
  std::vector<double> mean = u;
  const auto respond = [&](std::span<double> momenta) {
    for (std::size_t i = 0; i < 6; ++i) momenta[i] /= convection.mean_masses()[i % 3];
  };
  const std::string unsettled = message_of<mechanics::Infeasible>([&] { convection.settle(u, respond, 0, mean); });
  INFO(unsettled);
  check.holds(
      "The run stops when an iteration does not converge.",
      {unsettled.find("does not settle in 60 iterations") != std::string::npos ? 1.0 : 0.0},
      Qualitative{"mechanics::Infeasible with the number of iterations", "an unsettled step would not be neutral"});
}

TEST_CASE("variable masses that cannot continue stop with time, step and position", "[robustness]") {
  Check check("variable_mass_breakdown", "Variable masses break down",
              "A free patch whose two ends are thrown at each other: nodes of the outline meet. A wave of the height "
              "of the box: its surface overturns. Both stop with state and masses as before the step.");
  const auto together = [](Point r) {
    return Point{-std::sin(4 * r.x) * std::cosh(4 * r.y), std::cos(4 * r.x) * std::sinh(4 * r.y)};
  };
  Flow jet(jittered(free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1), {.velocity = together},
           {ControlKind::centroid, 1, 0}, {.gravity = 0, .stabilisation = 0.1});
  holds_of_breakdown(check, "jet", run_until_break(jet, 20, 0.02), "is inverted", -20, 20);
  const auto wave = [](double x) { return 0.45 * std::cos(3.141592653589793 * x); };
  Flow high(layer_mesh({.end = 1, .columns = 16, .rows = 8}), {.elevation = wave}, {ControlKind::mapped, 1, 1});
  holds_of_breakdown(check, "high-wave", run_until_break(high, 20, 0.01), "", 0, 1);
}

}  // namespace seiche::verification::variable_mass_test
