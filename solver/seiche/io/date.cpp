#include "seiche/io/date.hpp"

#include <chrono>
#include <cstdio>

namespace seiche::io {

bool is_date(std::string_view entry) {
  return entry.size() >= 10 && entry.size() < 40 && entry[4] == '-' && entry[7] == '-' &&
         entry.find_first_not_of("0123456789-+:. TZ") == std::string_view::npos;
}

std::optional<double> date_in(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minute = 0;
  double second = 0;
  if (std::sscanf(text.c_str(), "%d-%2u-%2u%*1[ T]%2d:%2d:%lf", &year, &month, &day, &hour, &minute, &second) < 3)
    return {};
  const auto date = std::chrono::year(year) / std::chrono::month(month) / std::chrono::day(day);
  if (!date.ok()) return {};
  const std::chrono::sys_days days = date;
  return 86400.0 * static_cast<double>(days.time_since_epoch().count()) + 3600 * hour + 60 * minute + second;
}

}  // namespace seiche::io
