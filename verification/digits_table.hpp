/// Comparison with a table of printed numbers: one claim for the whole table.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// One computed value and the number it should have, as printed.
struct Printed {
  double value = 0;
  std::string printed;
};

/// Half a unit of the last digit printed: "0.0123" -> 0.5e-4, "1e-5" is not a printed number.
inline double half_unit(const std::string& printed) {
  const std::size_t point = printed.find('.');
  const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
}

/// Passes when every value is within half a unit of the last decimal printed or within 1e-14 of it, 45 roundings,
/// whichever is larger; the measured number is the worst deviation in units of that.
inline void check_table(Check& check, const std::string& id, const std::string& quantity,
                        const std::vector<Printed>& rows, const std::string& source) {
  Largest worst;
  for (const Printed& row : rows) {
    const double expected = std::stod(row.printed);
    const double limit = std::max(half_unit(row.printed), 1e-14 * std::abs(expected));
    const double deviation = std::abs(row.value - expected) / limit;
    INFO(quantity << ": " << row.value << " for " << row.printed);
    CHECK(deviation <= 1);
    worst.add(deviation);
  }
  check.that(
      {.id = id,
       .text = "All " + std::to_string(rows.size()) + " numbers have every digit of the reference: " + quantity + ".",
       .quantity = "largest deviation, in units of the rounding of the printed digits",
       .source = source},
      {.value = worst.value()},
      evidence::Bound{1, "half a unit of the last digit printed or, where larger, 1e-14 of the value, 45 roundings"});
}

}  // namespace seiche::verification
