#pragma once

#include <optional>
#include <string>

namespace seiche::io {

/// Seconds from 1970 to a date such as "2020-01-31T12:30:00.5"; none for what does not begin with one.
std::optional<double> date_in(const std::string& text);

}  // namespace seiche::io
