#include "seiche/mechanics/invariants.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::mechanics {

std::size_t InvariantsLedger::watch(std::string name, double initial) {
  entries_.push_back({.name = std::move(name), .initial = initial, .value = initial});
  return entries_.size() - 1;
}

void InvariantsLedger::record(Input values) {
  require_that(values.size() == entries_.size(), "values: {} given; allowed: {}, one per entry", values.size(),
               entries_.size());
  const auto keep_larger = [first = records_ == 0](double& largest, double sample) {
    // Nothing is larger than a NaN: it stays.
    if (first || std::isnan(sample) || std::abs(sample) > largest) largest = std::abs(sample);
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    Entry& entry = entries_[i];
    const double before = entry.defect;
    entry.value = values[i];
    entry.defect = (values[i] - entry.initial) - entry.booked.value();
    entry.step_defect = entry.defect - before;
    keep_larger(entry.largest_defect, entry.defect);
    keep_larger(entry.largest_step_defect, entry.step_defect);
  }
  ++records_;
}

const InvariantsLedger::Entry& InvariantsLedger::entry(const std::string& name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (found != entries_.end()) return *found;
  std::string names;
  for (const Entry& e : entries_) names += (names.empty() ? "" : ", ") + e.name;
  throw std::invalid_argument(fmt::format("invariant = {}; allowed: {}", name, names));
}

void InvariantsLedger::book(const std::string& name, double amount) {
  book(static_cast<std::size_t>(&entry(name) - entries_.data()), amount);
}

double InvariantsLedger::largest_defect(const std::string& begins) const {
  Worst worst;
  bool found = false;
  for (const Entry& e : entries_) {
    if (!e.name.starts_with(begins)) continue;
    found = true;
    worst.add(e.largest_defect);
  }
  require_that(found, "no invariant begins with {}", begins);
  return worst.value();
}

}  // namespace seiche::mechanics
