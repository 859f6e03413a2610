#include "validation/case/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"

namespace seiche::validation {

double PrintedError::number() const {
  return std::stod(value);
}

double PrintedError::unit() const {
  const std::size_t exponent = std::min(value.find('e'), value.size());
  const std::size_t point = value.find('.');
  const double decimals = point < exponent ? static_cast<double>(exponent - point - 1) : 0;
  const double power = exponent < value.size() ? std::stod(value.substr(exponent + 1)) : 0;
  return std::pow(10, power - decimals);
}

Refinement::Refinement(std::vector<RefinedQuantity> quantities, std::string source)
    : quantities_(std::move(quantities)), source_(std::move(source)), errors_(quantities_.size()) {}

void Refinement::add(long n, const std::vector<double>& errors) {
  if (errors.size() != quantities_.size()) {
    throw std::logic_error(fmt::format("{} errors of {} quantities", errors.size(), quantities_.size()));
  }
  n_.push_back(static_cast<double>(n));
  for (std::size_t k = 0; k < errors.size(); ++k) errors_[k].push_back(errors[k]);
}

double Refinement::error_on(long n, std::size_t quantity) const {
  const auto found = std::find(n_.begin(), n_.end(), static_cast<double>(n));
  if (found == n_.end()) throw std::logic_error(fmt::format("no mesh of {} cells", n));
  return errors_[quantity][static_cast<std::size_t>(found - n_.begin())];
}

void Refinement::claim_orders(evidence::Record& record, long coarsest) const {
  const auto first = std::lower_bound(n_.begin(), n_.end(), static_cast<double>(coarsest)) - n_.begin();
  std::vector<double> sizes;
  std::transform(n_.begin() + first, n_.end(), std::back_inserter(sizes), [](double n) { return 1 / n; });
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const RefinedQuantity& quantity = quantities_[k];
    const evidence::ObservedOrder observed =
        evidence::observed_order(sizes, {errors_[k].begin() + first, errors_[k].end()});
    record.measure("order_" + quantity.id, observed.order);
    if (!quantity.order) continue;
    record.check({.id = "order-" + quantity.id,
                  .text = quantity.statement,
                  .quantity = "order of the error: " + quantity.name,
                  .source = source_},
                 observed, *quantity.order);
  }
}

void Refinement::claim_digits(evidence::Record& record) const {
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const RefinedQuantity& quantity = quantities_[k];
    if (quantity.printed.empty()) continue;
    double farthest = 0;
    for (const PrintedError& printed : quantity.printed) {
      farthest = std::max(farthest, std::abs(error_on(printed.n, k) - printed.number()) / printed.unit());
    }
    record.check({.id = "digits-" + quantity.id,
                  .text = fmt::format("The errors are those of an independent implementation: {}.", quantity.name),
                  .quantity = "largest difference in units of the last printed digit",
                  .source = "computed once by an independent implementation"},
                 {.value = farthest,
                  .resolution = fmt::format("n = {} to {}", quantity.printed.front().n, quantity.printed.back().n)},
                 evidence::Bound{.limit = 0.5, .reason = "half a unit of the last printed digit"});
  }
}

void Refinement::tabulate(evidence::Record& record) const {
  evidence::Table table{
      .id = "errors", .title = "Errors", .caption = "On meshes of n cells across.", .columns = {{"n", ""}}};
  for (const RefinedQuantity& quantity : quantities_) table.columns.emplace_back(quantity.name, "");
  for (std::size_t i = 0; i < n_.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(n_[i]);
    for (const std::vector<double>& errors : errors_) row.emplace_back(errors[i]);
  }
  record.table(std::move(table));
}

void Refinement::draw(evidence::Panel& panel) const {
  for (std::size_t k = 0; k < quantities_.size(); ++k) panel.line(quantities_[k].name, n_, errors_[k]);
  const auto extreme = [&](auto compare) {
    double chosen = errors_.front().back();
    for (const std::vector<double>& errors : errors_) chosen = compare(chosen, errors.back());
    return chosen;
  };
  slope_guide(panel, -1, n_, 1.5 * extreme([](double a, double b) { return std::max(a, b); }));
  slope_guide(panel, -2, n_, extreme([](double a, double b) { return std::min(a, b); }) / 1.5);
}

}  // namespace seiche::validation
