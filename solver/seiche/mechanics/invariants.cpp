#include "seiche/mechanics/invariants.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::mechanics {

std::size_t InvariantsLedger::watch(std::string name, double initial) {
  entries_.push_back({.name = std::move(name), .initial = initial, .value = initial});
  return entries_.size() - 1;
}

void InvariantsLedger::record(Input values, double solver_residual) {
  if (values.size() != entries_.size()) {
    throw std::invalid_argument(
        fmt::format("values: {} given; allowed: {}, one per entry", values.size(), entries_.size()));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    Entry& entry = entries_[i];
    const double before = entry.defect;
    entry.value = values[i];
    entry.defect = (values[i] - entry.initial) - entry.booked.value();
    entry.step_defect = entry.defect - before;
    // A NaN must not be lost in a maximum.
    if (!(std::abs(entry.defect) <= entry.largest_defect)) entry.largest_defect = std::abs(entry.defect);
    if (!(std::abs(entry.step_defect) <= entry.largest_step_defect)) {
      entry.largest_step_defect = std::abs(entry.step_defect);
    }
  }
  residual_ = solver_residual;
  largest_residual_ = std::max(largest_residual_, solver_residual);
  ++records_;
}

const InvariantsLedger::Entry& InvariantsLedger::entry(const std::string& name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (found != entries_.end()) return *found;
  std::string names;
  for (const Entry& e : entries_) names += (names.empty() ? "" : ", ") + e.name;
  throw std::invalid_argument(fmt::format("invariant = {}; allowed: {}", name, names));
}

double InvariantsLedger::largest_defect(const std::string& begins) const {
  double largest = 0;
  bool found = false;
  for (const Entry& e : entries_) {
    if (!e.name.starts_with(begins)) continue;
    found = true;
    if (!(e.largest_defect <= largest)) largest = e.largest_defect;
  }
  if (!found) throw std::invalid_argument(fmt::format("no invariant begins with {}", begins));
  return largest;
}

Extent extent(Input values) {
  Extent result;
  CompensatedSum sum;
  for (const double v : values) {
    result.largest = std::max(result.largest, std::abs(v));
    sum.add(v);
  }
  result.sum = sum.value();
  return result;
}

}  // namespace seiche::mechanics
