#include "validation/dam_break/column_front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/case/reference_case.hpp"
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
};

const std::vector<Origin>& origins() {
  static const std::vector<Origin> all{
      {"martin_moyce_tall_wide", "martin_moyce_1952_tall_wide", "T", "X_over_a", "Martin and Moyce, a = 5.715 cm",
       "Martin and Moyce (1952), figure 3", 2, true, true},
      {"martin_moyce_tall_narrow", "martin_moyce_1952_tall_narrow", "T", "X_over_a", "Martin and Moyce, a = 2.8575 cm",
       "Martin and Moyce (1952), figure 3", 2, true, true},
      {"martin_moyce_square", "martin_moyce_1952_square_front", "Tg", "X_over_a", "Martin and Moyce, square column",
       "Martin and Moyce (1952)", 1, false, true},
      {"koshizuka_oka_1", "koshizuka_oka_1996_experiment", "T", "X_over_L", "Koshizuka and Oka, first digitisation",
       "Koshizuka and Oka (1996)", 2, true, true, 1.0},
      {"koshizuka_oka_2", "koshizuka_oka_1996_experiment", "T", "X_over_L", "Koshizuka and Oka, second digitisation",
       "Koshizuka and Oka (1996)", 2, true, true, 2.0},
      {"koshizuka_oka_mps", "koshizuka_oka_1996_mps", "T", "X_over_L", "Koshizuka and Oka, MPS computation",
       "Koshizuka and Oka (1996)", 2, true, false},
  };
  return all;
}

}  // namespace

double ColumnFront::unit(double gravity, double width) const {
  return std::sqrt((tall ? 2 : 1) * gravity / width);
}

const std::vector<std::string>& column_fronts() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Origin& origin : origins()) all.push_back(origin.name);
    return all;
  }();
  return names;
}

ColumnFront column_front(const std::string& name, const Values& values) {
  const auto found = std::ranges::find(origins(), name, &Origin::name);
  if (found == origins().end()) {
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
                     .uncertainty = reference_source(found->table).standard_uncertainty.at(found->front).value};
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
  exhibit.measure("time_shift", fit.shift);
  exhibit.measure("rms_shifted", fit.rms);
}

WantedTable wanted_front(const ColumnFront& data, double farthest) {
  std::vector<double> T{0}, X{1};
  T.insert(T.end(), data.T.begin(), data.T.end());
  X.insert(X.end(), data.X.begin(), data.X.end());
  double shown = T.front();
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (X[i] <= farthest) shown = T[i];
  }
  const double last = std::min(shown - ShiftRange{}.lowest, T.back());
  const std::vector<double> points = evenly(0, last, static_cast<int>(std::ceil(last / 0.05)) + 1);
  return {.name = "front",
          .kind = WantedTable::Kind::series,
          .abscissa = Column{"T", "1", data.tall ? "time t sqrt(2 g/a)" : "time t sqrt(g/a)"},
          .quantities = {{.column = {"X", "1", "front over the width a of the column, from its rear wall"},
                          .reference =
                              [T, X](Place place) {
                                return linear_at({T, X}, place.abscissa);
                              }}},
          .points = [points](double) { return points; },
          .reference_role = data.measured ? evidence::Role::data : evidence::Role::peer};
}

void judge_front(const ColumnFront& data, double farthest, const SubmittedGroup& front, evidence::Record& record) {
  const std::vector<double>& X = front.values.at("X");
  const ShiftedFront fit = shifted_front({front.abscissa, X}, data.curve(), farthest);
  const std::string resolution = fmt::format("{} points", front.abscissa.size());
  measure_shift(record, fit);
  using evidence::Bound;
  record.check({.id = "shift",
                .text = data.measured ? "The experiment is late by what its release explains, or not at all."
                                      : "The other computation starts at the same time.",
                .quantity = "shift of the time origin, in the unit of T",
                .source = data.citation},
               {.value = fit.shift, .resolution = resolution},
               data.measured
                   ? Bound{.limit = 0.2,
                           .reason = "-0.05 to 0.35: what holds the column takes 0.05 to 0.3 to melt or to be pulled "
                                     "away, by other computations; nothing where it was computed with the release",
                           .expected = 0.15}
                   : Bound{.limit = 0.1, .reason = "both columns are free at once"});
  record.check({.id = "rms",
                .text = "With this one shift the front goes through the published points.",
                .quantity = "rms difference of X/a",
                .source = data.citation},
               {.value = fit.rms, .resolution = resolution},
               Bound{.limit = data.uncertainty, .reason = "the standard uncertainty of a point"});
  auto& panel =
      record.figure("shifted", "Position of the front", "As it stands, and with one shift of the time origin.")
          .panel({.x = data.tall ? "t sqrt(2g/a)" : "t sqrt(g/a)", .y = "X/a"});
  std::vector<double> later = front.abscissa;
  for (double& T : later) T += fit.shift;
  panel.line("as it stands", front.abscissa, X, evidence::Role::computed);
  panel.line(fmt::format("{:.2f} later", fit.shift), later, X, evidence::Role::peer);
  panel.points(data.label, data.T, data.X, evidence::Role::data);
}

}  // namespace seiche::validation
