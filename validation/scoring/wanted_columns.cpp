#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/submitted.hpp"

namespace seiche::validation {

const std::vector<std::string>& other_names(const std::string& wanted) {
  static const std::map<std::string, std::vector<std::string>> names{
      {"t", {"t", "time", "times", "tsec", "sec", "seconds", "datetime", "timestamp"}},
      {"x", {"xp", "x_coord", "posx"}},
      {"y", {"yp", "y_coord", "posy"}},
      {"eta",
       {"eta", "elevation", "surface_elevation", "free_surface", "watlev", "level", "water_level", "zeta", "wl", "ssh",
        "elev", "elev_2d", "zs", "swlz", "stage"}},
      {"h", {"depth", "water_depth", "total_depth"}},
      {"u", {"x-vel", "u_x", "vel_x", "uvel", "velocity", "hu"}},
      {"v", {"y-vel", "u_y", "vel_y", "vvel", "hv"}},
      {"p", {"pressure"}}};
  static const std::vector<std::string> none;
  const auto found = names.find(wanted);
  return found == names.end() ? none : found->second;
}

std::string plain_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c == ' ' ? '_' : std::tolower(c); });
  return name;
}

std::vector<Column> columns_of(const WantedTable& wanted) {
  std::vector<Column> columns;
  if (wanted.group) columns.push_back(*wanted.group);
  if (wanted.abscissa) columns.push_back(*wanted.abscissa);
  for (const WantedQuantity& q : wanted.quantities) columns.push_back(q.column);
  return columns;
}

std::vector<std::string> names_in_files(const std::vector<WantedTable>& wanted, const ColumnNames& renamed) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) {
    for (const Column& column : columns_of(table)) {
      const auto found = renamed.find(column.name);
      names.push_back(found == renamed.end() ? column.name : found->second);
      const std::vector<std::string>& others = other_names(column.name);
      if (found == renamed.end()) names.insert(names.end(), others.begin(), others.end());
    }
  }
  return names;
}

RowOrder in_order(const std::vector<double>& abscissa, const std::vector<std::size_t>& rows) {
  RowOrder order{.rows = rows};
  if (rows.empty()) return order;
  const auto [low, high] = std::minmax_element(rows.begin(), rows.end(),
                                               [&](std::size_t a, std::size_t b) { return abscissa[a] < abscissa[b]; });
  const double late =
      abscissa[*low] + 0.05 * (abscissa[*high] - abscissa[*low]);  // a restart is not from the beginning
  std::set<double> seen;
  bool repeats = false;
  bool back = false;
  bool onwards = true;  // every part that begins earlier goes on to where the one before it was
  bool later = true;
  double reached = abscissa[rows.front()];
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double x = abscissa[rows[k]];
    repeats = !seen.insert(x).second || repeats;
    if (k > 0 && x < abscissa[rows[k - 1]]) {
      back = true;
      onwards = onwards && abscissa[rows[k - 1]] >= reached;
      later = later && x > late;
    }
    if (x > reached) reached = x;
  }
  onwards = onwards && abscissa[rows.back()] >= reached;
  order.sorted = back && !(onwards && (repeats || later));
  if (order.sorted)
    std::stable_sort(order.rows.begin(), order.rows.end(),
                     [&](std::size_t a, std::size_t b) { return abscissa[a] < abscissa[b]; });
  std::vector<std::size_t> stays;
  for (std::size_t k = order.rows.size(); k-- > 0;) {
    if (stays.empty() || abscissa[order.rows[k]] < abscissa[stays.back()]) stays.push_back(order.rows[k]);
  }
  std::reverse(stays.begin(), stays.end());
  order.replaced = rows.size() - stays.size();
  order.rows = stays;
  return order;
}

bool in_gap(const SubmittedGroup& group, double x) {
  return std::ranges::any_of(group.gaps, [&](const auto& gap) {
    const double rounding = 1e-6 * (group.abscissa.back() - group.abscissa.front());  // of a file with few digits
    return x > gap.first + rounding && x < gap.second - rounding;
  });
}

std::vector<double> reference_at(const WantedQuantity& quantity, const SubmittedGroup& group,
                                 const std::vector<double>& x) {
  return each(x, [&](double at) {
    return in_gap(group, at) ? std::numeric_limits<double>::quiet_NaN() : quantity.reference({group.value, at});
  });
}

std::string template_of(const WantedTable& wanted, const std::string& opening) {
  std::string text = opening;
  std::vector<std::string> header;
  for (const Column& column : columns_of(wanted)) {
    text += fmt::format("# {}: {} [{}]\n", column.name, column.meaning, column.unit);
    header.push_back(fmt::format("{} [{}]", column.name, column.unit));
  }
  for (const std::string& command : *wanted.exact) text += fmt::format("# the reference: {}\n", command);
  text += fmt::format("{}\n", fmt::join(header, ","));
  const std::string blanks(wanted.quantities.size() - (wanted.abscissa ? 0 : 1), ',');
  for (const double g : wanted.group ? *wanted.groups : std::vector<double>{0}) {
    const std::string group = wanted.group ? fmt::format("{}{}", g, wanted.abscissa ? "," : "") : "";
    if (!wanted.abscissa) {
      text += fmt::format("{}{}{}\n", group, wanted.group ? "," : "", blanks);
      continue;
    }
    for (const double x : wanted.points(g)) text += fmt::format("{}{}{}\n", group, x, blanks);
  }
  return text;
}

std::optional<double> number_at_end(const std::string& name) {
  std::size_t begin = name.find_last_not_of("0123456789.");
  begin = begin == std::string::npos ? 0 : begin + 1;
  const bool negative = begin > 0 && name[begin - 1] == '-' && (begin == 1 || name[begin - 2] == '=');
  const auto number = io::number_in(name.substr(begin));
  return number && negative ? -*number : number;
}

std::optional<NearestGroup> nearest_group(const std::map<double, std::pair<double, double>>& places, double x,
                                          std::optional<double> y) {
  const auto distance = [](const auto& a, double bx, std::optional<double> by) {
    return std::hypot(a.first - bx, by && !std::isnan(a.second) ? a.second - *by : 0);
  };
  double between = 1;
  std::optional<NearestGroup> nearest;
  for (const auto& [group, place] : places) {
    if (const double d = distance(place, x, y); !nearest || d < nearest->apart) nearest = NearestGroup{group, d};
    for (const auto& [other, at] : places) {
      const double d = distance(place, at.first, std::isnan(at.second) ? std::nullopt : std::optional(at.second));
      if (other != group && d > 0 && d < between) between = d;
    }
  }
  return nearest && nearest->apart <= 0.1 * between ? nearest : std::nullopt;
}

}  // namespace seiche::validation
