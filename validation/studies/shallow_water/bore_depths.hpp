/// The depths on both sides of a bore, as two parameters of a case say them.
#pragma once

#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "validation/case/parameter.hpp"

namespace seiche::validation {

/// Throws std::invalid_argument unless the water behind is deeper, by as much as sixteen digits can tell apart.
inline void require_bore(const Values& values, const std::string& behind, const std::string& ahead) {
  constexpr double least = 1 + 1e-6;  // of their ratio: speeds and losses are differences of the depths
  if (values.real(behind) >= least * values.real(ahead)) return;
  throw std::invalid_argument(fmt::format("{} = {:g} is out of range: must exceed {} = {:g} (a bore loses energy)",
                                          behind, values.real(behind), ahead, values.real(ahead)));
}

}  // namespace seiche::validation
