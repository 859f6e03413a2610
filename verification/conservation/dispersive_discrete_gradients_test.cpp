// The fully conservative scheme of the dispersive shallow-water model keeps energy and volumes whatever the channel.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_defects.hpp"

namespace seiche::verification::dispersive_discrete_gradients_test {

using namespace dispersive_shallow_water_1d;

struct Basin {
  std::string id, text;
  Channel channel;
  TimeComposition composition = TimeComposition::none;
  double end = 60;
};

std::shared_ptr<const BottomProfile> level() {
  return std::make_shared<LevelBottom>(1.0);
}

std::shared_ptr<const BottomProfile> waves() {
  return std::make_shared<CosineBottom>(1.0, 0.2, 2 * std::numbers::pi / 10);
}

/// Slopes 1:5 down to depth 1, shores at -20 and 20.
std::shared_ptr<const BottomProfile> trough() {
  return std::make_shared<PiecewiseLinearBottom>(std::vector{-30.0, -15.0, 15.0, 30.0},
                                                 std::vector{2.0, -1.0, -1.0, 2.0});
}

std::vector<Basin> basins() {
  std::vector<Basin> all{
      {"walls", "walls", {.bottom = level()}},
      {"free", "free ends", {.bottom = level(), .left = End::free, .right = End::free}, TimeComposition::none, 10},
      {"free-wall",
       "a free end and a wall over an uneven bottom",
       {.bottom = waves(), .left = End::free},
       TimeComposition::none,
       3},
      {"walls-uneven", "walls on an uneven bottom", {.bottom = waves()}},
      {"walls-uneven-gn",
       "walls on an uneven bottom, Green-Naghdi",
       {.bottom = waves(), .kinetics = Kinetics::green_naghdi}},
      {"tips", "two shores", {.bottom = trough(), .left = End::tip, .right = End::tip}},
      {"tips-consistent",
       "two shores with consistent masses",
       {.bottom = trough(), .left = End::tip, .right = End::tip, .tip_mass = TipMass::consistent}},
      {"tips-gn",
       "two shores, Green-Naghdi",
       {.bottom = trough(), .left = End::tip, .right = End::tip, .kinetics = Kinetics::green_naghdi}},
      {"uneven", "periodic over an uneven bottom", {.bottom = waves(), .period = 40}},
      {"uneven-gn",
       "periodic over an uneven bottom, Green-Naghdi",
       {.bottom = waves(), .period = 40, .kinetics = Kinetics::green_naghdi}},
      {"slope-energy",
       "periodic, energy of the cells' slope halved",
       {.bottom = level(), .period = 40, .slope_energy = 1.0 / 6}},
      {"suzuki", "periodic, Suzuki's composition", {.bottom = level(), .period = 40}, TimeComposition::suzuki}};
  for (const auto& [id, power] :
       {std::pair{"0", 0.0}, std::pair{"2-3", 2.0 / 3}, std::pair{"1", 1.0}, std::pair{"2", 2.0}}) {
    all.push_back({fmt::format("dispersion-{}", id),
                   fmt::format("improved dispersion, depth to the power {:.2g}, walls on an uneven bottom", power),
                   {.bottom = waves(), .alpha = 0.4, .gamma = 1.0 / 15, .depth_power = power, .reference_depth = 0.9}});
  }
  return all;
}

TEST_CASE("discrete gradients keep energy and volumes in every kind of channel", "[conservation]") {
  Check check("dispersive_discrete_gradients", "Dispersive shallow water: energy in every kind of channel",
              "Still water over 40 depths gets the velocity $0.1\\,e^{-(x/4)^2}$, made compatible with constant "
              "volumes. The waves run to the ends and back, $t \\le 60$; water with a free end collapses there like "
              "one behind a dam, $t \\le 10$ and 3. Cells of 0.25, steps of at most 0.1. The fully conservative scheme "
              "has discrete gradients of every part of the energy: of gravity, of improved dispersion with any power "
              "of the depth, of the bottom under moving ends. Energy is to be kept to round-off with walls, shores and "
              "free ends, over level and uneven bottoms, for either kinetic energy.");
  for (const Basin& basin : basins()) {
    Markers markers = still_markers(basin.channel, equal_labels(basin.channel, -20, 20, 160));
    for (std::size_t i = 0; i < markers.size(); ++i) {
      markers.u[i] = 0.1 * std::exp(-markers.x[i] * markers.x[i] / 16);
    }
    Flow flow(basin.channel, markers, {.stepping = Stepping::conservative, .composition = basin.composition});
    const double energy = flow.energy();
    Largest kinetic;
    const Defects defects = defects_until(
        flow, basin.end, 0.1, 0.3, [&] { kinetic.add(flow.model().kinetic_energy(flow.state().q, flow.state().u)); });
    const auto steps = static_cast<double>(defects.steps);
    const double stages = basin.composition == TimeComposition::suzuki ? 5 : 1;
    check.holds(
        fmt::format("Energy is conserved to round-off ({}).", basin.text), {defects.energy},
        Roundoff{4 * stages * steps, std::max(1.0, kinetic.value() / energy),
                 "kinetic and potential energy, and the work of the multipliers on two volumes, rounded per step, or "
                 "per stage of a composition; collapsing water turns more than it began with into motion"});
    check.holds(fmt::format("Volumes are conserved to round-off ({}).", basin.text), {defects.volume},
                Roundoff{steps, 40, "one place in 40 depths rounded per step"});
  }
}

}  // namespace seiche::verification::dispersive_discrete_gradients_test
