#include "reports/evidence/figure.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace seiche::evidence {
namespace {

std::vector<double> copy(std::span<const double> values) {
  return {values.begin(), values.end()};
}

}  // namespace

void Panel::add(Series series, std::size_t expected_x) {
  if (series.x.size() != expected_x || (!series.y_error.empty() && series.y_error.size() != series.y.size())) {
    throw std::invalid_argument(fmt::format("figure series '{}': {} abscissae for {} ordinates, must be {}",
                                            series.label, series.x.size(), series.y.size(), expected_x));
  }
  series_.push_back(std::move(series));
}

void Panel::line(std::string label, std::span<const double> x, std::span<const double> y, Role role) {
  add({std::move(label), role, Style::line, copy(x), copy(y)}, y.size());
}

void Panel::points(std::string label, std::span<const double> x, std::span<const double> y, Role role,
                   std::span<const double> y_error) {
  add({std::move(label), role, Style::points, copy(x), copy(y), copy(y_error)}, y.size());
}

void Panel::steps(std::string label, std::span<const double> edges, std::span<const double> values, Role role) {
  add({std::move(label), role, Style::steps, copy(edges), copy(values)}, values.size() + 1);
}

void Panel::fill(std::string label, std::span<const double> x, std::span<const double> y, Role role) {
  add({std::move(label), role, Style::fill, copy(x), copy(y)}, y.size());
}

void Panel::vertical(std::string label, std::span<const double> x, Role role) {
  add({std::move(label), role, Style::vertical, copy(x)}, x.size());
}

void Panel::add(std::string label, const Lattice& lattice, Style style, Role role) {
  const std::size_t row_points = lattice.columns + 1;
  const std::size_t points = row_points * (lattice.rows + 1);
  const bool fits = lattice.x.size() == points && lattice.y.size() == points && lattice.z.size() == points;
  if (lattice.columns == 0 || lattice.rows == 0 || !fits) {
    throw std::invalid_argument(fmt::format(
        "figure series '{}': {} x, {} y and {} z for {} x {} cells, must be {} each over at least one cell", label,
        lattice.x.size(), lattice.y.size(), lattice.z.size(), lattice.columns, lattice.rows, points));
  }
  series_.push_back({std::move(label), role, style, copy(lattice.x), copy(lattice.y), {}, copy(lattice.z), row_points});
}

void Panel::surface(std::string label, const Lattice& lattice, Role role) {
  add(std::move(label), lattice, Style::surface, role);
}

void Panel::plan(std::string label, const Lattice& lattice, Role role) {
  add(std::move(label), lattice, Style::plan, role);
}

}  // namespace seiche::evidence
