/// What a submitted result looks like where it misses its reference: one sentence per curve, never applied.
#pragma once

#include <string>
#include <vector>

#include "validation/case/submission.hpp"

namespace seiche::validation {

/// Something that a reader should look at first.
struct Finding {
  std::string where;  ///< "eta, x = 2.3 m"
  std::string words;  ///< "your series fits the reference 0.3 s earlier: another origin?"
  double left = 0;    ///< of the misfit, if that were undone
};

/// Findings of a whole submission: a curve that misses its reference by what one change would explain
/// (validation/scoring/misreading.hpp), one that is that of another group, one that ends early, a number in another
/// unit. The same finding in every group is said once.
/// @param shift_fitted  the case fits a shift along the abscissa and judges it: then no fitted number is said here, as
/// a
///                      front that is late looks like one that is too short as well
std::vector<Finding> diagnosis(const std::vector<WantedTable>& wanted, const Submitted& submitted,
                               bool shift_fitted = false);

/// As a table of the record; nothing where nothing was found.
void show_diagnosis(const std::vector<Finding>& findings, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
