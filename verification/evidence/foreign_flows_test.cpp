// Right results of others pass whatever the number of points they print, wrong ones fail: the same wrong ways for every
// case that asks for curves.
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/colliding_bores.hpp"
#include "seiche/exact/macdonald.hpp"
#include "seiche/exact/steady_bump.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/scoring/score.hpp"
#include "verification/check.hpp"

namespace {

using namespace seiche;
using namespace seiche::validation;
using verification::Check;

/// What somebody submits for a quantity at a place; right is what the case says itself.
using Answer = std::function<double(const WantedTable&, std::size_t quantity, Place)>;

struct Asked {
  std::string name;      ///< of the claims
  std::string one;       ///< case
  NamedValues settings;  ///< of the case
  double cell = 0;       ///< of the solver; 0: not stated
  Answer untouched;      ///< water that is where it was at the start
  Answer late;           ///< right for a later time; empty for steady flow
  bool along_x = false;  ///< a mirrored flow is another one
};

Values values_of(const Asked& asked) {
  Values values = find_case(asked.one).values(Tier::quick);
  for (const auto& [name, value] : asked.settings) values.set(name, value);
  return values;
}

double right(const WantedTable& table, std::size_t quantity, Place place) {
  return table.quantities[quantity].reference(place);
}

/// Right for other settings of the case.
Answer at_settings(const std::string& one, const NamedValues& settings) {
  Values values = find_case(one).values(Tier::quick);
  for (const auto& [name, value] : settings) values.set(name, value);
  const std::vector<WantedTable> other = find_case(one).submission.tables(values);
  return [other](const WantedTable& table, std::size_t quantity, Place place) {
    for (const WantedTable& same : other) {
      if (same.name == table.name) return same.quantities[quantity].reference(place);
    }
    throw std::logic_error("no such table");
  };
}

/// Depth and velocity at a place, in the order of the columns.
Answer state_at(const std::function<shallow_water::State(double)>& state) {
  return [state](const WantedTable&, std::size_t quantity, Place place) {
    const shallow_water::State there = state(place.abscissa);
    return quantity == 0 ? there.depth : there.velocity;
  };
}

/// @param finer  points between two of the template's, and one
Submitted submitted(const std::vector<WantedTable>& wanted, const Answer& answer, int finer = 1) {
  Submitted all;
  for (const WantedTable& table : wanted) {
    for (const double value : table.group ? table.groups : std::vector<double>{0}) {
      SubmittedGroup group{.value = value};
      if (table.kind == WantedTable::Kind::scalars) {
        for (std::size_t q = 0; q < table.quantities.size(); ++q)
          group.values[table.quantities[q].column.name] = {answer(table, q, {value, 0})};
        all[table.name].push_back(group);
        continue;
      }
      const std::vector<double> asked = table.points(value);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        for (int part = 0; part < (i + 1 < asked.size() ? finer : 1); ++part) {
          const double x = part == 0 ? asked[i] : std::lerp(asked[i], asked[i + 1], part / double(finer));
          std::vector<double> values;
          for (std::size_t q = 0; q < table.quantities.size(); ++q) values.push_back(answer(table, q, {value, x}));
          group.abscissa.push_back(x);
          for (std::size_t q = 0; q < values.size(); ++q)
            group.values[table.quantities[q].column.name].push_back(values[q]);
        }
      }
      all[table.name].push_back(group);
    }
  }
  return all;
}

evidence::Record scored(const Asked& asked, const std::vector<WantedTable>& wanted, const Submitted& results) {
  const Case& one = find_case(asked.one);
  const Values values = values_of(asked);
  SolverFacts facts;
  if (asked.cell > 0) facts.cell = asked.cell;
  for (const WantedTable& table : wanted) {  // nothing that its uncertainty excuses
    if (table.abscissa) facts.uncertainty[table.abscissa->name] = {};
    for (const WantedQuantity& quantity : table.quantities) facts.uncertainty[quantity.column.name] = {};
  }
  evidence::Record record = Job{&one, values}.blank_record();
  score(wanted, results, facts.uncertainty, record);
  if (one.submission.judge) one.submission.judge(values, results, facts, record);
  return record;
}

bool is_velocity(const WantedQuantity& quantity) {
  return quantity.column.name == "u" || quantity.column.name == "v";
}

