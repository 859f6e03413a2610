#include "validation/scoring/resolving_power.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/text_table.hpp"
#include "seiche/samples.hpp"
#include "validation/case/data_folder.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/scoring/score.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr double first_size = 0.0005;
constexpr int doublings = 10;
constexpr int bisections = 4;
constexpr double kept_of_truncated = 0.6;

/// Piecewise linear, its ends held; a number is the same everywhere.
double held_at(const SubmittedGroup& group, const std::string& quantity, double x) {
  const std::vector<double>& at = group.abscissa;
  const std::vector<double>& values = group.values.at(quantity);
  return at.empty() ? values.front() : linear_at({at, values}, std::clamp(x, at.front(), at.back()));
}

/// Of the references that are asked for again and again.
std::vector<WantedTable> remembering(std::vector<WantedTable> tables) {
  for (WantedTable& table : tables) {
    for (WantedQuantity& quantity : table.quantities) {
      const auto kept = std::make_shared<std::map<std::pair<double, double>, double>>();
      quantity.reference = [kept, reference = quantity.reference](Place p) {
        const auto [found, fresh] = kept->try_emplace({p.group, p.abscissa});
        if (fresh) found->second = reference(p);
        return found->second;
      };
    }
  }
  return tables;
}

/// The reference's points with so many more between two neighbours; of two, with every second one alone for -1.
std::vector<double> denser(const std::vector<double>& points, int between) {
  std::vector<double> all;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (between < 0 && k % 2 == 1 && k + 1 < points.size()) continue;
    all.push_back(points[k]);
    if (k + 1 == points.size()) break;
    for (int i = 1; i <= between; ++i) all.push_back(std::lerp(points[k], points[k + 1], i / (between + 1.0)));
  }
  return all;
}

/// The reference as a file; `dry`: with no value where it has no depth.
io::Table file_of(const WantedTable& table, int between, bool dry = false) {
  io::Table file{.source = table.name, .names = {}, .units = {}, .columns = {}, .lines = {}, .unusable = {}};
  for (const Column& column : columns_of(table)) file.names.push_back(column.name);
  file.units.resize(file.names.size());
  file.columns.resize(file.names.size());
  for (const double group : groups_of(table)) {
    for (const double x : denser(points_of(table, group), between)) {
      std::size_t k = 0;
      if (table.group) file.columns[k++].push_back(group);
      if (table.abscissa) file.columns[k++].push_back(x);
      const WantedQuantity& first = table.quantities.front();
      const bool no_water = dry && first.column.name == "h" && first.reference({group, x}) == 0;
      for (const WantedQuantity& quantity : table.quantities) {
        file.columns[k++].push_back(no_water ? nan : quantity.reference({group, x}));
      }
    }
  }
  return file;
}

Submitted reference_of(const std::vector<WantedTable>& tables, int between, bool dry = false) {
  Submitted all;
  for (const WantedTable& table : tables) {
    Understanding understood;
    all.merge(submitted_from({file_of(table, between, dry)}, {table}, understood));
  }
  return all;
}

/// NaN where another gravity knows nothing: after a wave broke, at an instant that is not asked for.
double reference_or_none(const WantedQuantity& quantity, Place place) {
  try {
    return quantity.reference(place);
  } catch (const std::logic_error&) {
    return nan;
  }
}

/// Whether any value is another one.
bool differ(const Submitted& a, const Submitted& b) {
  for (const auto& [table, groups] : a) {
    const std::vector<SubmittedGroup>& others = b.at(table);
    if (groups.size() != others.size()) return true;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (groups[g].abscissa != others[g].abscissa) return true;
      for (const auto& [name, y] : groups[g].values) {
        const auto close = [hair = 1e-9 * worst(y)](double v, double w) { return std::abs(v - w) <= hair; };
        if (!std::ranges::equal(y, others[g].values.at(name), close)) return true;
      }
    }
  }
  return false;
}

class Battery {
 public:
  Battery(const Case& one, const Values& values)
      : case_(one), values_(values), tables_(remembering(one.submission.tables(values))) {
    for (const WantedTable& table : tables_) {
      for (const WantedQuantity& quantity : table.quantities) facts_.uncertainty[quantity.column.name] = {};
      if (table.abscissa) facts_.uncertainty[table.abscissa->name] = {};
    }
    truth_ = reference_of(tables_, 0);
    constexpr int finely = 7;
    fine_ = reference_of(tables_, finely);
  }

  std::vector<Resolved> run() {
    passes("truth", [this] { return truth_; });
    passes("half density", [this] { return reference_of(tables_, -1); });
    passes("double density", [this] { return reference_of(tables_, 1); });
    passes("dry NaN", [this] { return reference_of(tables_, 0, true); });
    for (const WantedTable& table : tables_) {
      for (const WantedQuantity& quantity : table.quantities) sizes_of(table, quantity.column);
      shapes_of(table);
      parts_of(table);
    }
    gravity();
    return std::move(rows_);
  }

