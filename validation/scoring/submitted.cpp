#include "validation/scoring/submitted.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "seiche/samples.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr double dry_below = 0.01;  ///< of the largest depth of the reference: thinner water solvers call dry

bool is_missing(double value) {
  return std::isnan(value) || std::abs(value) >= 1e20 || value == -999 || value == -9999 || value == -99999;
}

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
      : file_(file), wanted_(wanted), alone_(alone), understood_(understood), used_(used) {
    if (!wanted.group || wanted.quantities.size() != 1 || find(*wanted.group)) return;
    const std::optional<std::string>& column = find(wanted.quantities.front().column);
    // A single column that is called by its gauge's number.
    const bool numbered = column && wanted.group->unit == "1" && !file.has("x") && group_near(number_at_end(*column));
    if (!column || (numbered && !group_of_file())) beside_ = gauges_beside();
  }

  [[nodiscard]] bool holds() const {
    return !beside_.empty() || std::any_of(wanted_.quantities.begin(), wanted_.quantities.end(),
                                           [&](const WantedQuantity& q) { return find(q.column).has_value(); });
  }

  [[nodiscard]] std::vector<SubmittedGroup> groups() const {
    for (const Column& column : columns_of(wanted_)) {
      const bool group = wanted_.group && column.name == wanted_.group->name;
      if (!group && beside_.empty()) check_length(column, values(column).size());
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
    if (find(*wanted_.group)) values.insert(this->values(*wanted_.group).begin(), this->values(*wanted_.group).end());
    std::vector<double> shown(values.begin(), values.end());
    const bool more = shown.size() > 8;
    if (more) shown.resize(8);
    return fmt::format("{}{}", fmt::join(shown, ", "), more ? ", ..." : "");
  }

 private:
  [[noreturn]] void fail(const Column& column, const std::string& what) const {
    throw std::invalid_argument(
        fmt::format("{}: column {}: {}", file_.source, find(column).value_or(column.name), what));
  }
  [[noreturn]] void fail(const Column& column, std::size_t row, const std::string& what) const {
    throw std::invalid_argument(
        fmt::format("{}: {}: column {}: {}", file_.source, file_.place(row), find(column).value_or(column.name), what));
  }
  void note(const std::string& what) const {
    const std::string sentence = file_.source + ": " + what;
    std::vector<std::string>& notes = understood_.notes;
    if (std::find(notes.begin(), notes.end(), sentence) == notes.end()) notes.push_back(sentence);
  }

  [[nodiscard]] bool is_wanted(const std::string& name) const {
    const std::vector<Column> all = columns_of(wanted_);
    return std::any_of(all.begin(), all.end(), [&](const Column& column) { return column.name == name; });
  }

  /// The name of a wanted column in the file: as --map says, the same, or one of the usual others; what is left where
  /// one quantity alone is asked for.
  [[nodiscard]] const std::optional<std::string>& find(const Column& column) const {
    const auto [kept, fresh] = found_.try_emplace(column.name);
    if (fresh) kept->second = found(column);
    return kept->second;
  }
  [[nodiscard]] std::optional<std::string> found(const Column& column) const {
    if (const auto given = understood_.renamed.find(column.name); given != understood_.renamed.end()) {
      return file_.has(given->second) ? std::optional(given->second) : std::nullopt;
    }
    if (file_.has(column.name)) return column.name;
    std::vector<std::string> others;
    for (const std::string& other : other_names(column.name)) {
      if (!others.empty() && (other == "hu" || other == "hv")) continue;  // a velocity is there as well
      for (const std::string& name : file_.names) {
        if (plain_name(name) == other && !is_wanted(name)) others.push_back(name);
      }
    }
    if (others.size() > 1) {
      fail(column, fmt::format("may be {}: say which by --map NAME={}", fmt::join(others, " or "), column.name));
    }
    if (!others.empty()) return others.front();
    const bool quantity = alone_ && understood_.gauges.empty() && wanted_.quantities.size() == 1 &&
                          column.name == wanted_.quantities.front().column.name;
    std::vector<std::string> left;
    for (const std::string& name : file_.names) {
      if (quantity && !means_another(name)) left.push_back(name);
    }
    return left.size() == 1 ? std::optional(left.front()) : std::nullopt;
  }

  [[nodiscard]] bool means_another(const std::string& name) const {
    if (is_wanted(name) || understood_.gauges.contains(name)) return true;
    for (const char* known : {"t", "x", "y", "z", "eta", "h", "u", "v", "p"}) {
      const std::vector<std::string>& others = other_names(known);
      if (name == known || std::find(others.begin(), others.end(), plain_name(name)) != others.end()) return true;
    }
    return false;
  }

  /// A column of the file in the wanted unit.
  [[nodiscard]] const std::vector<double>& values(const Column& column, const std::string& in_file = {}) const {
    const auto renamed = understood_.renamed.find(column.name);
    const std::string name = !in_file.empty()                       ? in_file
                             : renamed == understood_.renamed.end() ? find(column).value_or(column.name)
                                                                    : renamed->second;
    const auto [kept, fresh] = converted_.emplace(name, std::vector<double>());
    if (!fresh) return kept->second;
    try {
      kept->second = file_.column(name);
    } catch (const std::invalid_argument& missing) {
      if (!wanted_.group || find(*wanted_.group)) throw;
      throw std::invalid_argument(fmt::format("{}; say which hold a {}: --gauges NAME={:g},...", missing.what(),
                                              wanted_.group->name, wanted_.groups->front()));
    }
    std::vector<double>& result = kept->second;
    if (in_file.empty() && renamed == understood_.renamed.end() && name != column.name) {
      note(fmt::format("column {} is taken for {}", name, column.name));
    }
    const bool flux = (name == "hu" || name == "hv") && column.unit == "m/s" && file_.unit(name).empty();
    std::string unit = flux ? "m^2/s" : file_.unit(name);
    if (const auto epoch = epoch_of(unit); epoch && !result.empty()) {
      const double first = result.front() * conversion(epoch->unit, "s").value_or(1);
      unit = epoch->unit;
      constexpr double year = 366 * 86400.0;  // [s]; larger numbers count from somewhere else
      const double origin = first >= epoch->origin && first < epoch->origin + year ? epoch->origin : first;
      if (std::abs(first) > year) {
        for (double& value : result) value -= origin / conversion(unit, "s").value_or(1);
        note(fmt::format("column {}: counted from {:.10g} s on", name, origin));
      }
    }
    if (unit.empty()) return result;
    if (const auto factor = conversion(unit, column.unit)) {
      if (*factor == 1) return result;
      for (double& value : result) value = is_missing(value) ? value : value * *factor;
      note(fmt::format("column {}: {} became {}", name, unit, column.unit));
      return result;
    }
    const std::vector<double>* depth = file_.has("h") ? &file_.column("h") : nullptr;
    const auto factor = conversion(unit, column.unit + " m");
    if (!factor || depth == nullptr || depth->size() != result.size()) {
      converted_.erase(kept);
      fail(column, fmt::format("unit {}, must be {}, or another of the same kind", unit, column.unit));
    }
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = (*depth)[k] > 0 && !is_missing(result[k]) ? *factor * result[k] / (*depth)[k] : 0;
    }
    note(fmt::format("column {} was divided by the depth h", name));
    return result;
  }

  /// Columns that hold a gauge each, by the number in their name or by --gauges.
  [[nodiscard]] std::vector<Slice> gauges_beside() const {
    std::vector<Slice> slices;
    std::vector<std::size_t> all(file_.rows());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    const auto is_named = [&](const std::string& name) { return understood_.gauges.contains(name); };
    const bool named = std::ranges::any_of(file_.names, is_named);
    for (const std::string& name : file_.names) {
      if (std::string("txyz").find(name) != std::string::npos || name == find(*wanted_.abscissa)) continue;
      if (named && !is_named(name)) continue;
      const auto group = named ? group_named(name, understood_.gauges.at(name)) : group_near(number_at_end(name));
      if (!group) continue;
      slices.push_back({*group, all, name});
      if (!io::number_in(name)) {
        note(fmt::format("column {} is taken for {} = {:g}", name, wanted_.group->name, *group));
      }
    }
    return slices;
  }

  /// The wanted group that differs by nothing but rounding.
  [[nodiscard]] std::optional<double> group_near(std::optional<double> value) const {
    if (!value) return {};
    const double scale = worst(*wanted_.groups);
    for (const double group : *wanted_.groups) {
      if (std::abs(*value - group) <= 1e-6 * scale) return group;
    }
    return {};
  }

  /// What --gauges says of a name: a number, or a place.
  [[nodiscard]] double group_named(const std::string& name, const std::string& text) const {
    used_.insert(name);
    const std::size_t colon = text.find(':');
    const auto x = io::number_in(text.substr(0, colon));
    const auto y = io::number_in(colon == std::string::npos ? "0" : text.substr(colon + 1));
    const auto group = !x || !y ? std::nullopt : colon == std::string::npos ? group_near(x) : group_at(*x, y);
    if (!group) {
      throw std::invalid_argument(fmt::format("--gauges {}={}: must be one of {}{}", name, text,
                                              fmt::join(*wanted_.groups, ", "),
                                              wanted_.places->empty() ? "" : ", or the position x:y of one"));
    }
    return *group;
  }

  /// The gauge at a place.
  [[nodiscard]] std::optional<double> group_at(double x, std::optional<double> y) const {
    const auto found = nearest_group(*wanted_.places, x, y);
    if (!found) return {};
    if (found->apart > 1e-6)
      note(fmt::format("({:g}, {:g}) is taken for {} {:g}, {:.2g} m away", x, y.value_or(0), wanted_.group->name,
                       found->group, found->apart));
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
    const bool numbered = std::any_of(std::begin(gauge_names), std::end(gauge_names),
                                      [&](const char* begin) { return stem.starts_with(begin); });
    return numbered && wanted_.group->unit == "1" ? group_near(number_at_end(stem)) : std::nullopt;
  }

  [[nodiscard]] std::vector<Slice> slices() const {
    const WantedQuantity& first = wanted_.quantities.front();
    const std::size_t rows = beside_.empty() ? values(first.column).size() : file_.rows();
    std::vector<Slice> all;
    if (!wanted_.group) {
      all.push_back({});
      for (std::size_t row = 0; row < rows; ++row) all.front().rows.push_back(row);
      return all;
    }
    if (!beside_.empty()) return beside_;
    const Column& column = *wanted_.group;
    const Column x{"x", "m", ""};
    const Column y{"y", "m", ""};
    std::optional<double> whole;
    std::map<std::pair<double, double>, std::optional<double>> found;  // by place
    const bool named = find(column).has_value();
    const bool by_place = !named && !wanted_.places->empty() && find(x);
    if (!named && !by_place) whole = group_of_file();
    if (named || (!by_place && !whole)) (void)values(column);  // says that it is missing
    for (const double g : *wanted_.groups) all.push_back({.group = g, .rows = {}});
    for (std::size_t row = 0; row < rows; ++row) {
      std::optional<double> own = whole;
      if (named) own = group_near(values(column).at(std::min(row, values(column).size() - 1)));
      if (by_place) {
        const auto at_y = find(y) ? std::optional(values(y)[row]) : std::nullopt;
        const auto [kept, fresh] = found.try_emplace({values(x)[row], at_y.value_or(0)});
        if (fresh) kept->second = group_at(values(x)[row], at_y);
        own = kept->second;
      }
      const auto slice = std::find_if(all.begin(), all.end(), [&](const Slice& s) { return own && s.group == *own; });
      if (slice != all.end()) slice->rows.push_back(row);
    }
    return all;
  }

  /// What rows that should be of one gauge or instant differ in, where the file says.
  [[nodiscard]] std::string several(const std::vector<std::size_t>& chosen) const {
    for (const char* name : {"t", "x", "y", "z"}) {
      const bool asked = (wanted_.group && find(*wanted_.group) == name) || find(*wanted_.abscissa) == name;
      if (asked || !file_.has(name)) continue;
      const std::vector<double>& at = file_.column(name);
      const double first = at[chosen.front()];
      for (const std::size_t row : chosen) {
        if (at[row] == first) continue;
        return fmt::format("holds {} = {:g} and {:g}, and one alone is asked for", name, first, at[row]);
      }
    }
    return {};
  }

  [[nodiscard]] const std::vector<double>& values(const WantedQuantity& quantity, const Slice& slice) const {
    return values(quantity.column, slice.column);
  }

  /// Without the rows of zeros with which some solvers fill the end of their files.
  void drop_padding(Slice& slice) const {
    const std::vector<double>& x = values(*wanted_.abscissa);
    const auto zero = [&](std::size_t row) {
      return x[row] == 0 && std::all_of(wanted_.quantities.begin(), wanted_.quantities.end(),
                                        [&](const WantedQuantity& q) { return values(q, slice)[row] == 0; });
    };
    std::size_t end = slice.rows.size();
    while (end > 0 && zero(slice.rows[end - 1])) --end;
    if (end == slice.rows.size() || end == 0 || !(x[slice.rows[end - 1]] > 0)) return;
    note(fmt::format("{} rows of zeros at the end are left out", slice.rows.size() - end));
    slice.rows.resize(end);
  }

  [[nodiscard]] SubmittedGroup group(Slice slice) const {
    const Column& first = wanted_.group ? *wanted_.group : wanted_.quantities.front().column;
    const std::string where =
        wanted_.group ? fmt::format(" for {} = {:g}{}", first.name, slice.group, after_number(first.unit)) : "";
    SubmittedGroup result;
    result.value = slice.group;
    if (!wanted_.abscissa) {
      if (slice.rows.size() != 1) fail(first, fmt::format("{} rows{}, must be exactly one", slice.rows.size(), where));
      for (const WantedQuantity& q : wanted_.quantities) {
        const double value = values(q, slice)[slice.rows.front()];
        if (is_missing(value)) fail(q.column, slice.rows.front(), "no value");
        result.values[q.column.name].push_back(value);
      }
      return result;
    }
    if (const WantedQuantity* h = depth()) {
      Worst deepest;
      for (const double point : wanted_.points(slice.group)) deepest.add(h->reference({slice.group, point}));
      slice.wet = dry_below * deepest.value();
    }
    const std::vector<double>& x = values(*wanted_.abscissa);
    for (const std::size_t row : slice.rows) {
      if (is_missing(x[row])) fail(*wanted_.abscissa, row, "no value");
    }
    drop_padding(slice);
    put_in_order(slice, where);
    for (const std::size_t row : slice.rows) {
      const std::optional<std::vector<double>> kept = values_at(row, slice);
      if (!kept) {
        if (!result.abscissa.empty() && (result.gaps.empty() || result.gaps.back().first != result.abscissa.back())) {
          result.gaps.emplace_back(result.abscissa.back(), x[row]);
        }
        continue;
      }
      if (!result.gaps.empty() && result.gaps.back().first == result.abscissa.back())
        result.gaps.back().second = x[row];
      result.abscissa.push_back(x[row]);
      for (std::size_t k = 0; k < kept->size(); ++k) {
        result.values[wanted_.quantities[k].column.name].push_back((*kept)[k]);
      }
    }
    if (result.abscissa.size() < slice.rows.size()) {
      note(fmt::format("{} of {} rows{} have no value and are left out", slice.rows.size() - result.abscissa.size(),
                       slice.rows.size(), where));
    }
    if (result.abscissa.size() < 2 && !is_measured_point(result)) {
      fail(first, fmt::format("{} rows{} with a value, must be at least two", result.abscissa.size(), where));
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

  void check_length(const Column& column, std::size_t length) const {
    if (length == 0) fail(column, "no values");
    const Column& other = wanted_.quantities.front().column;
    const std::size_t rows = beside_.empty() ? values(other).size() : file_.rows();
    if (length != rows) {
      fail(column, fmt::format("{} values, must be as many as in column {}: {}", length,
                               find(other).value_or(other.name), rows));
    }
  }

  void put_in_order(Slice& slice, const std::string& where) const {
    const std::vector<double>& x = values(*wanted_.abscissa);
    const RowOrder order = in_order(x, slice.rows);
    if (order.replaced == 0 && !order.sorted) return;
    if (const std::string mixed = several(slice.rows); !mixed.empty()) {
      for (std::size_t k = 1; k < slice.rows.size(); ++k) {
        const double here = x[slice.rows[k]];
        const double before = x[slice.rows[k - 1]];
        if (here > before) continue;
        fail(*wanted_.abscissa, slice.rows[k],
             fmt::format("{:g} follows {:g}{}, must increase: {}", here, before, where, mixed));
      }
    }
    if (order.sorted) note(fmt::format("rows{} were sorted by {}", where, wanted_.abscissa->name));
    if (order.replaced > 0) note(fmt::format("{} rows{} are replaced by later ones", order.replaced, where));
    slice.rows = order.rows;
  }

  [[nodiscard]] const WantedQuantity* depth() const {
    const auto found = std::find_if(wanted_.quantities.begin(), wanted_.quantities.end(),
                                    [](const WantedQuantity& q) { return q.column.name == "h" && q.reference; });
    return found == wanted_.quantities.end() ? nullptr : &*found;
  }

  /// The quantities in a row; none where one is missing that should be there.
  [[nodiscard]] std::optional<std::vector<double>> values_at(std::size_t row, const Slice& slice) const {
    std::vector<double> kept;
    for (const WantedQuantity& q : wanted_.quantities) {
      double value = values(q, slice)[row];
      if (const WantedQuantity* h = depth(); h != nullptr && is_missing(value)) {
        const double submitted = values(*h, slice)[row];
        const double water =
            is_missing(submitted) ? h->reference({slice.group, values(*wanted_.abscissa)[row]}) : submitted;
        if (water > slice.wet) {
          fail(q.column, row, fmt::format("no value where the depth is {:.3g}{}", water, after_number(h->column.unit)));
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
  bool alone_;
  Understanding& understood_;
  std::set<std::string>& used_;
  std::vector<Slice> beside_;
  mutable std::map<std::string, std::optional<std::string>> found_;
  mutable std::map<std::string, std::vector<double>> converted_;
};

}  // namespace

Submitted submitted_from(const std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                         Understanding& understood) {
  Submitted submitted;
  std::set<std::string> used;
  std::map<const io::Table*, std::string> taken;  // wide tables, by what they hold
  for (const WantedTable& table : wanted) {
    std::vector<SubmittedGroup> groups;
    std::string holder;
    std::string there;
    for (const io::Table& file : files) {
      const Reader reader(file, table, wanted.size() == 1, understood, used);
      if (!reader.holds()) continue;
      if (const auto [kept, fresh] = taken.try_emplace(&file, table.name); reader.wide() && !fresh) {
        throw std::invalid_argument(fmt::format("{}: fits the tables {} and {}: add --table with one of them",
                                                file.source, kept->second, table.name));
      }
      const std::vector<SubmittedGroup> here = reader.groups();
      if (here.empty()) there = reader.there();
      for (const SubmittedGroup& one : here) {
        const auto same =
            std::find_if(groups.begin(), groups.end(), [&](const SubmittedGroup& g) { return g.value == one.value; });
        if (same == groups.end()) {
          groups.push_back(one);
          continue;
        }
        const std::string which = table.group ? fmt::format(" at {} = {:g}", table.group->name, one.value) : "";
        throw std::invalid_argument(fmt::format("{}: holds the table {}{}, which {} holds as well", file.source,
                                                table.name, which, holder.empty() ? "another of its columns" : holder));
      }
      holder = file.source;
    }
    if (groups.empty() && !holder.empty()) {
      throw std::invalid_argument(fmt::format("{}: column {}: holds {}, must be some of {}", holder, table.group->name,
                                              there.empty() ? "places where none is" : there,
                                              fmt::join(*table.groups, ", ")));
    }
    const auto number = [&](const SubmittedGroup& one) { return std::ranges::find(*table.groups, one.value); };
    if (table.group) std::ranges::stable_sort(groups, {}, number);
    if (!groups.empty()) submitted[table.name] = std::move(groups);
  }
  for (const auto& [name, gauge] : understood.gauges) {
    if (used.contains(name)) continue;
    throw std::invalid_argument(fmt::format("--gauges {}={}: no column and no file is called {}", name, gauge, name));
  }
  // Says which column of the first table is missing, or why it cannot be used.
  if (submitted.empty()) {
    submitted[wanted.front().name] =
        Reader(files.front(), wanted.front(), wanted.size() == 1, understood, used).groups();
  }
  return submitted;
}

}  // namespace seiche::validation
