/// Dates of results and of netCDF's units, as ISO 8601 writes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace seiche::io {

/// Whether an entry is 2020-01-31, or that and a time behind it; years of four digits.
bool is_date(std::string_view entry);
/// Seconds from 1970 to a date such as "2020-01-31T12:30:00.5"; none for what does not begin with one.
std::optional<double> date_in(const std::string& text);

}  // namespace seiche::io