bool asks_for_velocity(const std::vector<WantedTable>& wanted) {
  return is_velocity(wanted.front().quantities.front()) || wanted.front().quantities.size() > 1;
}

Answer with_velocity(double factor) {
  return [factor](const WantedTable& table, std::size_t quantity, Place place) {
    return (is_velocity(table.quantities[quantity]) ? factor : 1.0) * right(table, quantity, place);
  };
}

double in_centimetres(const WantedTable& table, std::size_t quantity, Place place) {
  return 100 * right(table, quantity, place);
}

double upside_down(const WantedTable& table, std::size_t quantity, Place place) {
  return -right(table, quantity, place);
}

/// Every curve read from its other end.
double mirrored(const WantedTable& table, std::size_t quantity, Place place) {
  if (table.kind == WantedTable::Kind::scalars) return right(table, quantity, place);
  const std::vector<double> points = table.points(place.group);
  return right(table, quantity, {place.group, points.front() + points.back() - place.abscissa});
}

/// Every curve but the last is that of the next group.
double of_the_next(const WantedTable& table, std::size_t quantity, Place place) {
  if (table.kind == WantedTable::Kind::scalars) return right(table, quantity, place);
  const auto here = std::find(table.groups.begin(), table.groups.end(), place.group);
  if (here + 1 == table.groups.end()) return right(table, quantity, place);
  const std::vector<double> points = table.points(here[1]);
  return right(table, quantity, {here[1], std::clamp(place.abscissa, points.front(), points.back())});
}

/// Where the crest of a solitary wave is before the beach at the start of the measured times.
double beach_wave(double amplitude, double x) {
  const double gamma = std::sqrt(0.75 * amplitude);
  return amplitude / std::pow(std::cosh(gamma * (x - 19.85 - std::acosh(std::sqrt(20.0)) / gamma)), 2);
}

Answer beach_start(double amplitude) {
  return [amplitude](const WantedTable& table, std::size_t, Place place) {
    if (table.kind == WantedTable::Kind::scalars) return 0.0;
    return beach_wave(amplitude, table.kind == WantedTable::Kind::profile ? place.abscissa : place.group);
  };
}

/// The surface of the cosine by its arc length.
double cosine(const WantedTable&, std::size_t quantity, Place place) {
  constexpr int steps = 4000;
  const double dx = 2 * std::acos(-1.0) / steps;
  std::vector<double> s{0};
  for (int k = 0; k < steps; ++k) s.push_back(s.back() + dx * std::hypot(1.0, 0.5 * std::sin((k + 0.5) * dx)));
  const auto above = std::lower_bound(s.begin(), s.end() - 1, place.abscissa * s.back());
  const double x = dx * static_cast<double>(above - s.begin());
  return quantity == 0 ? x : 0.5 * std::cos(x);
}

Answer moved(double way) {
  return [way](const WantedTable& table, std::size_t quantity, Place place) {
    return right(table, quantity, {place.group + way, place.abscissa});
  };
}

std::vector<Asked> all_asked() {
  const exact::CollidingBores bores(9.81, 2, 1, 1.5, 30, 70);
  const exact::SteadyBump bump(9.81, 4.42, 2);
  const auto level = [bump](double surface) {
    return state_at([bump, surface](double x) { return shallow_water::State{surface - bump.elevation(x), 0}; });
  };
  const double normal = exact::MacDonald::smooth_rise(9.81).at(1000).depth;
  return {
      {"dam_break",
       "riemann",
       {},
       1,
       at_settings("riemann", {{"time", 1e-9}}),
       at_settings("riemann", {{"time", 7.0}}),
       true},
      {"bore",
       "moving_bore",
       {},
       1,
       at_settings("moving_bore", {{"steps", 1L}, {"time_step", 1e-9}}),
       at_settings("moving_bore", {{"steps", 110L}}),
       true},
      {"reflected_bore",
       "bore_reflection",
       {},
       0.1,
       at_settings("bore_reflection", {{"time", 1e-6}}),
       at_settings("bore_reflection", {{"time", 2.8}}),
       true},
      {"reflected_bore_left",
       "bore_reflection",
       {{"wall", std::string("left")}},
       0.1,
       at_settings("bore_reflection", {{"time", 1e-6}, {"wall", std::string("left")}}),
       at_settings("bore_reflection", {{"time", 2.8}, {"wall", std::string("left")}}),
       true},
      {"colliding_bores",
       "colliding_bores",
       {},
       0.5,
       state_at([bores](double x) { return bores.at(x, 0); }),
       at_settings("colliding_bores", {{"after", 2.4}}),
       true},
      {"subcritical", "steady_bump", {{"regime", std::string("subcritical")}}, 0.25, level(2), {}, true},
      {"transcritical", "steady_bump", {{"regime", std::string("transcritical")}}, 0.25, level(1.014), {}, true},
      {"jump", "steady_bump", {{"regime", std::string("jump")}}, 0.125, level(0.33), {}, true},
      // Its depth is the same from either end.
      {"channel",
       "macdonald_channel",
       {},
       5,
       state_at([normal](double) {
         return shallow_water::State{normal, 2 / normal};
       }),
       {},
       false},
      {"kinematics", "wave_kinematics", {}, 0, moved(22), moved(-0.4), true},
      {"solitary_kinematics",
       "wave_kinematics",
       {{"wave", std::string("solitary")}, {"way", 10.0}},
       0,
       moved(6),
       moved(-0.2),
       true},
      {"beach", "synolakis_beach", {}, 0, beach_start(0.019), of_the_next, true},
      {"measured_beach", "plane_beach", {}, 0, beach_start(0.0185), of_the_next, true},
      {"breaking_beach", "plane_beach", {{"wave", std::string("0.3")}}, 0, beach_start(0.3), of_the_next, true},
      {"overturning", "overturning_wave", {}, 0, cosine, of_the_next, true},
  };
}

}  // namespace

