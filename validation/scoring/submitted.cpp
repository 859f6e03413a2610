#include "validation/scoring/submitted.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "seiche/samples.hpp"
#include "validation/case/refusal.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/file_columns.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr double dry_below = 0.01;  ///< of the largest depth of the reference: thinner water solvers call dry

/// Rows of a file that belong together, and the column of each quantity.
struct Slice {
  double group = 0;
  std::vector<std::size_t> rows;
  std::string column = {};  ///< in a wide table
  double wet = 0;           ///< depth that is not called dry
};

/// One wanted table in one file, by the names of both.
class Reader {
 public:
  Reader(const io::Table& file, const WantedTable& wanted, bool alone, Understanding& understood,
         std::set<std::string>& used)
      : file_(file), wanted_(wanted), understood_(understood), used_(used), columns_(file, wanted, alone, understood) {
    for (const WantedQuantity& q : wanted.quantities) {
      const std::string& name = q.column.name;
      if (understood.renamed.contains(name) || file.unusable.contains(name) || columns_.find(q.column))
        given_.push_back(&q);
    }
    holds_ = std::ranges::any_of(given_, [&](const WantedQuantity* q) { return columns_.find(q->column).has_value(); });
    if (given_.empty()) given_.push_back(&wanted.quantities.front());  // whose column is missing
    if (!wanted.group || wanted.quantities.size() != 1 || columns_.find(*wanted.group)) return;
    const std::optional<std::string>& column = columns_.find(wanted.quantities.front().column);
    // A single column that is called by its gauge's number.
    const bool numbered = column && wanted.group->unit == "1" && !file.has("x") && group_near(number_at_end(*column));
    if (!column || (numbered && !group_of_file())) beside_ = gauges_beside();
  }

  [[nodiscard]] bool holds() const { return holds_ || wide(); }

  [[nodiscard]] std::vector<SubmittedGroup> groups() const {
    if (!wide()) {
      if (wanted_.abscissa) check_length(*wanted_.abscissa);
      for (const WantedQuantity* q : given_) check_length(q->column);
    }
    std::vector<SubmittedGroup> result;
    for (const Slice& slice : slices()) {
      if (!slice.rows.empty()) result.push_back(group(slice));
    }
    return result;
  }

  /// Whether columns hold a group each, without the name of a quantity.
  [[nodiscard]] bool wide() const { return !beside_.empty(); }

  /// The groups that the file holds, for a message.
  [[nodiscard]] std::string there() const {
    std::set<double> values;
    if (columns_.find(*wanted_.group))
      values.insert(columns_.values(*wanted_.group).begin(), columns_.values(*wanted_.group).end());
    constexpr int most = 8;
    return fmt::format("{}{}", fmt::join(values | std::views::take(most), ", "), values.size() > most ? ", ..." : "");
  }

 private:
  /// Columns that hold a gauge each, by the number in their name or by --gauges.
  [[nodiscard]] std::vector<Slice> gauges_beside() const {
    std::vector<Slice> slices;
    const std::vector<std::size_t> all = all_rows(file_.rows());
    const auto is_named = [&](const std::string& name) { return understood_.gauges.contains(name); };
    const bool named = std::ranges::any_of(file_.names, is_named);
    for (const std::string& name : file_.names) {
      if (std::string("txyz").find(name) != std::string::npos || name == columns_.find(*wanted_.abscissa)) continue;
      if (named && !is_named(name)) continue;
      const auto group = named ? group_named(name, understood_.gauges.at(name)) : group_near(number_at_end(name));
      if (!group) continue;
      slices.push_back({*group, all, name});
      if (!io::number_in(name))
        columns_.note(fmt::format("column {} is taken for {} = {:g}", name, wanted_.group->name, *group));
    }
    return slices;
  }

  /// The wanted group that differs by nothing but rounding.
  [[nodiscard]] std::optional<double> group_near(std::optional<double> value) const {
    if (!value) return {};
    const double scale = worst(*wanted_.groups);
    const auto is_near = [&](double group) { return std::abs(*value - group) <= 1e-6 * scale; };
    const auto near = std::ranges::find_if(*wanted_.groups, is_near);
    return near == wanted_.groups->end() ? std::nullopt : std::optional(*near);
  }

  /// What --gauges says of a name: a number, or a place.
  [[nodiscard]] double group_named(const std::string& name, const std::string& text) const {
    used_.insert(name);
    const std::size_t colon = text.find(':');
    const auto x = io::number_in(text.substr(0, colon));
    const auto y = io::number_in(colon == std::string::npos ? "0" : text.substr(colon + 1));
    const auto group = !x || !y ? std::nullopt : colon == std::string::npos ? group_near(x) : group_at(*x, y);
    if (group) return *group;
    fail("--gauges {}={}: must be one of {}{}", name, text, fmt::join(*wanted_.groups, ", "),
         wanted_.places->empty() ? "" : ", or the position x:y of one");
  }

