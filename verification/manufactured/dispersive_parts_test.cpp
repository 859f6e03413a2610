// What the ends of a channel bear and what presses on its surface: masses, inertias and forces known in closed form.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_parts_test {

using namespace dispersive_shallow_water_1d;

/// Two slopes of 1 to 4 and 1 to 8 that meet at (0, -1).
std::shared_ptr<const BottomProfile> valley() {
  return std::make_shared<PiecewiseLinearBottom>(std::vector{-8.0, 0.0, 16.0}, std::vector{1.0, -1.0, 1.0});
}

/// Kinetic energy of the rate r = 1 of one marker.
double energy_across(const Model& model, const mechanics::State& at, std::size_t marker) {
  std::vector<double> rates(model.rates(), 0.0);
  rates[model.size() + marker] = 1;
  return model.kinetic_energy(at.q, rates);
}

/// Forces on the markers, along x and then along y: over a level bottom the impulse of a kick.
std::vector<double> forces(const Channel& channel, const Markers& markers, const Forcing& forcing) {
  Model model(channel, markers, forcing);
  const mechanics::State state = model.state_of(markers);
  model.linearise({0, 0}, state.q);
  std::vector<double> kick(model.rates(), 0.0);
  model.kick(1, kick);
  for (std::size_t i = 0; i < model.size(); ++i) {
    kick[i] *= model.masses()[i];
    kick[model.size() + i] *= channel.alpha * model.masses()[i];
  }
  return kick;
}

TEST_CASE("both shores have the mass of their tip", "[manufactured]") {
  Check check("dispersive_tips", "Masses of shoreline nodes",
              "Water between slopes of 1 to 4 and 1 to 8. The mass of a tip is a quarter of its triangle, or a sixth, "
              "with which a plane surface over a plane slope accelerates uniformly, on either shore.");
  for (const auto& [mass, share, name] :
       {std::tuple{TipMass::elementary, 0.25, "elementary"}, {TipMass::consistent, 1.0 / 6, "consistent"}}) {
    const Channel channel{.bottom = valley(), .left = End::tip, .right = End::tip, .tip_mass = mass};
    const Model model(channel, still_markers(channel, equal_labels(channel, -4, 8, 12)));
    for (const auto& [side, part] : {std::pair{"left", model.masses().front() / model.rest_volumes().front()},
                                     {"right", model.masses().back() / model.rest_volumes().back()}}) {
      check.holds(fmt::format("{}-{}: Share of its cell in the mass of the tip, {}.", name, side, side), {part},
                  Roundoff{10, share, "two areas of five operations each", share});
    }
  }
}

TEST_CASE("a wall on a slope moves its column up and down", "[manufactured]") {
  Check check(
      "dispersive_wall_inertia", "Inertia of a node at a wall on a slope",
      "A node at a wall has the vertical velocity $v$ alone. Along a bottom inclined by $\\varphi$ that is $p = v "
      "\\sin\\varphi$ and normal to it $r = v \\cos\\varphi$, and the energy $m (p^2 + \\alpha r^2)/2$ (Frank) "
      "corresponds to the inertia $m (\\sin^2\\varphi + \\alpha \\cos^2\\varphi)$. A column whose vertical velocity is "
      "linear between bed and surface and that does not move sideways has $\\alpha m$ (Green and Naghdi).");
  const double slope = 0.25;
  const double cosine_square = 1 / (1 + slope * slope);
  for (const double alpha : {1.0 / 3, 0.4}) {
    for (const Kinetics kinetics : {Kinetics::frank, Kinetics::green_naghdi}) {
      const bool frank = kinetics == Kinetics::frank;
      const Channel channel{.bottom = valley(), .right = End::tip, .kinetics = kinetics, .alpha = alpha};
      const Markers markers = still_markers(channel, equal_labels(channel, -2, 8, 10));
      const Model model(channel, markers);
      const double part = 2 * energy_across(model, model.state_of(markers), 0) / model.masses().front();
      check.holds(
          fmt::format("Inertia of a wall's node, {}, alpha = {:.3g}.", frank ? "Frank" : "Green and Naghdi", alpha),
          {part},
          Roundoff{10, 1, "squares of a sine and a cosine, a sum, a quotient",
                   frank ? 1 - cosine_square + alpha * cosine_square : alpha});
    }
  }
}

TEST_CASE("pressure on the surface acts as its integral with linear weights", "[manufactured]") {
  Check check("dispersive_surface_pressure", "Pressure on the surface",
              "A pressure $p = 0.3 + 0.2 x - 0.05 x^2$ on an uneven surface: a segment from $a$ to $b$ gives its ends "
              "the integrals of $p (1 - s)$ and $p s$ over $s$ times its $(\\Delta y, -\\Delta x)$. The integrand is "
              "of degree three: Simpson's rule is exact, by which the forces are compared, and so is Gauss's of two "
              "points. The forces of gravity are taken off.");
  for (const bool periodic : {false, true}) {
    const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0),
                          .left = End::free,
                          .right = End::free,
                          .period = periodic ? 6.0 : 0};
    Markers markers = still_markers(channel, {-3, -2.1, -0.8, 0.1, 0.9, 1.5, 2.2});
    for (std::size_t i = 0; i < markers.size(); ++i) markers.y[i] = 0.2 * std::sin(1.1 * markers.x[i]);
    const auto pressure = [](double x, double) { return 0.3 + 0.2 * x - 0.05 * x * x; };
    const std::vector<double> with = forces(channel, markers, {.surface_pressure = pressure});
    const std::vector<double> without = forces(channel, markers, {});
    const std::size_t n = markers.size();
    std::vector<double> expected(2 * n, 0.0);
    for (std::size_t j = 0; j + (periodic ? 0 : 1) < n; ++j) {
      const std::size_t k = (j + 1) % n;
      const double dx = markers.x[k] + (k == 0 ? channel.period : 0) - markers.x[j];
      const double dy = markers.y[k] - markers.y[j];
      const double middle = 2 * pressure(markers.x[j] + dx / 2, 0) / 6;
      const double near = pressure(markers.x[j], 0) / 6 + middle;
      const double far = pressure(markers.x[j] + dx, 0) / 6 + middle;
      expected[j] += near * dy;
      expected[n + j] -= near * dx;
      expected[k] += far * dy;
      expected[n + k] -= far * dx;
    }
    Worst worst;
    for (std::size_t i = 0; i < 2 * n; ++i) worst.add(with[i] - without[i] - expected[i]);
    check.holds(
        std::string(periodic ? "periodic" : "open") + ": The forces on the nodes equal the integrals of the pressure.",
        {worst.value()},
        Roundoff{
            30, 1,
            "forces of gravity and pressure below 1, in some thirty operations, as impulses over masses and back"});
  }
}

}  // namespace seiche::verification::dispersive_parts_test
