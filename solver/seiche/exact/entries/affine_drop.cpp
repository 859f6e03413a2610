#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/stretching_drop.hpp"

namespace seiche::exact {

ExactSolution affine_drop_entry() {
  return {
      .name = "affine_drop",
      .title = "A free liquid ellipse is stretched, without gravity",
      .citation = StretchingDrop::provenance().citation,
      .formula = StretchingDrop::provenance().formula,
      .parameters = {{"semi_axis", "m", 1, 1e-9, 1e6, "semi-axis along x at t = 0"},
                     {"other_axis", "m", 1, 1e-9, 1e6, "semi-axis along y at t = 0"},
                     {"strain_rate", "1/s", 1, -1e6, 1e6, "u = strain_rate x, v = -strain_rate y at t = 0"},
                     {"density", "kg/m^3", 1, 1e-9, 1e9, "density"}},
      .inputs = {position_x, {"y", "m", 0, "vertical position"}, time_t},
      .outputs = {{"a", "m", "semi-axis along x"},
                  {"b", "m", "semi-axis along y"},
                  {"rate", "1/s", "strain rate"},
                  {"u", "m/s", "velocity along x"},
                  {"v", "m/s", "velocity along y"},
                  {"p", "Pa", "pressure"}},
      .scalars = {{"invariant", "m^2/s^2", "rate^2 (a^2 + b^2), constant"},
                  {"time_of_doubling", "s", "when the semi-axis along x is twice what it was"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                StretchingDrop(p.at("semi_axis"), p.at("other_axis"), p.at("strain_rate"), p.at("density")),
                [](const StretchingDrop& drop, std::span<const double> at) {
                  const double t = at[2];
                  const DropInstant instant = drop.at(t);
                  const Eigen::Vector2d velocity = instant.velocity(at[0], at[1]);
                  return Evaluator::Row{drop.semi_axis(t), drop.other_axis(t), drop.strain_rate(t),
                                        velocity.x(),      velocity.y(),       instant.pressure(at[0], at[1])};
                },
                [](const StretchingDrop& drop) {
                  return Evaluator::Row{drop.invariant(), drop.time_of(2 * drop.semi_axis(0))};
                });
          },
  };
}

}  // namespace seiche::exact
