/// The first screen of a score: what came out, where the error is and of what kind, whose it is, what to do next.
///
/// Where the error is: of the submitted curve that misses its reference by most, e = s - r at the reference's points,
/// the point of the largest |e| and the share of sum e^2 within a tenth of the range about it. Of what kind: the share
/// of sum e^2 that one number would take away,
///
///     level      (sum e)^2/n           amplitude  (sum e q)^2/sum q^2,  q = r - mean r
///     phase      (sum e r')^2/sum r'^2,  r' the slope of r,
///
/// each alone; more than half names the kind, less for all is an error of shape.
///
/// Whose it is: an exact reference leaves the solver and its set-up, and a ladder of sizes tells them apart. Against
/// measured data it is the solver's where |E| exceeds the uncertainties of both together (ASME V&V 20), and nobody
/// knows where they are too large or one is not stated.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/instruments/agreement.hpp"
#include "validation/scoring/diagnosis.hpp"
#include "validation/scoring/ladder.hpp"

namespace seiche::validation {

struct ErrorKind {
  double level = 0, amplitude = 0, phase = 0;  ///< shares of sum e^2, each alone
  double where = 0;                            ///< abscissa of the largest |e|
  double largest = 0;                          ///< e there, with its sign
  double near = 0;                             ///< share of sum e^2 within a tenth of the range about it

  /// "phase: 82 % of it", "shape: no level, amplitude or phase explains half of it".
  [[nodiscard]] std::string words() const;
};

/// @throws std::invalid_argument where the submitted curve covers none of the reference
ErrorKind error_kind(Curve submitted, Curve reference);

/// Question and answer, in the order in which they are read.
using FirstLook = std::vector<std::pair<std::string, std::string>>;

/// @param record  judged
/// @param ladder  where there is one
FirstLook first_look(const std::vector<WantedTable>& wanted, const Submitted& submitted, const evidence::Record& record,
                     const std::vector<Finding>& findings, const std::optional<Ladder>& ladder);

/// As the table `first-look` of the record, which a page shows before anything else.
void show_first_look(const FirstLook& look, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
