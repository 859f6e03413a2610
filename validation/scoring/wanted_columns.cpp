#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

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
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return c == ' ' ? '_' : std::tolower(c); });
  return name;
}

std::vector<Column> columns_of(const WantedTable& wanted) {
  std::vector<Column> columns;
  if (wanted.group) columns.push_back(*wanted.group);
  if (wanted.abscissa) columns.push_back(*wanted.abscissa);
  for (const WantedQuantity& q : wanted.quantities) columns.push_back(q.column);
  return columns;
}

std::vector<double> groups_of(const WantedTable& wanted) {
  return wanted.group ? *wanted.groups : std::vector<double>{0};
}

std::vector<double> points_of(const WantedTable& wanted, double group) {
  return wanted.abscissa ? wanted.points(group) : std::vector<double>{0};
}

std::string group_in_words(const WantedTable& wanted, double group) {
  return fmt::format("{} = {:g}{}", wanted.group->name, group, after_number(wanted.group->unit));
}

const std::vector<SubmittedGroup>& groups_in(const Submitted& submitted, const WantedTable& table) {
  static const std::vector<SubmittedGroup> none;
  const auto found = submitted.find(table.name);
  return found == submitted.end() ? none : found->second;
}

std::string name_in_file(const std::string& wanted, const ColumnNames& renamed) {
  const auto found = renamed.find(wanted);
  return found == renamed.end() ? wanted : found->second;
}

std::vector<std::string> names_in_files(const std::vector<WantedTable>& wanted, const ColumnNames& renamed) {
  std::vector<std::string> names;
  for (const WantedTable& table : wanted) {
    for (const Column& column : columns_of(table)) {
      names.push_back(name_in_file(column.name, renamed));
      if (renamed.contains(column.name)) continue;
      const std::vector<std::string>& others = other_names(column.name);
      names.insert(names.end(), others.begin(), others.end());
    }
  }
  return names;
}

std::vector<std::size_t> all_rows(std::size_t count) {
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

RowOrder in_order(const std::vector<double>& abscissa, const std::vector<std::size_t>& rows) {
  RowOrder order{.rows = rows};
  if (rows.empty()) return order;
  const auto at = [&](std::size_t row) { return abscissa[row]; };
  const auto [low, high] = std::ranges::minmax(rows | std::views::transform(at));
  const double late = low + 0.05 * (high - low);  // a restart is not from the beginning
  std::set<double> seen;
  bool repeats = false, back = false, later = true;
  bool onwards = true;  // every part that begins earlier goes on to where the one before it was
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
  if (order.sorted) std::ranges::stable_sort(order.rows, {}, at);
  std::vector<std::size_t> stays;
  for (const std::size_t row : std::views::reverse(order.rows)) {
    if (stays.empty() || abscissa[row] < abscissa[stays.back()]) stays.push_back(row);
  }
  std::ranges::reverse(stays);
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
  return each(x, [&](double at) { return in_gap(group, at) ? nan : quantity.reference({group.value, at}); });
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
  for (const double g : groups_of(wanted)) {
    const std::string group = wanted.group ? fmt::format("{},", g) : "";
    for (const double x : points_of(wanted, g)) {
      text += fmt::format("{}{}{}\n", group, wanted.abscissa ? fmt::format("{}", x) : "", blanks);
    }
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
