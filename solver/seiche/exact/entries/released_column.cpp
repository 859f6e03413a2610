#include "seiche/exact/released_column.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution released_column_entry() {
  return {
      .name = "released_column",
      .title = "Pressure in a column of water at the instant of its release",
      .citation = ReleasedColumn::provenance().citation,
      .formula = ReleasedColumn::provenance().formula,
      .parameters = {{"length", "m", 2, 1e-6, 1e6, "of the column, from the wall to the free face"},
                     {"height", "m", 1, 1e-6, 1e6, "of the column"},
                     gravity_parameter(1),
                     {"density", "kg/m^3", 1, 1e-6, 1e6, "of the water"}},
      .inputs = {{"x", "m", 0, "from the wall, up to length"}, {"y", "m", 0, "above the floor, up to height"}},
      .outputs = {{"p", "Pa", "pressure"}},
      .scalars = {{"p_corner", "Pa", "pressure at the foot of the wall"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                ReleasedColumn(p.at("length"), p.at("height"), p.at("gravity"), p.at("density")),
                [](const ReleasedColumn& column, std::span<const double> at) {
                  return Evaluator::Row{column.pressure(at[0], at[1])};
                },
                [](const ReleasedColumn& column) { return Evaluator::Row{column.pressure(0, 0)}; });
          },
  };
}

}  // namespace seiche::exact
