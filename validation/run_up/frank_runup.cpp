#include "validation/run_up/frank_runup.hpp"
#include "validation/case/reference_table.hpp"

#include <fmt/format.h>

#include "validation/case/reference_source.hpp"

namespace seiche::validation {
namespace {

/// Entries of another table at the rows' slopes and amplitudes.
void join(std::vector<FrankRunup>& rows, const io::Table& table, const std::string& column, double FrankRunup::*to) {
  for (FrankRunup& row : rows) {
    row.*to = entry_where(table, {{"cot_slope", row.cot_slope}, {"A", row.amplitude}}, column).value_or(row.*to);
  }
}

}  // namespace

std::vector<FrankRunup> frank_runups(const Values& values) {
  const io::Table table = values.table("frank_1994_runup");
  const auto authors = reference_source("frank_1994_runup").codes.at("calc_source");
  std::vector<FrankRunup> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    FrankRunup row;
    row.cot_slope = table.column("cot_slope")[k];
    row.amplitude = table.column("A")[k];
    row.printed = table.column("R_frank_1d")[k];
    row.calculated = table.column("R_calc")[k];
    row.calculated_by = authors.at(fmt::format("{:g}", table.column("calc_source")[k]));
    row.law = table.column("R_law")[k];
    rows.push_back(std::move(row));
  }
  join(rows, values.table("frank_1994_runup_half_step"), "R_frank_1d_half", &FrankRunup::printed_half);
  join(rows, values.table("frank_1994_runup_hall_watts"), "R_HW", &FrankRunup::measured);
  return rows;
}

const std::vector<RunupVariant> runup_variants{
    {"thesis: tip V/4", "elementary", dispersive::TipMass::elementary, dispersive::Kinetics::frank},
    {"tip V/6", "consistent", dispersive::TipMass::consistent, dispersive::Kinetics::frank},
    {"tip V/6, Green-Naghdi", "green_naghdi", dispersive::TipMass::consistent, dispersive::Kinetics::green_naghdi},
};

std::vector<ComputedRunup> runup_rows(const Values& values) {
  std::vector<ComputedRunup> rows;
  for (const FrankRunup& printed : frank_runups(values)) {
    rows.push_back({printed, std::vector<std::vector<double>>(runup_variants.size())});
  }
  return rows;
}

double runup_spacing(std::size_t level) {
  return 0.25 / std::pow(2.0, static_cast<double>(level));
}

void compute_runups(std::vector<ComputedRunup>& rows, const Values& values, std::size_t variant, std::size_t level) {
  for (ComputedRunup& row : rows) {
    SolitaryClimb climb = climb_from(values, row.cot_slope, row.amplitude);
    climb.spacing = runup_spacing(level);
    climb.tip_mass = runup_variants[variant].tip_mass;
    climb.kinetics = runup_variants[variant].kinetics;
    row.computed[variant].push_back(run_up(climb).height);
  }
}

}  // namespace seiche::validation
