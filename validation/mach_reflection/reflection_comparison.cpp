#include "validation/mach_reflection/reflection_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {

using evidence::Bound;
using evidence::Measurement;

void claim_independent(evidence::Record& record, const ReflectionSeries& series,
                       const std::vector<KnownReflection>& known) {
  struct Worst {
    std::string id, text;
    double value = 0;
  };
  std::vector<Worst> worst = {{"a_w", "amplitudes at the wall, at the time at which its runs ended,"},
                              {"a_r", "reflected amplitudes"},
                              {"psi_r", "reflected angles"},
                              {"stem", "angles of the stem's path"}};
  const Bound same{.limit = 1,
                   .reason =
                       "expanded uncertainty: twice that stated with its table, and the scatter of our rows; "
                       "same spacing and steps"};
  const auto compare = [&](Worst& w, const Measurement& ours, const Known& theirs, double angle) {
    const double expanded = std::hypot(2 * theirs.uncertainty, ours.half_width());
    const double difference = std::abs(ours.value - theirs.value) / expanded;
    if (theirs.doubt.empty()) {
      w.value = std::max(w.value, difference);
      return;
    }
    record.known_failure({.id = fmt::format("{}-{}-{:g}", w.id, id_of(series.amplitude), angle),
                          .text = fmt::format("a = {:g}, {:g} deg: so are the {}.", series.amplitude, angle, w.text),
                          .quantity = "difference over its expanded uncertainty",
                          .source = independent_reflections},
                         {.value = difference, .resolution = fmt::format("h = {:g}", series.spacing)}, same,
                         theirs.doubt);
  };
  long compared = 0;
  for (std::size_t k = 0; k < series.angles.size(); ++k) {
    const Reflection& r = series.reflections[k];
    const auto one = known_reflection(known, series.amplitude, series.angles[k]);
    if (!one) continue;
    ++compared;
    compare(worst[0], wall_ratio_until(r, one->end), one->wall_ratio, one->angle);
    if (!is_steady(one->growth)) continue;  // the others are of the end, which is not the same
    compare(worst[1], r.reflected_ratio(), one->reflected_ratio, one->angle);
    compare(worst[2], r.reflected_angle(), one->reflected_angle, one->angle);
    compare(worst[3], {.value = degrees(r.stem.value), .uncertainty = degrees(r.stem.half_width()), .resolution = {}},
            one->stem_angle, one->angle);
  }
  for (const Worst& w : worst) {
    record.check(
        {.id = w.id + "-" + id_of(series.amplitude),
         .text = fmt::format("a = {:g}: the {} are those of an independent program.", series.amplitude, w.text),
         .quantity = "largest difference over its expanded uncertainty",
         .source = independent_reflections},
        {.value = w.value, .resolution = fmt::format("h = {:g}, {} angles", series.spacing, compared)}, same);
  }
}

void claim_independent_histories(evidence::Record& record, const std::vector<ReflectionSeries>& all) {
  struct History {
    double amplitude, angle;
    std::vector<double> time, wall;
  };
  const std::vector<History> known = {
      {0.3, 36, {100, 200, 300, 400, 500, 600}, {0.8168, 0.8988, 0.9414, 0.9677, 0.9843, 0.9945}},
      {0.097, 25, {301, 603, 900, 1200}, {0.2774, 0.3089, 0.3248, 0.3340}},
      {0.05, 19, {500, 1000, 1500, 2000, 2400}, {0.1393, 0.1593, 0.1695, 0.1754, 0.1780}}};
  for (const History& history : known) {
    for (const ReflectionSeries& series : all) {
      const auto angle = std::find(series.angles.begin(), series.angles.end(), history.angle);
      if (series.amplitude != history.amplitude || angle == series.angles.end()) continue;
      const Reflection& r = series.reflections[static_cast<std::size_t>(angle - series.angles.begin())];
      double worst = 0;
      for (std::size_t k = 0; k < history.time.size() && history.time[k] <= r.time.back(); ++k) {
        const double ours = r.wall_at(history.time[k]);
        worst = std::max(worst, std::abs(ours / history.wall[k] - 1));
      }
      record.check({.id = "history-" + id_of(series.amplitude),
                    .text = fmt::format("a = {:g}, {:g} deg: the stem grows as in an independent program.",
                                        series.amplitude, history.angle),
                    .quantity = "largest relative difference of a_w",
                    .source = independent_reflections},
                   {.value = worst, .resolution = r.run.resolution()},
                   Bound{.limit = 0.02, .reason = "the uncertainty stated with its amplitudes at the wall"});
    }
  }
}

}  // namespace seiche::validation
