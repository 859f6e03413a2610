// Right results of others pass whatever the number of points they print, wrong ones fail: the same wrong ways for every
// case that asks for curves.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/scoring/score.hpp"
#include "verification/check.hpp"

namespace foreign_flows_test {

using namespace seiche;
using namespace seiche::validation;
using namespace seiche::verification;

/// What somebody submits for a quantity at a place; right is what the case says itself.
using Answer = std::function<double(const WantedTable&, std::size_t quantity, Place)>;

struct Wrong {
  std::string way, text;
  Answer answer;
};

struct Asked {
  std::string name;          ///< of the claims
  std::string one;           ///< case
  NamedValues settings;      ///< of the case
  double cell = 0;           ///< of the solver; 0: not stated
  std::vector<Wrong> wrong;  ///< beside the ways that all are tried in
  Answer exact = {};         ///< right by the solution itself, and not by what the case says of it
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
    for (const double value : table.group ? *table.groups : std::vector<double>{0}) {
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

Answer times(double factor) {
  return [factor](const WantedTable& table, std::size_t quantity, Place place) {
    return factor * right(table, quantity, place);
  };
}

/// Wrong in one quantity of one table, and right in all others.
Answer only_in(const std::string& column, const Answer& wrong) {
  return [column, wrong](const WantedTable& table, std::size_t quantity, Place place) {
    return table.quantities[quantity].column.name == column ? wrong(table, quantity, place)
                                                            : right(table, quantity, place);
  };
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
  const auto here = std::find(table.groups->begin(), table.groups->end(), place.group);
  if (here + 1 == table.groups->end()) return right(table, quantity, place);
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

/// Velocities of a wave in a section at a time; nothing where there is no water.
template <class W>
Answer velocities(const W& wave, double time) {
  return [wave, time](const WantedTable&, std::size_t quantity, Place place) {
    try {
      const exact::Velocity there = wave.velocity(place.group, place.abscissa, time);
      return quantity == 0 ? there.u : there.v;
    } catch (const exact::OutsideFluid&) {
      return 0.0;
    }
  };
}

Wrong untouched(const Answer& answer) {
  return {"untouched", "what never moved fails.", answer};
}

Wrong late(const Answer& answer) {
  return {"late", "what is right at another time fails.", answer};
}

Wrong seen_from(const Answer& answer) {
  return {"mirrored", "what is seen from the other side fails.", answer};
}

/// A case whose settings say the time. @param first, later  settings of another time
Asked in_time(const std::string& name, const std::string& one, double cell, const NamedValues& settings,
              NamedValues first, NamedValues later, const Answer& exact = {}) {
  first.insert(first.end(), settings.begin(), settings.end());
  later.insert(later.end(), settings.begin(), settings.end());
  return {name,
          one,
          settings,
          cell,
          {untouched(at_settings(one, first)), late(at_settings(one, later)), seen_from(mirrored)},
          exact};
}

Asked over_bump(const std::string& regime, double cell, double discharge, double surface, std::vector<Wrong> more) {
  const exact::SteadyBump bump(9.81, 4.42, 2);  // of whatever flow: its bed
  const Answer level = state_at([=](double x) {
    const double depth = surface - bump.elevation(x);
    return shallow_water::State{depth, discharge / depth};
  });
  more.push_back(untouched(level));
  more.push_back(seen_from(mirrored));
  return {regime, "steady_bump", {{"regime", regime}}, cell, more};
}

/// The right flow, with its jump a quarter of a metre farther down.
Answer displaced_jump() {
  const exact::SteadyBump flow(9.81, 0.18, 0.33);
  return state_at([flow](double x) {
    const bool between = x > flow.jump() && x < flow.jump() + 0.25;
    return flow.at(between ? flow.jump() - 1e-9 : x);
  });
}

/// @param way  that the wave runs until it is asked for. @param later  a way that should be told from it
template <class W>
Asked below(const std::string& name, const W& wave, double speed, double way, double later, const std::string& choice) {
  const double time = way / speed;
  return {name,
          "wave_kinematics",
          {{"wave", choice}, {"way", way}},
          0,
          {untouched(velocities(wave, 0)), late(velocities(wave, later / speed)), seen_from(only_in("v", times(-1)))},
          velocities(wave, time)};
}

/// Amplitudes and angles without a stem, where the waves only cross.
double regular_reflection(const WantedTable&, std::size_t quantity, Place) {
  return std::array{2.0, 1.0, 20.0, 0.0, 0.0}.at(quantity);
}

/// Run-up where it does not break, on a slope of 20 degrees.
double synolakis_law(const WantedTable&, std::size_t, Place place) {
  return 2.831 * std::sqrt(2.747) * std::pow(place.group, 1.25);
}

std::vector<Asked> all_asked() {
  const exact::CollidingBores bores(9.81, 2, 1, 1.5, 30, 70);
  const double normal = exact::MacDonald::smooth_rise(9.81).at(1000).depth;
  const auto reflection = exact::BoreReflection::from_depths(9.81, 0.6343140641800991, 1, 5, 10);
  const exact::StokesWave stokes(0.15, 8, 1, 9.81);
  const exact::SolitaryWave solitary(0.3, 1, 9.81);
  return {
      in_time("dam_break", "riemann", 0.125, {{"particles", 400L}}, {{"time", 1e-9}}, {{"time", 5.4}}),
      in_time("bore", "moving_bore", 1, {}, {{"steps", 1L}, {"time_step", 1e-9}}, {{"steps", 110L}}),
      in_time("reflected_bore", "bore_reflection", 0.1, {}, {{"time", 1e-6}}, {{"time", 2.8}},
              state_at([reflection](double x) { return reflection.at(x, 2.6); })),
      in_time("reflected_bore_left", "bore_reflection", 0.1, {{"wall", std::string("left")}}, {{"time", 1e-6}},
              {{"time", 2.8}}),
      {"colliding_bores",
       "colliding_bores",
       {},
       0.5,
       {untouched(state_at([bores](double x) { return bores.at(x, 0); })),
        late(at_settings("colliding_bores", {{"after", 2.4}})), seen_from(mirrored)},
       state_at([bores](double x) { return bores.at(x, bores.collision_time() + 2); })},
      over_bump("subcritical", 0.25, 4.42, 2, {}),
      over_bump("transcritical", 0.25, 1.53, 1.014, {}),
      over_bump("jump", 0.125, 0.18, 0.33,
                {{"displaced", "with its jump a quarter of a metre off it fails.", displaced_jump()}}),
      // Its depth is the same from either end.
      {"channel", "macdonald_channel", {}, 5, {untouched(state_at([normal](double) {
         return shallow_water::State{normal, 2 / normal};
       }))}},
      below("kinematics", stokes, stokes.phase_speed(), 22, 22.4, "stokes"),
      below("solitary_kinematics", solitary, solitary.speed(), 10, 10.2, "solitary"),
      {"beach", "synolakis_beach", {}, 0, {untouched(beach_start(0.019)), late(of_the_next), seen_from(mirrored)}},
      {"measured_beach",
       "plane_beach",
       {},
       0,
       {untouched(beach_start(0.0185)), late(of_the_next), seen_from(mirrored)}},
      {"breaking_beach",
       "plane_beach",
       {{"wave", std::string("0.3")}},
       0,
       {untouched(beach_start(0.3)), late(of_the_next), seen_from(mirrored)}},
      {"overturning", "overturning_wave", {}, 0, {untouched(cosine), late(of_the_next), seen_from(mirrored)}},
      {"mach",
       "mach_reflection_theory",
       {},
       0,
       {{"regular", "regular reflection fails.", regular_reflection},
        {"growing", "a stem that still grows fails.",
         only_in("growth", [](const WantedTable&, std::size_t, Place) { return 0.02; })}}},
      {"hall_watts", "hall_watts_run_up", {}, 0, {{"law", "the law of gentle beaches fails.", synolakis_law}}},
  };
}

TEST_CASE("foreign flows are judged in all that is asked for", "[evidence]") {
  Check check("foreign_flow_scores", "Wrong flows are detected",
              "Of every case that asks others for a flow: the reference passes at the template's points and at four "
              "times as many; what never moved, is late or seen from the other side does not, and neither does what is "
              "zero, turned or in centimetres in a single one of its quantities.");
  for (const Asked& asked : all_asked()) {
    const std::vector<WantedTable> wanted = find_case(asked.one).submission.tables(values_of(asked));
    const auto is = [&](const std::string& text, const Answer& answer, int finer, bool met) {
      const evidence::Record record = scored(asked, wanted, submitted(wanted, answer, finer));
      check.holds(fmt::format("A submission to {}: {}", asked.one, text), {record.as_declared() ? 1.0 : 0.0},
                  Qualitative{"the record of the score", "it was made so", met});
    };
    is("the reference passes.", right, 1, true);
    if (asked.exact) is("the exact solution passes.", asked.exact, 1, true);
    is("the reference at four times as many points passes.", right, 4, true);
    for (const Wrong& wrong : asked.wrong) {
      is(wrong.text, wrong.answer, 1, false);
      is("the reference at four times as many points passes.", wrong.answer, 4, false);
    }
    for (const WantedTable& table : wanted) {
      for (const WantedQuantity& quantity : table.quantities) {
        const std::string& column = quantity.column.name;
        if (column == "growth") continue;  // zero is right
        is(fmt::format("with {} zero it fails.", column), only_in(column, times(0)), 1, false);
        is(fmt::format("with {} turned it fails.", column), only_in(column, times(-1)), 1, false);
        is(fmt::format("with {} in centimetres it fails.", column), only_in(column, times(100)), 1, false);
      }
    }
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

TEST_CASE("a periodic wave is not asked for where one that never moved is right", "[evidence]") {
  Values values = find_case("wave_kinematics").values(Tier::quick);
  for (const double way : {16.0, 16.7, 23.3}) {
    INFO(way);
    values.set("way", way);
    CHECK_THROWS_AS(find_case("wave_kinematics").submission.tables(values), std::invalid_argument);
  }
}

}  // namespace foreign_flows_test
