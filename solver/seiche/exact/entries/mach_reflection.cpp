#include "seiche/exact/mach_reflection.hpp"

#include <numbers>
#include <utility>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution mach_reflection_entry() {
  constexpr double degree = std::numbers::pi / 180;
  return {
      .name = "mach_reflection",
      .title = "A solitary wave meets a wall at an angle: Mach stem or regular reflection",
      .citation = MachReflection::provenance().citation,
      .formula = MachReflection::provenance().formula,
      .parameters = {{"amplitude", "m", 0.05, 1e-9, 1e6, "amplitude of the incident wave"},
                     {"angle", "deg", 20, 1e-6, 89.999999, "between the incident wave's direction and the wall"},
                     depth_parameter(1, 1e6),
                     {"theory", "1", 0, 0, 1, "small angles, or corrected for their size", {"miles", "kodama_yeh"}}},
      .inputs = {},
      .outputs = {{"a_w", "m", "amplitude at the wall; error of the theory about amplitude/depth, relative"},
                  {"a_r", "m", "amplitude of the reflected wave"},
                  {"psi_r", "deg", "angle of the reflected wave"},
                  {"kappa", "1", "interaction parameter, Mach reflection below 1"},
                  {"stem_angle", "deg", "direction in which the stem grows, from the wall; 0 without a stem"}},
      .scalars = {},
      .factory =
          [](const Values& p) {
            const double amplitude = p.at("amplitude");
            return evaluator_of(
                MachReflection(
                    amplitude / p.at("depth"), p.at("angle") * degree,
                    p.at("theory") == 0 ? MachReflection::Theory::miles : MachReflection::Theory::kodama_yeh),
                [amplitude](const MachReflection& reflection, std::span<const double>) {
                  return Evaluator::Row{amplitude * reflection.wall_ratio(), amplitude * reflection.reflected_ratio(),
                                        reflection.reflected_angle() / degree, reflection.kappa(),
                                        reflection.stem_angle() / degree};
                },
                [](const MachReflection&) { return Evaluator::Row{}; });
          },
  };
}

}  // namespace seiche::exact
