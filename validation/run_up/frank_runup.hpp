/// Frank's run-up table (1994, chapter 3): its printed columns, joined from the reference tables, and columns computed
/// by variants of the one-dimensional discrete model.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation {

/// The printed measurement at cot 3.732, A = 0.05 is out of line with its neighbours: a misprint, see the table's
/// source.
inline constexpr double misprinted_runup = 0.173;

/// A row: depth and gravity are 1; NaN where the table has no entry.
struct FrankRunup {
  double cot_slope = 0;
  double amplitude = 0;
  double printed = 0;                                              ///< the thesis's one-dimensional model
  double printed_half = std::numeric_limits<double>::quiet_NaN();  ///< the same with both steps halved
  double calculated = 0;                                           ///< by other authors
  std::string calculated_by;                                       ///< who
  double law = 0;                                                  ///< run-up law, as printed
  double measured = std::numeric_limits<double>::quiet_NaN();      ///< by Hall and Watts
};

/// All rows, in the printed order.
std::vector<FrankRunup> frank_runups(const Values& values);

/// The model in three variants, each with a sequence of spacings, halved from 1/4 on.
struct RunupVariant {
  std::string label;
  std::string id;
  dispersive::TipMass tip_mass;
  dispersive::Kinetics kinetics;
};
extern const std::vector<RunupVariant> runup_variants;
enum { as_in_thesis, consistent, green_naghdi };  ///< indices of variants

struct ComputedRunup : FrankRunup {
  std::vector<std::vector<double>> computed;  ///< [variant][level]
};

std::vector<ComputedRunup> runup_rows(const Values& values);
double runup_spacing(std::size_t level);
/// Appends a level to all rows of a variant, with the steps that the values say.
void compute_runups(std::vector<ComputedRunup>& rows, const Values& values, std::size_t variant, std::size_t level);

}  // namespace seiche::validation