  /// The gauge at a place.
  [[nodiscard]] std::optional<double> group_at(double x, std::optional<double> y) const {
    const auto found = nearest_group(*wanted_.places, x, y);
    if (!found) return {};
    if (found->apart > 1e-6)
      columns_.note(fmt::format("({:g}, {:g}) is taken for {} {:g}, {:.2g} m away", x, y.value_or(0),
                                wanted_.group->name, found->group, found->apart));
    return found->group;
  }

  /// The group of a whole file, by --gauges or by a name such as sta_0006.
  [[nodiscard]] std::optional<double> group_of_file() const {
    const std::filesystem::path path = file_.source;
    for (const std::string& name : {path.filename().string(), path.stem().string()}) {
      const auto given = understood_.gauges.find(name);
      if (given != understood_.gauges.end()) return group_named(name, given->second);
    }
    const std::string stem = plain_name(path.stem().string());
    const bool numbered = std::ranges::any_of(gauge_names, [&](const char* begin) { return stem.starts_with(begin); });
    return numbered && wanted_.group->unit == "1" ? group_near(number_at_end(stem)) : std::nullopt;
  }

  [[nodiscard]] std::vector<Slice> slices() const {
    if (wide()) return beside_;
    const std::vector<std::size_t> rows = all_rows(columns_.values(given_.front()->column).size());
    if (!wanted_.group) return {{.rows = rows}};
    const Column& column = *wanted_.group;
    const Column x{"x", "m", ""};
    const Column y{"y", "m", ""};
    std::map<std::pair<double, double>, std::optional<double>> found;  // by place
    const bool named = columns_.find(column).has_value();
    const bool by_place = !named && !wanted_.places->empty() && columns_.find(x);
    const std::optional<double> whole = named || by_place ? std::nullopt : group_of_file();
    const bool one_of_all =
        (named || (!by_place && !whole)) && columns_.values(column).size() == 1;  // or it is missing
    if (named && !one_of_all) check_length(column);
    for (const Column& axis : {x, y}) {
      if (by_place && columns_.find(axis)) check_length(axis);
    }
    std::vector<Slice> all;
    for (const double g : *wanted_.groups) all.push_back({.group = g, .rows = {}});
    for (const std::size_t row : rows) {
      std::optional<double> own = whole;
      if (named) own = group_near(columns_.values(column)[one_of_all ? 0 : row]);
      if (by_place) {
        const auto at_y = columns_.find(y) ? std::optional(columns_.values(y)[row]) : std::nullopt;
        const auto [kept, fresh] = found.try_emplace({columns_.values(x)[row], at_y.value_or(0)});
        if (fresh) kept->second = group_at(columns_.values(x)[row], at_y);
        own = kept->second;
      }
      const auto slice = std::ranges::find(all, own, [](const Slice& one) { return std::optional(one.group); });
      if (slice != all.end()) slice->rows.push_back(row);
    }
    return all;
  }

  /// What rows that should be of one gauge or instant differ in, where the file says.
  [[nodiscard]] std::string several(const std::vector<std::size_t>& chosen) const {
    for (const char* name : {"t", "x", "y", "z"}) {
      const bool asked =
          (wanted_.group && columns_.find(*wanted_.group) == name) || columns_.find(*wanted_.abscissa) == name;
      if (asked || !file_.has(name)) continue;
      const std::vector<double>& at = file_.column(name);
      if (at.size() != columns_.values(*wanted_.abscissa).size()) continue;
      const double first = at[chosen.front()];
      const auto other = std::ranges::find_if(chosen, [&](std::size_t row) { return at[row] != first; });
      if (other == chosen.end()) continue;
      return fmt::format("holds {} = {:g} and {:g}, and one alone is asked for", name, first, at[*other]);
    }
    return {};
  }

  [[nodiscard]] const std::vector<double>& values(const WantedQuantity& quantity, const Slice& slice) const {
    return columns_.values(quantity.column, slice.column);
  }

  /// Without the rows of zeros with which some solvers fill the end of their files.
  void drop_padding(Slice& slice) const {
    const std::vector<double>& x = columns_.values(*wanted_.abscissa);
    const auto zero = [&](std::size_t row) {
      return x[row] == 0 &&
             std::ranges::all_of(given_, [&](const WantedQuantity* q) { return values(*q, slice)[row] == 0; });
    };
    std::size_t end = slice.rows.size();
    while (end > 0 && zero(slice.rows[end - 1])) --end;
    if (end == slice.rows.size() || end == 0 || !(x[slice.rows[end - 1]] > 0)) return;
    columns_.note(fmt::format("{} rows of zeros at the end are left out", slice.rows.size() - end));
    slice.rows.resize(end);
  }

