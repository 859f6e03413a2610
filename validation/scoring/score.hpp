#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// "0.01" in the wanted unit or "1%" relative. @throws std::invalid_argument naming the quantity
StatedUncertainty uncertainty_from(const std::string& quantity, const std::string& text);

/// Measures submitted tables by agreement(), applies the requirements, and adds measurements, tables, figures and
/// claims to the record. A wanted table that was not submitted fails its claim of coverage; its other claims are left
/// out.
///
/// A stated uncertainty u of a quantity makes that of its measures: of value, largest error and peak u; of a relative
/// norm u over the same norm of a curve of ones times the reference's (triangle inequality, errors fully correlated: an
/// upper bound); of the amplitude ratio sqrt(2) u over the reference's range; of shifts and arrivals the u stated of
/// the abscissa; of the skill 0.
/// Without a statement nothing is known of u: a plain limit judges
/// the value as it stands, a criterion of kind uncertainty is inconclusive or, beyond what any useful one explains, not
/// met.
void score(const std::vector<WantedTable>& wanted, const Submitted& submitted,
           const std::map<std::string, StatedUncertainty>& uncertainty, evidence::Record& record);

/// Says in the record that a table's requirements were not judged, and why.
void leave_out(const WantedTable& table, const std::string& reason, evidence::Record& record);

/// The same measurements of a result of our own, and the size of its cells, without claims, table and figure: so that a
/// page shows the same numbers for all solvers.
void measure_own(const std::vector<WantedTable>& wanted, const Submitted& own, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