 private:
  /// What a curve becomes at x, of its finely printed reference.
  using Change = std::function<double(const SubmittedGroup& fine, double x)>;
  using OfSize = std::function<Submitted(double size)>;

  /// The first claim like that, or "rejected"; empty: none is.
  template <class Like>
  [[nodiscard]] std::string judged(const std::vector<WantedTable>& tables, const Submitted& submitted,
                                   const Like& like) const {
    evidence::Record record;
    record.solver = "changed";
    try {
      score(tables, submitted, facts_.uncertainty, record);
      if (case_.submission.judge) case_.submission.judge(values_, submitted, facts_, record);
    } catch (const std::invalid_argument&) {
      return "rejected";
    }
    const auto found = std::ranges::find_if(record.claims(), like);
    return found == record.claims().end() ? std::string() : found->claim.id;
  }

  /// What notices; empty: nothing does.
  [[nodiscard]] std::string noticed(const Submitted& submitted) const {
    return judged(tables_, submitted, [](const evidence::JudgedClaim& claim) { return !claim.as_declared(); });
  }

  /// A row where a part of the truth is no result: rejected, or a claim in error.
  void part(const WantedTable& table, const std::string& what,
            const std::function<void(std::vector<SubmittedGroup>&)>& cut) {
    Submitted left{{table.name, truth_.at(table.name)}};
    cut(left.begin()->second);
    const std::string by = judged({table}, left, [](const evidence::JudgedClaim& claim) {
      return claim.judgement.verdict == evidence::Verdict::error;
    });
    if (!by.empty()) rows_.push_back({.table = table.name, .quantity = {}, .change = "part: " + what, .by = by});
  }

  void parts_of(const WantedTable& table) {
    const auto points = [&](const std::string& what, const std::function<bool(std::size_t k, std::size_t n)>& stays) {
      part(table, what, [&](std::vector<SubmittedGroup>& groups) {
        for (SubmittedGroup& group : groups) {
          const SubmittedGroup all = std::exchange(group, {.value = group.value});
          for (std::size_t k = 0; k < all.abscissa.size(); ++k) {
            if (!stays(k, all.abscissa.size())) continue;
            group.abscissa.push_back(all.abscissa[k]);
            for (const auto& [name, y] : all.values) group.values[name].push_back(y[k]);
          }
        }
      });
    };
    if (table.abscissa) {
      points("every second point", [](std::size_t k, std::size_t n) { return k % 2 == 0 || n < 3; });
      points("first points", [](std::size_t k, std::size_t n) {
        return k < 2 || static_cast<double>(k) < kept_of_truncated * static_cast<double>(n);
      });
    }
    for (const double value : truth_.at(table.name).size() > 1 ? groups_of(table) : std::vector<double>{}) {
      part(table, fmt::format("{} = {:g}", table.group->name, value), [&](std::vector<SubmittedGroup>& groups) {
        std::erase_if(groups, [&](const SubmittedGroup& group) { return group.value != value; });
      });
    }
    for (const WantedQuantity& quantity : table.quantities) {
      part(table, quantity.column.name, [&](std::vector<SubmittedGroup>& groups) {
        for (SubmittedGroup& group : groups)
          std::erase_if(group.values, [&](const auto& one) { return one.first != quantity.column.name; });
      });
    }
  }

  void passes(const std::string& change, const std::function<Submitted()>& submitted) {
    Resolved row{.table = {}, .quantity = {}, .change = change, .by = "rejected"};
    try {
      row.by = noticed(submitted());
    } catch (const std::invalid_argument&) {  // of the reader
    }
    rows_.push_back(row);
  }

