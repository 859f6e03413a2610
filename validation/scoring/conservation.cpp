#include "validation/scoring/conservation.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "seiche/samples.hpp"
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

bool one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

/// What is allowed, or why nothing is judged.
std::variant<Allowed, std::string> allowed(const std::string& phenomenon, const std::string& quantity) {
  if (quantity == "volume") {
    if (phenomenon == "steady_flow" || phenomenon == "hydraulic_jump") return "water enters and leaves";
    return Allowed{0.001, false, "The water volume is conserved within 0.1 % at every time.",
                   "0.1 % of the volume is 0.1 % of the depth: 1 mm in 1 m, the resolution of a gauge"};
  }
  if (one_of(phenomenon, {"wavemaker", "moving_pressure"})) return "external forcing does work on the water";
  if (phenomenon == "steady_flow" || phenomenon == "hydraulic_jump") return "water enters and leaves";
  const bool free = one_of(phenomenon, {"standing_wave", "periodic_wave", "solitary_wave", "basin", "drop"});
  if (quantity == "energy") {
    if (free) {
      return Allowed{0.1, false, "The energy is conserved within 10 %, equivalent to 5 % of a height.",
                     "height is proportional to the square root of energy: the 5 % of height that tsunami benchmarks "
                     "allow are 10 % of energy"};
    }
    return Allowed{0.01, true, "The energy does not grow by more than 1 %.",
                   "breaking, jumps and friction only dissipate; at a hundred cells per length, 1 % is one cell"};
  }
  if (!one_of(phenomenon, {"periodic_wave", "drop"})) return "walls and slopes exert forces on the water";
  return Allowed{0.1, false, "The momentum is conserved within 10 %, equivalent to 5 % of a height.",
                 "wave momentum is energy over celerity: 5 % of height are 10 %"};
}

bool asked_for(const std::vector<WantedTable>& wanted, const std::string& name) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const WantedTable& table) {
    return std::any_of(table.quantities.begin(), table.quantities.end(),
                       [&](const WantedQuantity& q) { return q.column.name == name; });
  });
}

std::string name_in_file(const std::string& name, const ColumnNames& renamed) {
  const auto found = renamed.find(name);
  return found == renamed.end() ? name : found->second;
}

struct Change {
  double largest, at;  ///< over the first value, growth or magnitude; when
};

Change change_of(const std::vector<double>& t, const std::vector<double>& values, bool growth_alone) {
  const double first = values.front();
  Largest largest;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double change = (values[k] - first) / std::abs(first);
    largest.add(growth_alone ? change : std::abs(change), t[k]);
  }
  return {largest.value(), largest.where()};
}

void draw(const History& history, evidence::Record& record) {
  const auto shown = [&](const std::string& name) { return history.contains(name) && history.at(name).front() != 0; };
  if (std::none_of(conserved_names().begin(), conserved_names().end(), shown)) return;
  auto& panel = record
                    .figure("conservation", "Volume, energy and momentum",
                            "Change since the first row, over the first value, as submitted.")
                    .panel({.x = "t [s]", .y = "relative change"});
  const std::vector<double>& t = history.at("t");
  for (const std::string& name : conserved_names()) {
    if (!shown(name)) continue;
    const std::vector<double> change =
        each(history.at(name), [&](const double value) { return value / history.at(name).front() - 1; });
    panel.line(name, t, change);
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
  for (auto file = files.begin(); file != files.end();) {
    const auto holds = [&](const std::string& name) { return file->has(name_in_file(name, renamed)); };
    std::vector<std::string> names;
    for (const std::string& name : conserved_names()) {
      if (!asked_for(wanted, name) && holds(name)) names.push_back(name);
    }
    if (names.empty()) {
      ++file;
      continue;
    }
    if (!holder.empty()) {
      throw std::invalid_argument(fmt::format("{}: holds a history, which {} holds as well", file->source, holder));
    }
    holder = file->source;
    const std::vector<double>& t = file->column(name_in_file("t", renamed));
    std::vector<std::size_t> rows(t.size());
    std::iota(rows.begin(), rows.end(), 0);
    rows = in_order(t, rows).rows;
    if (rows.size() < 2)
      throw std::invalid_argument(fmt::format("{}: {} rows, must be at least two", holder, rows.size()));
    names.emplace_back("t");
    for (const std::string& name : names) {
      const std::vector<double>& values = file->column(name_in_file(name, renamed));
      if (values.size() != t.size()) {
        throw std::invalid_argument(fmt::format("{}: column {}: {} values, must be as many as in column t: {}", holder,
                                                name, values.size(), t.size()));
      }
      for (const std::size_t row : rows) {
        if (std::isnan(values[row]))
          throw std::invalid_argument(fmt::format("{}: {}: column {}: no value", holder, file->place(row), name));
        history[name].push_back(values[row]);
      }
    }
    const bool also_wanted = std::any_of(wanted.begin(), wanted.end(), [&](const WantedTable& table) {
      return std::any_of(table.quantities.begin(), table.quantities.end(),
                         [&](const WantedQuantity& q) { return holds(q.column.name); });
    });
    file = also_wanted ? file + 1 : files.erase(file);
  }
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
      record.measure(name + "_change", change_of(t, values, false).largest);
    } else if (limits != nullptr) {
      throw std::invalid_argument(fmt::format(
          "column {}: is 0 at t = {:g}, must not be: changes are relative to the first value", name, t.front()));
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
    const Change judged = change_of(t, values, limits->growth_alone);
    record.check(claim,
                 {.value = judged.largest,
                  .resolution = fmt::format("{} rows", t.size()),
                  .where = fmt::format("t = {:g} s", judged.at)},
                 evidence::Bound{.limit = limits->limit, .reason = limits->reason});
  }
  draw(history, record);
}

}  // namespace seiche::validation
