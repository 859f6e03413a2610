#include "validation/case/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "validation/case/reference_source.hpp"

namespace seiche::validation {

void Refinement::add(long n, const std::vector<double>& errors) {
  if (errors_.empty()) errors_.resize(errors.size());
  if (errors.size() != errors_.size()) {
    throw std::logic_error(fmt::format("{} errors of {} quantities", errors.size(), errors_.size()));
  }
  n_.push_back(static_cast<double>(n));
  for (std::size_t k = 0; k < errors.size(); ++k) errors_[k].push_back(errors[k]);
}

double Refinement::on(long n, std::size_t quantity) const {
  const auto found = std::find(n_.begin(), n_.end(), static_cast<double>(n));
  if (found == n_.end()) throw std::logic_error(fmt::format("no mesh of {} cells", n));
  return errors_.at(quantity)[static_cast<std::size_t>(found - n_.begin())];
}

evidence::ObservedOrder Refinement::order(std::size_t quantity, long coarsest) const {
  const auto first = std::lower_bound(n_.begin(), n_.end(), static_cast<double>(coarsest)) - n_.begin();
  std::vector<double> sizes;
  std::transform(n_.begin() + first, n_.end(), std::back_inserter(sizes), [](double n) { return 1 / n; });
  return evidence::observed_order(sizes, {errors_.at(quantity).begin() + first, errors_.at(quantity).end()});
}

void RefinementStudy::claim_orders(const Claims<Refinement>& claims) const {
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const RefinedQuantity& quantity = quantities[k];
    if (!quantity.order) continue;
    claims.check(
        {.id = "order-" + quantity.id,
         .text = quantity.statement,
         .quantity = "order of the error: " + quantity.name,
         .source = source},
        [k, from = coarsest](const Refinement& refinement) { return refinement.order(k, from); }, *quantity.order);
  }
}

void RefinementStudy::claim_digits(const Claims<Refinement>& claims, const Values& values,
                                   const std::string& table) const {
  struct Printed {
    long n;
    double error, unit;
  };
  const io::Table rows = values.table(table);
  const auto codes = reference_source(table).codes.at("quantity");
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    std::vector<Printed> printed;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      if (codes.at(fmt::format("{:g}", rows.column("quantity")[row])) != quantities[k].id) continue;
      printed.push_back({std::lround(rows.column("n")[row]), rows.column("error")[row], rows.column("unit")[row]});
    }
    if (printed.empty()) continue;
    claims.at(fmt::format("n = {} to {}", printed.front().n, printed.back().n))
        .check(
            {.id = "digits-" + quantities[k].id,
             .text = fmt::format("The errors are those of an earlier program: {}.", quantities[k].name),
             .quantity = "largest difference in units of the last printed digit",
             .source = "regression: an earlier program for the same scheme, table reference_data/" + table},
            [k, printed](const Refinement& refinement) -> Measurement {
              Worst off;
              for (const Printed& one : printed) {
                off.add((refinement.on(one.n, k) - one.error) / one.unit, static_cast<double>(one.n));
              }
              return {.value = off.value(), .where = fmt::format("n = {:g}", off.where())};
            },
            evidence::Bound{.limit = 0.5, .reason = "half a unit of the last printed digit"});
  }
}

void RefinementStudy::tabulate(const Refinement& refinement, evidence::Exhibit& exhibit) const {
  evidence::Table table{
      .id = "errors", .title = "Errors", .caption = "On meshes of n cells across.", .columns = {{"n", ""}}};
  for (const RefinedQuantity& quantity : quantities) table.columns.emplace_back(quantity.name, "");
  for (std::size_t i = 0; i < refinement.n().size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(refinement.n()[i]);
    for (std::size_t k = 0; k < quantities.size(); ++k) row.emplace_back(refinement.errors(k)[i]);
  }
  exhibit.table(std::move(table));
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    exhibit.measure("order_" + quantities[k].id, refinement.order(k, coarsest).order);
  }
}

void RefinementStudy::draw(const Refinement& refinement, evidence::Panel& panel) const {
  Largest largest;
  Smallest smallest;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    panel.line(quantities[k].name, refinement.n(), refinement.errors(k));
    largest.add(refinement.finest(k));
    smallest.add(refinement.finest(k));
  }
  slope_guide(panel, -1, refinement.n(), 1.5 * largest.value());
  slope_guide(panel, -2, refinement.n(), smallest.value() / 1.5);
}

}  // namespace seiche::validation
