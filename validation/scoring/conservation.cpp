#include "validation/scoring/conservation.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <ranges>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/refusal.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

const std::string source = "balance of the water; Synolakis et al., Pure Appl. Geophys. 165 (2008) 2197";

/// How far something may change over its first value.
struct Allowed {
  double limit = 0;
  bool growth_alone = false;
  std::string text;
  std::string reason;
};

/// What is allowed, or why nothing is judged.
std::variant<Allowed, std::string> allowed(const std::string& phenomenon, const std::string& quantity) {
  const auto one_of = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, phenomenon) != names.end();
  };
  if (quantity != "volume" && one_of({"wavemaker", "moving_pressure"}))
    return "external forcing does work on the water";
  if (one_of({"steady_flow", "hydraulic_jump"})) return "water enters and leaves";
  if (quantity == "volume") {
    return Allowed{0.001, false, "The water volume is conserved within 0.1 % at every time.",
                   "0.1 % of the volume is 0.1 % of the depth: 1 mm in 1 m, the resolution of a gauge"};
  }
  if (quantity == "energy" && one_of({"standing_wave", "periodic_wave", "solitary_wave", "basin", "drop"})) {
    return Allowed{0.1, false, "The energy is conserved within 10 %, equivalent to 5 % of a height.",
                   "height is proportional to the square root of energy: the 5 % of height that tsunami benchmarks "
                   "allow are 10 % of energy"};
  }
  if (quantity == "energy") {
    return Allowed{0.01, true, "The energy does not grow by more than 1 %.",
                   "breaking, jumps and friction only dissipate; at a hundred cells per length, 1 % is one cell"};
  }
  if (!one_of({"periodic_wave", "drop"})) return "walls and slopes exert forces on the water";
  return Allowed{0.1, false, "The momentum is conserved within 10 %, equivalent to 5 % of a height.",
                 "wave momentum is energy over celerity: 5 % of height are 10 %"};
}

bool asked_for(const std::vector<WantedTable>& wanted, const std::string& name) {
  const auto is_it = [&](const WantedQuantity& q) { return q.column.name == name; };
  return std::ranges::any_of(wanted,
                             [&](const WantedTable& table) { return std::ranges::any_of(table.quantities, is_it); });
}

/// The largest change over the first value, growth or magnitude, and when.
Largest change_of(const std::vector<double>& t, const std::vector<double>& values, bool growth_alone) {
  const double first = values.front();
  Largest largest;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double change = (values[k] - first) / std::abs(first);
    largest.add(growth_alone ? change : std::abs(change), t[k]);
  }
  return largest;
}

void draw(const History& history, evidence::Record& record) {
  const auto shown = [&](const std::string& name) { return history.contains(name) && history.at(name).front() != 0; };
  if (std::ranges::none_of(conserved_names(), shown)) return;
  auto& panel = record
                    .figure("conservation", "Volume, energy and momentum",
                            "Change since the first row, over the first value, as submitted.")
                    .panel({.x = "t [s]", .y = "relative change"});
  for (const std::string& name : conserved_names() | std::views::filter(shown)) {
    const double first = history.at(name).front();
    panel.line(name, history.at("t"), each(history.at(name), [&](double value) { return value / first - 1; }));
  }
}

}  // namespace

const std::vector<std::string>& conserved_names() {
  static const std::vector<std::string> names{"volume", "energy", "momentum"};
  return names;
}

std::vector<std::string> history_names(const std::vector<WantedTable>& wanted, const ColumnNames& renamed) {
  std::vector<std::string> names{name_in_file("t", renamed)};
  for (const std::string& name : conserved_names()) {
    if (!asked_for(wanted, name)) names.push_back(name_in_file(name, renamed));
  }
  return names;
}

History take_history(std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                     const ColumnNames& renamed) {
  History history;
  std::string holder;
  std::erase_if(files, [&](const io::Table& file) {
    std::vector<std::string> names = conserved_names();
    std::erase_if(names, [&](const std::string& name) {
      return asked_for(wanted, name) || !file.has(name_in_file(name, renamed));
    });
    if (names.empty()) return false;
    if (!holder.empty()) fail("{}: holds a history, which {} holds as well", file.source, holder);
    holder = file.source;
    const std::vector<double>& t = file.column(name_in_file("t", renamed));
    const std::vector<std::size_t> rows = in_order(t, all_rows(t.size())).rows;
    if (rows.size() < 2) fail("{}: {} rows, must be at least two", holder, rows.size());
    names.emplace_back("t");
    for (const std::string& name : names) {
      const std::vector<double>& values = file.column(name_in_file(name, renamed));
      if (values.size() != t.size()) {
        fail("{}: column {}: {} values, must be as many as in column t: {}", holder, name, values.size(), t.size());
      }
      for (const std::size_t row : rows) {
        if (std::isnan(values[row])) fail("{}: {}: column {}: no value", holder, file.place(row), name);
        history[name].push_back(values[row]);
      }
    }
    const auto is_held = [&](const WantedQuantity& q) { return file.has(name_in_file(q.column.name, renamed)); };
    return std::ranges::none_of(
        wanted, [&](const WantedTable& table) { return std::ranges::any_of(table.quantities, is_held); });
  });
  return history;
}

void judge_history(const std::string& phenomenon, const History& history, evidence::Record& record) {
  if (history.empty()) return;
  const std::vector<double>& t = history.at("t");
  for (const std::string& name : conserved_names()) {
    if (!history.contains(name)) continue;
    const std::vector<double>& values = history.at(name);
    const auto verdict = allowed(phenomenon, name);
    const auto* limits = std::get_if<Allowed>(&verdict);
    if (values.front() != 0) {
      record.measure(name + "_change", change_of(t, values, false).value());
    } else if (limits != nullptr) {
      fail("column {}: is 0 at t = {:g}, must not be: changes are relative to the first value", name, t.front());
    }
    evidence::Claim claim{"conserved-" + name,
                          limits != nullptr ? limits->text : fmt::format("The {} is conserved within its limit.", name),
                          fmt::format("largest {} of the {} over its first value",
                                      limits != nullptr && limits->growth_alone ? "growth" : "change", name),
                          "1", source};
    if (limits == nullptr) {
      record.leave_out({claim, std::get<std::string>(verdict)});
      continue;
    }
    const Largest judged = change_of(t, values, limits->growth_alone);
    record.check(claim,
                 {.value = judged.value(),
                  .resolution = fmt::format("{} rows", t.size()),
                  .where = fmt::format("t = {:g} s", judged.where())},
                 evidence::Bound{.limit = limits->limit, .reason = limits->reason});
  }
  draw(history, record);
}

}  // namespace seiche::validation