TEST_CASE("foreign flows are judged in all that is asked for", "[evidence]") {
  Check check(
      "foreign_flow_scores", "Wrong flows are told",
      "Of every case that asks others for a flow: the reference passes at the template's points and at four "
      "times as many; what never moved, is late, mirrored, upside down, without its velocity or with it turned, "
      "or in centimetres, does not. A depth that is the same from either end is not mirrored.");
  for (const Asked& asked : all_asked()) {
    const std::vector<WantedTable> wanted = find_case(asked.one).submission.tables(values_of(asked));
    const auto met = [&](const Answer& answer, int finer) {
      return scored(asked, wanted, submitted(wanted, answer, finer)).as_declared();
    };
    const auto is = [&](const std::string& way, const std::string& text, const Answer& answer, int finer,
                        bool met_too) {
      check.that({.id = asked.name + "-" + way,
                  .text = fmt::format("{}: {}", asked.one, text),
                  .quantity = "every claim is met",
                  .source = "what scoring means"},
                 {.value = met(answer, finer) ? 1.0 : 0.0},
                 evidence::Qualitative{"the record of the score", "it was made so", met_too});
    };
    is("right", "the reference passes.", right, 1, true);
    is("dense", "so it does at four times as many points.", right, 4, true);
    is("untouched", "what never moved fails.", asked.untouched, 1, false);
    if (asked.late) is("late", "what is right at another time fails.", asked.late, 1, false);
    if (asked.along_x) is("mirrored", "what is read from the other end fails.", mirrored, 1, false);
    if (asks_for_velocity(wanted) && is_velocity(wanted.front().quantities.back())) {
      is("still", "without its velocity it fails.", with_velocity(0), 1, false);
      is("turned", "with its velocity turned it fails.", with_velocity(-1), 1, false);
    }
    is("inverted", "upside down it fails.", upside_down, 1, false);
    is("centimetres", "in centimetres it fails.", in_centimetres, 1, false);
    is("untouched-dense", "what never moved fails at four times as many points.", asked.untouched, 4, false);
  }
}

TEST_CASE("too few points of a foreign flow are refused", "[evidence]") {
  for (const Asked& asked : all_asked()) {
    if (!find_case(asked.one).submission.judge || asked.one == "plane_beach") continue;
    INFO(asked.one);
    std::vector<WantedTable> wanted = find_case(asked.one).submission.tables(values_of(asked));
    const Submitted whole = submitted(wanted, right);
    Submitted few;
    for (const auto& [table, groups] : whole) {
      for (SubmittedGroup group : groups) {
        if (group.abscissa.size() > 2) {
          group.abscissa = {group.abscissa.front(), group.abscissa.back()};
          for (auto& [name, values] : group.values) values = {values.front(), values.back()};
        }
        few[table].push_back(group);
      }
    }
    CHECK_THROWS_AS(scored(asked, wanted, few), std::invalid_argument);
  }
}
