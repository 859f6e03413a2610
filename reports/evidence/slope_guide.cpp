#include "reports/evidence/slope_guide.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace seiche::validation {

void slope_guide(evidence::Panel& panel, int order, const std::vector<double>& sizes, double last) {
  const double first = last * std::pow(sizes.front() / sizes.back(), order);
  panel.line(fmt::format("slope {}", std::abs(order)), std::vector{sizes.front(), sizes.back()},
             std::vector{first, last}, evidence::Role::guide);
}

}  // namespace seiche::validation
