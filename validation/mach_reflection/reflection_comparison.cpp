#include "validation/mach_reflection/reflection_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

using evidence::Bound;

struct Quantity {
  std::string id, text;
  Measurement (*measured)(const Reflection&, const KnownReflection&);
  Known KnownReflection::*known;
  bool of_end;  ///< of the end of the run, which is the same only where nothing grows any more
};
const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {"a_w", "amplitudes at the wall, at the time at which its runs ended,",
       [](const Reflection& r, const KnownReflection& known) { return wall_ratio_until(r, known.end); },
       &KnownReflection::wall_ratio, false},
      {"a_r", "reflected amplitudes", [](const Reflection& r, const KnownReflection&) { return r.reflected_ratio(); },
       &KnownReflection::reflected_ratio, true},
      {"psi_r", "reflected angles", [](const Reflection& r, const KnownReflection&) { return r.reflected_angle(); },
       &KnownReflection::reflected_angle, true},
      {"stem", "angles of the stem's path",
       [](const Reflection& r, const KnownReflection&) {
         return Measurement{.value = degrees(r.stem.value), .uncertainty = degrees(r.stem.half_width())};
       },
       &KnownReflection::stem_angle, true}};
  return all;
}

/// A reflection of the series, by its number, and what is known of it.
struct Row {
  std::size_t number;
  KnownReflection known;
};

/// Over the expanded uncertainty, in which the scatter of our rows counts for no more than what is stated of theirs.
double difference(const ReflectionSeries& series, const Row& row, const Quantity& quantity) {
  const Measurement ours = quantity.measured(series.reflections.at(row.number), row.known);
  const Known& theirs = row.known.*quantity.known;
  const double stated = 2 * theirs.uncertainty;
  return std::abs(ours.value - theirs.value) / std::hypot(stated, std::min(ours.half_width(), stated));
}

void claim_rows(const Claims<ReflectionSeries>& claims, const ReflectionSeries& series, const Quantity& quantity,
                const std::vector<Row>& rows, std::size_t compared) {
  const Bound same{.limit = 1,
                   .reason =
                       "expanded uncertainty: twice that stated with its table, and, up to as much, the scatter "
                       "of our rows; same spacing and steps"};
  std::vector<Row> expected;
  for (const Row& row : rows) {
    const auto& doubt = (row.known.*quantity.known).doubt;
    if (!doubt) {
      expected.push_back(row);
      continue;
    }
    claims.at(fmt::format("h = {:g}", series.spacing))
        .known_failure(
            {.id = fmt::format("{}-{}-{:g}", quantity.id, id_of(series.amplitude), row.known.angle),
             .text =
                 fmt::format("a = {:g}, {:g} deg: so are the {}.", series.amplitude, row.known.angle, quantity.text),
             .quantity = "difference over its expanded uncertainty",
             .source = regression_of(known_reflections_table)},
            [row, quantity](const ReflectionSeries& r) { return difference(r, row, quantity); }, same, *doubt);
  }
  claims.only_if(!expected.empty(), "no angle of the series is known")
      .at(fmt::format("h = {:g}, {} angles", series.spacing, compared))
      .check(
          {.id = quantity.id + "-" + id_of(series.amplitude),
           .text = fmt::format("a = {:g}: the {} are those of an earlier program.", series.amplitude, quantity.text),
           .quantity = "largest difference over its expanded uncertainty",
           .source = regression_of(known_reflections_table)},
          [expected, quantity](const ReflectionSeries& r) {
            Worst worst;
            for (const Row& row : expected) worst.add(difference(r, row, quantity), row.known.angle);
            return Measurement{.value = worst.value(), .where = fmt::format("{:g} deg", worst.where())};
          },
          same);
}

}  // namespace

void claim_known_reflections(const Claims<ReflectionSeries>& claims, const ReflectionSeries& series,
                             const std::vector<KnownReflection>& known) {
  std::vector<Row> rows;
  std::vector<Row> steady;
  for (std::size_t k = 0; k < series.angles.size(); ++k) {
    const auto one = known_reflection(known, series.amplitude, series.angles[k]);
    if (!one) continue;
    rows.push_back({k, *one});
    if (is_steady(one->growth)) steady.push_back({k, *one});
  }
  for (const Quantity& quantity : quantities()) {
    claim_rows(claims, series, quantity, quantity.of_end ? steady : rows, rows.size());
  }
}

void claim_known_history(const Claims<ReflectionSeries>& claims, const ReflectionSeries& series, const Values& values) {
  const std::string name = "regression_mach_reflection_history";
  const io::Table table = values.table(name);
  for (std::size_t k = 0; k < series.angles.size(); ++k) {
    std::vector<std::pair<double, double>> history;  // time, a_w
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.column("a")[row] != series.amplitude || table.column("psi_i_deg")[row] != series.angles[k]) continue;
      history.emplace_back(table.column("t")[row], table.column("a_w")[row]);
    }
    if (history.empty()) continue;
    claims.check(
        {.id = "history-" + id_of(series.amplitude),
         .text = fmt::format("a = {:g}, {:g} deg: the stem grows as in an earlier program.", series.amplitude,
                             series.angles[k]),
         .quantity = "largest relative difference of a_w",
         .source = regression_of(name)},
        [history, k](const ReflectionSeries& all) -> Measurement {
          const Reflection& r = all.reflections.at(k);
          Worst worst;
          for (const auto& [time, wall] : history) {
            if (time <= r.time.back()) worst.add(r.wall_at(time) / wall - 1, time);
          }
          return {.value = worst.value(),
                  .resolution = r.run.resolution(),
                  .where = fmt::format("t = {:g}", worst.where())};
        },
        Bound{.limit = 0.02, .reason = "the uncertainty stated with its amplitudes at the wall"});
  }
}

}  // namespace seiche::validation
