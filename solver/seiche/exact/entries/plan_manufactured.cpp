#include "seiche/exact/plan_manufactured.hpp"

#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution plan_manufactured_entry() {
  return {
      .name = "plan_manufactured",
      .title = "Manufactured motion for the Green-Naghdi equations in a square basin, with its body force",
      .citation = PlanManufactured::provenance().citation,
      .formula = PlanManufactured::provenance().formula,
      .parameters = {{"amplitude", "m", 0.15, -1e6, 1e6, "of the motion, at most 0.3 length/pi"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"length", "m", std::numbers::pi, 1e-9, 1e6, "side of the basin"},
                     {"frequency", "1/s", 1.3, 1e-9, 1e6, "angular frequency of the motion"},
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "factor of the vertical kinetic energy, 1/3 for Green-Naghdi"}},
      .inputs = {{"label_x", "m", 0.5, "label X of the column of water"},
                 {"label_y", "m", 0.5, "label Y of the column of water"},
                 time_t},
      .outputs = {{"x", "m", "place"},
                  {"y", "m", "place"},
                  {"u", "m/s", "horizontal velocity along x"},
                  {"v", "m/s", "horizontal velocity along y"},
                  {"h", "m", "depth"},
                  {"h_rate", "m/s", "rate of the depth at the label"},
                  {"lambda", "m^2/s^2", "multiplier of the volume, g h at rest"},
                  {"bx", "m/s^2", "body force per unit mass along x"},
                  {"by", "m/s^2", "body force per unit mass along y"}},
      .scalars = {{"period", "s", "period of the motion"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                PlanManufactured({.gravity = p.at("gravity"),
                                  .depth = p.at("depth"),
                                  .length = p.at("length"),
                                  .amplitude = p.at("amplitude"),
                                  .frequency = p.at("frequency"),
                                  .alpha = p.at("alpha")}),
                [](const PlanManufactured& flow, std::span<const double> at) {
                  const PlanManufactured::Sample s = flow.at(at[0], at[1], at[2]);
                  return Evaluator::Row{s.x, s.y, s.u, s.v, s.depth, s.depth_rate, s.lambda, s.bx, s.by};
                },
                [](const PlanManufactured& flow) {
                  return Evaluator::Row{2 * std::numbers::pi / flow.parameters().frequency};
                });
          },
  };
}

}  // namespace seiche::exact
