/// Several runs of one set-up, as turbulent or particle flows need them: their mean is judged, and their scatter is a
/// part of its uncertainty.
///
/// At every point of the first run that all runs cover, straight lines between the points of the others: the mean m and
/// the standard deviation s of n runs. The scatter of a quantity is the root mean square of s over all points, and the
/// standard uncertainty of the mean scatter/sqrt(n).
///
/// A mean is smoother than any run: fronts that arrive at different times make one that is less steep.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

struct Repeats {
  std::size_t runs = 0;
  Submitted mean;
  std::map<std::string, double> scatter;  ///< by the quantity's name, in its unit
};

/// @param runs  two or more
/// @throws std::invalid_argument for fewer, and where they do not hold the same tables, groups and quantities or have
/// fewer than two points in common
Repeats repeats_of(const std::vector<Submitted>& runs);

/// Adds the uncertainty of the mean to that which is stated of a quantity, root of the sum of squares. Where none is
/// stated, none is known: runs that agree may all be wrong by the same.
void add_scatter(const Repeats& repeats, std::map<std::string, StatedUncertainty>& uncertainty);

/// The number of runs and the scatters, as measurements.
void show_repeats(const Repeats& repeats, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
