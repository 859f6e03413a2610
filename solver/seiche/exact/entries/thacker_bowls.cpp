#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/thacker_bowl.hpp"

namespace seiche::exact {
namespace {

const Coordinate across_y{"y", "m", 0, "horizontal position, at right angles to x"};

const std::vector<Quantity>& bowl_outputs() {
  static const std::vector<Quantity> outputs{{"eta", "m", "surface elevation above the rim's level, where wet"},
                                             {"h", "m", "depth, 0 where dry"},
                                             {"u", "m/s", "velocity along x"},
                                             {"v", "m/s", "velocity along y"},
                                             {"z", "m", "bed elevation"}};
  return outputs;
}

template <class Bowl>
Evaluator::Row row_of(const Bowl& bowl, std::span<const double> at) {
  const auto state = bowl.at(at[0], at[1], at[2]);
  const double bed = bowl.bed(at[0], at[1]);
  // Where the bed is dry the formula of the surface runs below it; the bed is what is seen.
  return {state.depth > 0 ? bowl.surface(at[0], at[1], at[2]) : bed, state.depth, state.u, state.v, bed};
}

}  // namespace

ExactSolution thacker_radial_entry() {
  return {
      .name = "thacker_radial",
      .title = "Water pulsates in a paraboloid, a curved surface",
      .citation = ThackerRadialBowl::provenance().citation,
      .formula = ThackerRadialBowl::provenance().formula,
      .parameters = {{"radius", "m", 1, 1e-9, 1e9, "radius a of the bowl's rim"},
                     {"depth", "m", 0.1, 1e-9, 1e6, "depth h0 of the bowl below the rim"},
                     {"start_radius", "m", 0.8, 1e-9, 1e9, "r0 below the radius: at rest at t = 0 inside sqrt(a r0)"},
                     gravity_parameter(1)},
      .inputs = {position_x, across_y, time_t},
      .outputs = bowl_outputs(),
      .scalars = {{"period", "s", "period"}, {"volume", "m^3", "volume of the water"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(ThackerRadialBowl(p.at("gravity"), p.at("radius"), p.at("depth"), p.at("start_radius")),
                                row_of<ThackerRadialBowl>, [](const ThackerRadialBowl& bowl) {
                                  return Evaluator::Row{bowl.period(), bowl.volume()};
                                });
          },
  };
}

ExactSolution thacker_planar_entry() {
  return {
      .name = "thacker_planar",
      .title = "Water circles in a paraboloid, its surface a plane",
      .citation = ThackerPlanarBowl::provenance().citation,
      .formula = ThackerPlanarBowl::provenance().formula,
      .parameters = {{"radius", "m", 1, 1e-9, 1e9, "radius a of the bowl's rim"},
                     {"depth", "m", 0.1, 1e-9, 1e6, "depth h0 of the bowl below the rim"},
                     {"displacement", "m", 0.5, 1e-12, 1e9, "distance s of the water's centre from the bowl's"},
                     gravity_parameter(1)},
      .inputs = {position_x, across_y, time_t},
      .outputs = bowl_outputs(),
      .scalars = {{"period", "s", "period"}, {"volume", "m^3", "volume of the water"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(ThackerPlanarBowl(p.at("gravity"), p.at("radius"), p.at("depth"), p.at("displacement")),
                                row_of<ThackerPlanarBowl>, [](const ThackerPlanarBowl& bowl) {
                                  return Evaluator::Row{bowl.period(), bowl.volume()};
                                });
          },
  };
}

}  // namespace seiche::exact
