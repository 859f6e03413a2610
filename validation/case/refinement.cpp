#include "validation/case/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"

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
  const auto found = std::ranges::find(n_, static_cast<double>(n));
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
    claims.from(source).check(
        "order-" + quantity.id, quantity.statement, "order of the error: " + quantity.name,
        [k, from = coarsest](const Refinement& refinement) { return refinement.order(k, from); }, *quantity.order);
  }
}

void RefinementStudy::tabulate(const Refinement& refinement, evidence::Exhibit& exhibit) const {
  evidence::Table& table = add_table(exhibit, "errors", "Errors", "On meshes of n cells across.", {"n"});
  for (const RefinedQuantity& quantity : quantities) table.columns.emplace_back(quantity.name, "");
  for (std::size_t i = 0; i < refinement.n().size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(refinement.n()[i]);
    for (std::size_t k = 0; k < quantities.size(); ++k) row.emplace_back(refinement.errors(k)[i]);
  }
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    exhibit.measure("order_" + quantities[k].id, refinement.order(k, coarsest).order);
  }
}

void RefinementStudy::draw(const Refinement& refinement, evidence::Panel& panel) const {
  std::vector<double> finest;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    panel.line(quantities[k].name, refinement.n(), refinement.errors(k));
    finest.push_back(refinement.finest(k));
  }
  slope_guide(panel, -1, refinement.n(), 1.5 * largest(finest));
  slope_guide(panel, -2, refinement.n(), smallest(finest) / 1.5);
}

}  // namespace seiche::validation
