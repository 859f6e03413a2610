#include "validation/dam_break/column_front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/reference_source.hpp"

namespace seiche::validation {
namespace {

struct Origin {
  std::string name;
  std::string table;
  std::string time, front;  ///< columns
  std::string label, citation;
  double aspect;
  bool tall;
  bool measured;
  std::optional<double> digitisation = {};
  double tank = 0;
};

const std::vector<Origin> origins{
    {"martin_moyce_tall_wide", "martin_moyce_1952_tall_wide", "T", "X_over_a", "Martin and Moyce, a = 5.715 cm",
     "Martin and Moyce (1952), figure 3", 2, true, true},
    {"martin_moyce_tall_narrow", "martin_moyce_1952_tall_narrow", "T", "X_over_a", "Martin and Moyce, a = 2.8575 cm",
     "Martin and Moyce (1952), figure 3", 2, true, true},
    {"martin_moyce_square", "martin_moyce_1952_square_front", "Tg", "X_over_a", "Martin and Moyce, square column",
     "Martin and Moyce (1952)", 1, false, true},
    {"koshizuka_oka_1", "koshizuka_oka_1996_experiment", "T", "X_over_L", "Koshizuka and Oka, first digitisation",
     "Koshizuka and Oka (1996)", 2, true, true, 1.0, 4},
    {"koshizuka_oka_2", "koshizuka_oka_1996_experiment", "T", "X_over_L", "Koshizuka and Oka, second digitisation",
     "Koshizuka and Oka (1996)", 2, true, true, 2.0, 4},
    {"koshizuka_oka_mps", "koshizuka_oka_1996_mps", "T", "X_over_L", "Koshizuka and Oka, MPS computation",
     "Koshizuka and Oka (1996)", 2, true, false, std::nullopt, 4},
    {"interfoam", "interfoam_1912_collapsing_column", "T", "X_over_a", "interFoam 1912, volume of fluid",
     "OpenFOAM 1912, interFoam", 2, true, false},
};

}  // namespace

std::vector<std::string> column_fronts() {
  std::vector<std::string> names;
  for (const Origin& origin : origins) names.push_back(origin.name);
  return names;
}

ColumnFront column_front(const std::string& name, const Values& values) {
  const auto found = std::ranges::find(origins, name, &Origin::name);
  if (found == origins.end()) {
    throw std::invalid_argument(
        fmt::format("no front is called \"{}\"; there are {}", name, fmt::join(column_fronts(), ", ")));
  }
  const io::Table table = values.table(found->table);
  ColumnFront result{.name = name,
                     .label = found->label,
                     .citation = found->citation,
                     .aspect = found->aspect,
                     .tall = found->tall,
                     .measured = found->measured,
                     .uncertainty = reference_source(found->table).standard_uncertainty.at(found->front).value,
                     .time_uncertainty = reference_source(found->table).standard_uncertainty.at(found->time).value,
                     .tank = found->tank};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (found->digitisation && table.column("digitisation")[i] != *found->digitisation) continue;
    result.T.push_back(table.column(found->time)[i]);
    result.X.push_back(table.column(found->front)[i]);
  }
  return result;
}

void measure_shift(evidence::Exhibit& exhibit, const ShiftedFront& fit) {
  exhibit.measure("points", static_cast<double>(fit.points));
  exhibit.measure("rms_as_it_stands", fit.raw_rms);
  exhibit.measure("rms_shifted", fit.rms);
}

}  // namespace seiche::validation
