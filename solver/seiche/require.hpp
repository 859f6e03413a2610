#pragma once

#include <string_view>

namespace seiche {

/// Argument checks with one wording. Each throws std::invalid_argument naming the parameter, its value and
/// the range allowed; NaN and infinities never pass.

void require_finite(std::string_view name, double value);
void require_positive(std::string_view name, double value);
void require_not_negative(std::string_view name, double value);
/// Closed interval [lowest, highest].
void require_within(std::string_view name, double value, double lowest, double highest);
void require_at_least(std::string_view name, long value, long lowest);

}  // namespace seiche