  [[nodiscard]] SubmittedGroup group(Slice slice) const {
    const Column& first = wanted_.group ? *wanted_.group : given_.front()->column;
    const std::string where = wanted_.group ? " for " + group_in_words(wanted_, slice.group) : std::string();
    SubmittedGroup result{.value = slice.group};
    if (!wanted_.abscissa) {
      if (slice.rows.size() != 1)
        columns_.fail(first, fmt::format("{} rows{}, must be exactly one", slice.rows.size(), where));
      for (const WantedQuantity* q : given_) {
        const double value = values(*q, slice)[slice.rows.front()];
        if (is_missing(value)) columns_.fail(q->column, slice.rows.front(), "no value");
        result.values[q->column.name].push_back(value);
      }
      return result;
    }
    if (const WantedQuantity* h = depth()) {
      const auto depth_at = [&](double point) { return h->reference({slice.group, point}); };
      slice.wet = dry_below * over<Worst>(wanted_.points(slice.group), depth_at).value();
    }
    const std::vector<double>& x = columns_.values(*wanted_.abscissa);
    for (const std::size_t row : slice.rows) {
      if (is_missing(x[row])) columns_.fail(*wanted_.abscissa, row, "no value");
    }
    drop_padding(slice);
    put_in_order(slice, where);
    for (const std::size_t row : slice.rows) {
      const std::optional<std::vector<double>> kept = values_at(row, slice);
      const bool in_gap = !result.gaps.empty() && result.gaps.back().first == result.abscissa.back();
      if (!kept) {
        if (!result.abscissa.empty() && !in_gap) result.gaps.emplace_back(result.abscissa.back(), x[row]);
        continue;
      }
      if (in_gap) result.gaps.back().second = x[row];
      result.abscissa.push_back(x[row]);
      for (std::size_t k = 0; k < kept->size(); ++k) {
        result.values[given_[k]->column.name].push_back((*kept)[k]);
      }
    }
    if (result.abscissa.size() < slice.rows.size()) {
      columns_.note(fmt::format("{} of {} rows{} have no value and are left out",
                                slice.rows.size() - result.abscissa.size(), slice.rows.size(), where));
    }
    if (result.abscissa.size() < 2 && !is_measured_point(result)) {
      columns_.fail(first, fmt::format("{} rows{} with a value, must be at least two", result.abscissa.size(), where));
    }
    return result;
  }

  /// Whether the group is one of the points of a measured profile: a reading by itself.
  [[nodiscard]] bool is_measured_point(const SubmittedGroup& group) const {
    if (wanted_.kind != WantedTable::Kind::profile || wanted_.reference_role != evidence::Role::data) return false;
    const std::vector<double> x = wanted_.points(group.value);
    const double rounding = 1e-6 * (x.back() - x.front());
    return group.abscissa.size() == 1 &&
           std::ranges::any_of(x, [&](double at) { return std::abs(at - group.abscissa.front()) <= rounding; });
  }

  void check_length(const Column& column) const {
    const std::size_t length = columns_.values(column).size();
    if (length == 0) columns_.fail(column, "no values");
    const Column& other = given_.front()->column;
    const std::size_t rows = columns_.values(other).size();
    if (length != rows) {
      columns_.fail(column, fmt::format("{} values, must be as many as in column {}: {}", length,
                                        columns_.find(other).value_or(other.name), rows));
    }
  }

  void put_in_order(Slice& slice, const std::string& where) const {
    const std::vector<double>& x = columns_.values(*wanted_.abscissa);
    const RowOrder order = in_order(x, slice.rows);
    if (order.replaced == 0 && !order.sorted) return;
    if (const std::string mixed = several(slice.rows); !mixed.empty()) {
      for (std::size_t k = 1; k < slice.rows.size(); ++k) {
        const double here = x[slice.rows[k]];
        const double before = x[slice.rows[k - 1]];
        if (here > before) continue;
        columns_.fail(*wanted_.abscissa, slice.rows[k],
                      fmt::format("{:g} follows {:g}{}, must increase: {}", here, before, where, mixed));
      }
    }
    if (order.sorted) columns_.note(fmt::format("rows{} were sorted by {}", where, wanted_.abscissa->name));
    if (order.replaced > 0) columns_.note(fmt::format("{} rows{} are replaced by later ones", order.replaced, where));
    slice.rows = order.rows;
  }