  [[nodiscard]] Submitted with(const WantedTable& table, const std::string& quantity, const Change& change) const {
    Submitted changed = truth_;
    std::vector<SubmittedGroup>& groups = changed.at(table.name);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const SubmittedGroup& fine = fine_.at(table.name)[g];
      std::vector<double>& y = groups[g].values.at(quantity);
      for (std::size_t k = 0; k < y.size(); ++k) y[k] = change(fine, table.abscissa ? groups[g].abscissa[k] : 0);
    }
    return changed;
  }

  /// The size from which on a change is noticed, and by what.
  /// @param known  a size below which nothing is noticed
  [[nodiscard]] std::pair<double, std::string> smallest(const OfSize& changed, double known = 0) const {
    double below = 0;
    double size = first_size;
    std::string by = known < size ? noticed(changed(size)) : std::string();
    for (int k = 0; k < doublings && by.empty(); ++k) {
      below = size;
      size *= 2;
      if (known < size) by = noticed(changed(size));
    }
    if (by.empty()) return {nan, by};
    for (int k = 0; k < bisections && below > 0; ++k) {
      const double middle = std::sqrt(below * size);
      const std::string here = noticed(changed(middle));
      (here.empty() ? below : size) = middle;
      if (!here.empty()) by = here;
    }
    return {size, by};
  }

  /// @param scale  of a size of 1, in the row's unit
  void add(Resolved row, double scale, const OfSize& changed, bool both_signs = true) {
    if (!differ(changed(0.1), changed(0))) return;
    std::tie(row.smallest, row.by) = smallest(changed);
    const OfSize opposite = [&](double s) { return changed(-s); };
    if (both_signs && !row.by.empty() && noticed(opposite(row.smallest)).empty())
      std::tie(row.smallest, row.by) = smallest(opposite, row.smallest);
    row.amount = scale * row.smallest;
    rows_.push_back(row);
  }

  void sizes_of(const WantedTable& table, const Column& quantity) {
    const std::string& name = quantity.name;
    using Sized = std::function<double(const SubmittedGroup& fine, double x, double s)>;
    const auto add_sized = [&](const std::string& change, const std::string& unit, double scale, const Sized& sized,
                               bool both_signs = true) {
      const auto changed = [&](double s) {
        return with(table, name, [&](const SubmittedGroup& fine, double x) { return sized(fine, x, s); });
      };
      add({.table = table.name, .quantity = name, .change = change, .unit = unit}, scale, changed, both_signs);
    };
    const auto value = [&](const SubmittedGroup& g, double x) { return held_at(g, name, x); };
    std::vector<double> all;
    for (const SubmittedGroup& group : truth_.at(table.name)) {
      const std::vector<double>& y = group.values.at(name);
      all.insert(all.end(), y.begin(), y.end());
    }
    const double range = table.abscissa ? seiche::largest(all) - seiche::smallest(all) : 1;
    using Group = SubmittedGroup;
    add_sized("amplitude", "1", 1, [&](const Group& g, double x, double s) { return value(g, x) * (1 + s); });
    // Of a number, one that should be zero.
    if (table.abscissa || worst(all) == 0)
      add_sized("datum", quantity.unit, range,
                [&](const Group& g, double x, double s) { return value(g, x) + s * range; });
    if (!table.abscissa) return;
    const std::string& along = table.abscissa->unit;
    const auto length = [](const SubmittedGroup& g) { return g.abscissa.back() - g.abscissa.front(); };
    const double longest = length(fine_.at(table.name).front());
    add_sized("shift", along, longest, [&](const Group& g, double x, double s) { return value(g, x - s * length(g)); });
    add_sized("dilation", "1", 1, [&](const Group& g, double x, double s) {
      return value(g, g.abscissa.front() + (1 + s) * (x - g.abscissa.front()));
    });
    const auto smoothed = [&](const Group& g, double x, double s) {
      constexpr int samples = 32;
      double sum = 0;
      for (int k = 0; k < samples; ++k) sum += value(g, x + s * length(g) * ((k + 0.5) / samples - 0.5));
      return sum / samples;
    };
    add_sized("smoothing", along, longest, smoothed, false);
  }

  /// Without size. Of several ways to do it, the first that is not noticed counts.
  void add(const WantedTable& table, const std::string& change, const std::vector<Submitted>& ways) {
    Resolved row{.table = table.name, .quantity = {}, .change = change, .by = "same"};
    for (const Submitted& one : ways) {
      if (!differ(one, truth_)) continue;
      row.by = noticed(one);
      if (row.by.empty()) break;
    }
    if (!ways.empty()) rows_.push_back(row);
  }

  void shapes_of(const WantedTable& table) {
    const std::vector<SubmittedGroup>& right = truth_.at(table.name);
    /// The truth with some groups replaced by what `change` makes of them.
    const auto groups = [&](std::size_t from, std::size_t to, const std::function<void(SubmittedGroup&)>& change) {
      Submitted changed = truth_;
      for (std::size_t g = from; g < to; ++g) change(changed.at(table.name)[g]);
      return changed;
    };
    std::vector<Submitted> exchanged;
    for (std::size_t g = 0; g + 1 < right.size(); ++g) {
      Submitted changed = truth_;
      std::vector<SubmittedGroup>& both = changed.at(table.name);
      for (const auto& [to, from] : {std::pair{g, g + 1}, std::pair{g + 1, g}}) {
        for (auto& [name, y] : both[to].values) {
          for (std::size_t k = 0; k < y.size(); ++k)
            y[k] = held_at(right[from], name, table.abscissa ? both[to].abscissa[k] : 0);
        }
      }
      exchanged.push_back(changed);
    }
    if (table.quantities.size() > 1) {
      exchanged.push_back(groups(0, right.size(), [&](SubmittedGroup& group) {
        std::swap(group.values.at(table.quantities[0].column.name), group.values.at(table.quantities[1].column.name));
      }));
    }
    add(table, "exchanged", exchanged);
    if (!table.abscissa) return;
    const auto stand = [](SubmittedGroup& group) {
      for (auto& [name, y] : group.values) std::ranges::fill(y, y.front());
    };
    add(table, "reversed", {groups(0, right.size(), [](SubmittedGroup& group) {
          for (auto& [name, y] : group.values) std::ranges::reverse(y);
        })});
    add(table, "still", {groups(0, right.size(), stand)});
    add(table, "truncated", {groups(0, right.size(), [](SubmittedGroup& group) {
          const double end = std::lerp(group.abscissa.front(), group.abscissa.back(), kept_of_truncated);
          const auto kept = std::ranges::upper_bound(group.abscissa, end) - group.abscissa.begin();
          group.abscissa.resize(static_cast<std::size_t>(kept));
          for (auto& [name, y] : group.values) y.resize(group.abscissa.size());
        })});
    std::vector<Submitted> dead;
    for (std::size_t g = 0; g < right.size() && right.size() > 1; ++g) dead.push_back(groups(g, g + 1, stand));
    add(table, "dead", dead);
  }

  void gravity() {
    const auto& declared = values_.declared();
    if (std::ranges::find(declared, "gravity", &Parameter::name) == declared.end()) return;
    const double right = values_.real("gravity");
    Values heavier = values_;
    heavier.set("gravity", Value(1.1 * right));
    const std::vector<WantedTable> theirs = case_.submission.tables(heavier);
    // Of other instants: nothing is known at the template's.
    if (!std::ranges::equal(theirs, tables_, {}, groups_of, groups_of)) return;
    const auto changed = [&](double s) {
      Values other = values_;
      other.set("gravity", Value(right * (1 + s)));
      Submitted all = truth_;
      for (const WantedTable& table : case_.submission.tables(other)) {
        for (SubmittedGroup& group : all.at(table.name)) {
          for (const WantedQuantity& quantity : table.quantities) {
            std::vector<double>& y = group.values.at(quantity.column.name);
            for (std::size_t k = 0; k < y.size(); ++k) {
              const double there = reference_or_none(quantity, {group.value, table.abscissa ? group.abscissa[k] : 0});
              y[k] = std::isnan(there) ? (k > 0 ? y[k - 1] : 0) : there;
            }
          }
        }
      }
      return all;
    };
    add({.table = {}, .quantity = {}, .change = "gravity", .unit = "m/s^2"}, right, changed);
  }

  const Case& case_;
  const Values& values_;
  std::vector<WantedTable> tables_;
  SolverFacts facts_;
  Submitted truth_;
  Submitted fine_;  ///< the reference between the template's points, too
  std::vector<Resolved> rows_;
};

}  // namespace

