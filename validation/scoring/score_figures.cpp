#include "validation/scoring/score_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr std::size_t most_panels = 6;

void draw(evidence::Panel& panel, const WantedTable& wanted, const WantedQuantity& quantity,
          const SubmittedGroup& group) {
  std::vector<double> x = wanted.points(group.value);
  const bool exact = wanted.reference_role == evidence::Role::exact;
  if (exact) {  // known between the points as well
    const double from = x.front();
    const double to = x.back();
    constexpr int samples = 600;
    for (int k = 0; k <= samples; ++k) x.push_back(std::lerp(from, to, static_cast<double>(k) / samples));
    std::sort(x.begin(), x.end());
  }
  std::vector<double> known;
  std::vector<double> y;
  for (const double at : x) {
    const double value = quantity.reference({group.value, at});
    if (std::isnan(value)) continue;
    known.push_back(at);
    y.push_back(value);
  }
  if (exact) {
    panel.line("reference", known, y, wanted.reference_role);
  } else {
    panel.points("reference", known, y, wanted.reference_role);
  }
  panel.points("submitted", group.abscissa, group.values.at(quantity.column.name), evidence::Role::computed);
}

}  // namespace

void draw_submitted(const WantedTable& wanted, const std::vector<SubmittedGroup>& groups, evidence::Exhibit& exhibit) {
  const auto label = [](const Column& column) {
    return fmt::format("{} {} [{}]", column.meaning, column.name, column.unit);
  };
  const std::string x_label = fmt::format("{} [{}]", wanted.abscissa->name, wanted.abscissa->unit);
  if (!wanted.group) {
    auto& figure = exhibit.figure(wanted.name, fmt::format("The submitted {}", wanted.name),
                                  "The points that were submitted, with the reference.");
    for (const WantedQuantity& q : wanted.quantities) {
      draw(figure.panel({.x = x_label, .y = label(q.column)}), wanted, q, groups.front());
    }
    return;
  }
  for (const WantedQuantity& q : wanted.quantities) {
    auto& figure = exhibit.figure(wanted.name + "-" + q.column.name,
                                  fmt::format("The submitted {}: {}", wanted.name, q.column.meaning),
                                  "The points that were submitted, with the reference.");
    for (std::size_t k = 0; k < std::min(groups.size(), most_panels); ++k) {
      const std::string title =
          fmt::format("{} = {:g}{}", wanted.group->name, groups[k].value, after_number(wanted.group->unit));
      draw(figure.panel({.x = x_label, .y = label(q.column), .title = title}), wanted, q, groups[k]);
    }
  }
}

}  // namespace seiche::validation