  [[nodiscard]] const WantedQuantity* depth() const {
    const auto is_depth = [](const WantedQuantity* q) { return q->column.name == "h" && q->reference; };
    const auto found = std::ranges::find_if(given_, is_depth);
    return found == given_.end() ? nullptr : *found;
  }

  /// The quantities in a row; none where one is missing that should be there.
  [[nodiscard]] std::optional<std::vector<double>> values_at(std::size_t row, const Slice& slice) const {
    std::vector<double> kept;
    for (const WantedQuantity* q : given_) {
      double value = values(*q, slice)[row];
      if (const WantedQuantity* h = depth(); h != nullptr && is_missing(value)) {
        const double submitted = values(*h, slice)[row];
        const double water =
            is_missing(submitted) ? h->reference({slice.group, columns_.values(*wanted_.abscissa)[row]}) : submitted;
        if (water > slice.wet) {
          columns_.fail(q->column, row,
                        fmt::format("no value where the depth is {:.3g}{}", water, after_number(h->column.unit)));
        }
        value = 0;
      }
      if (is_missing(value)) return {};
      kept.push_back(value);
    }
    return kept;
  }

  static constexpr const char* gauge_names[] = {"sta", "gauge", "gage", "wg", "probe"};

  const io::Table& file_;
  const WantedTable& wanted_;
  Understanding& understood_;
  std::set<std::string>& used_;
  FileColumns columns_;
  std::vector<const WantedQuantity*> given_;  // that are read
  bool holds_ = false;
  std::vector<Slice> beside_;
};

}  // namespace

std::vector<WantedTable> given_of(std::vector<WantedTable> wanted, const Submitted& submitted) {
  for (WantedTable& table : wanted) {
    std::erase_if(table.quantities, [&](const WantedQuantity& q) {
      const auto lacks_it = [&](const SubmittedGroup& group) { return !group.values.contains(q.column.name); };
      return std::ranges::any_of(groups_in(submitted, table), lacks_it);
    });
  }
  return wanted;
}

Submitted submitted_from(const std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                         Understanding& understood) {
  Submitted submitted;
  std::set<std::string> used;
  std::map<const io::Table*, std::string> taken;  // wide tables, by what they hold
  for (const WantedTable& table : wanted) {
    std::vector<SubmittedGroup> groups;
    std::string holder, there;
    for (const io::Table& file : files) {
      const Reader reader(file, table, wanted.size() == 1, understood, used);
      if (!reader.holds()) continue;
      if (const auto [kept, fresh] = taken.try_emplace(&file, table.name); reader.wide() && !fresh) {
        fail("{}: fits the tables {} and {}: add --table with one of them", file.source, kept->second, table.name);
      }
      const std::vector<SubmittedGroup> here = reader.groups();
      if (here.empty()) there = reader.there();
      for (const SubmittedGroup& one : here) {
        const auto same = std::ranges::find(groups, one.value, &SubmittedGroup::value);
        if (same == groups.end()) {
          groups.push_back(one);
          continue;
        }
        const auto is_there = [&](const auto& column) { return same->values.contains(column.first); };
        if (same->abscissa != one.abscissa || same->gaps != one.gaps || std::ranges::any_of(one.values, is_there)) {
          fail("{}: holds the table {}{}, which {} holds as well", file.source, table.name,
               table.group ? fmt::format(" at {} = {:g}", table.group->name, one.value) : "",
               holder.empty() ? "another of its columns" : holder);
        }
        same->values.insert(one.values.begin(), one.values.end());
      }
      holder = file.source;
    }
    if (groups.empty() && !holder.empty()) {
      fail("{}: column {}: holds {}, must be some of {}", holder, table.group->name,
           there.empty() ? "places where none is" : there, fmt::join(*table.groups, ", "));
    }
    const std::vector<WantedTable> common = given_of({table}, {{table.name, groups}});
    if (!groups.empty() && common.front().quantities.empty()) {
      fail("{}: holds none of the quantities of the table {} that other files hold", holder, table.name);
    }
    const auto number = [&](const SubmittedGroup& one) { return std::ranges::find(*table.groups, one.value); };
    if (table.group) std::ranges::stable_sort(groups, {}, number);
    if (!groups.empty()) submitted[table.name] = std::move(groups);
  }
  for (const auto& [name, gauge] : understood.gauges) {
    if (!used.contains(name)) fail("--gauges {0}={1}: no column and no file is called {0}", name, gauge);
  }
  // Says which column of the first table is missing, or why it cannot be used.
  if (submitted.empty()) {
    submitted[wanted.front().name] =
        Reader(files.front(), wanted.front(), wanted.size() == 1, understood, used).groups();
  }
  return submitted;
}

}  // namespace seiche::validation