std::vector<Resolved> resolving_power(const Case& one, const Values& values) {
  return Battery(one, values).run();
}

std::string told_by(const std::vector<Resolved>& rows, const std::string& table, const std::string& quantity) {
  std::vector<std::string> told, untold;
  for (const Resolved& row : rows) {
    const bool other = row.table != table || row.quantity != quantity || row.right_result();
    if (other || std::isnan(row.smallest) != row.by.empty()) continue;
    if (row.by.empty()) {
      untold.push_back(row.change);
    } else if (row.unit == "1") {
      told.push_back(fmt::format("{:.2g} % of {}", 100 * row.smallest, row.change));
    } else {
      told.push_back(fmt::format("{:.2g}{} of {}", row.amount, after_number(row.unit), row.change));
    }
  }
  if (told.empty() && untold.empty()) return {};
  return fmt::format(
      "{}: {}{}{}", quantity.empty() ? "all" : quantity, told.empty() ? "" : "detects ", fmt::join(told, ", "),
      untold.empty() ? "" : fmt::format("{}does not detect {}", told.empty() ? "" : "; ", fmt::join(untold, ", ")));
}

std::map<std::string, std::vector<Resolved>> recorded_power() {
  std::map<std::string, std::vector<Resolved>> cases;
  const auto number = [](const std::string& word) { return io::number_in(word).value_or(nan); };
  for (const std::vector<std::string>& words : recorded_rows("resolving_power.csv")) {
    cases[words.at(0)].push_back(
        {words.at(1), words.at(2), words.at(3), number(words.at(4)), number(words.at(5)), words.at(6), words.at(7)});
  }
  return cases;
}

}  // namespace seiche::validation
