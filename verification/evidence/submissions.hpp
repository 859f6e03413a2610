/// Tables that ask for a result, results as a solver would submit them, and what their score finds.
#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/job.hpp"
#include "validation/case/submission.hpp"
#include "validation/scoring/score.hpp"

namespace seiche::verification {

/// 0, step, 2 step, ..., last step.
inline std::vector<double> multiples(double step, int last) {
  std::vector<double> all;
  for (int k = 0; k <= last; ++k) all.push_back(step * k);
  return all;
}

/// Asks for elevations eta [m]: profiles along x [m] at times t [s], or series in t at gauges x; without `groups`, one.
inline validation::WantedTable wanted_elevation(const std::string& name, validation::WantedTable::Kind kind,
                                                std::function<double(validation::Place)> reference,
                                                std::vector<double> points, const std::vector<double>& groups = {}) {
  const validation::Column t{"t", "s", "time"}, x{"x", "m", "position"};
  const bool series = kind == validation::WantedTable::Kind::series;
  validation::WantedTable wanted{
      .name = name,
      .kind = kind,
      .abscissa = series ? t : x,
      .quantities = {{.column = {"eta", "m", "elevation"}, .reference = std::move(reference)}},
      .groups = groups};
  if (!groups.empty()) wanted.group = series ? x : t;
  if (!points.empty()) wanted.points = [points = std::move(points)](double) { return points; };
  return wanted;
}

/// A CSV file of that name.
inline io::Table file_of(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  return io::read_csv(in, name);
}

/// Everything that is asked for, at the points of the reference. @param value  double (const WantedQuantity&, Place)
template <class Value>
validation::Submitted submission(const std::vector<validation::WantedTable>& wanted, const Value& value) {
  validation::Submitted submitted;
  for (const validation::WantedTable& table : wanted) {
    for (const double group : table.groups->empty() ? std::vector<double>{0} : *table.groups) {
      validation::SubmittedGroup one{.value = group};
      if (table.points) one.abscissa = table.points(group);
      for (const validation::WantedQuantity& quantity : table.quantities) {
        for (const double at : table.points ? one.abscissa : std::vector<double>{0}) {
          one.values[quantity.column.name].push_back(value(quantity, validation::Place{group, at}));
        }
      }
      submitted[table.name].push_back(std::move(one));
    }
  }
  return submitted;
}

/// The record of a case that has scored a result.
inline evidence::Record scored(const validation::Case& one, const validation::Values& values,
                               const std::vector<validation::WantedTable>& wanted,
                               const validation::Submitted& submitted, const validation::SolverFacts& facts = {}) {
  evidence::Record record = validation::Job{&one, values}.blank_record();
  score(wanted, submitted, facts.uncertainty, record);
  if (one.submission.judge) one.submission.judge(values, submitted, facts, record);
  return record;
}

/// Of a claim: "pass"; "no such claim" where the record has none of that name.
inline std::string verdict_of(const evidence::Record& record, const std::string& id) {
  for (const evidence::JudgedClaim& claim : record.claims()) {
    if (claim.claim.id == id) return std::string(evidence::name(claim.judgement.verdict));
  }
  return "no such claim";
}

}  // namespace seiche::verification
