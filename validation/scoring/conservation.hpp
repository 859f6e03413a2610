/// Histories of volume, energy and momentum in a submission, judged for every case that scores others.
///
/// A file with a column `t` and any of `volume`, `energy`, `momentum` is a history; each in whatever unit, for what is
/// judged is the change since the first row, over the first value. Energy is that of the motion, kinetic and potential,
/// counted from still water (a column of water: from the floor).
///
/// - Volume may change by 0.001 where no water runs through: the level sinks by that share of the depth, what a gauge
///   can still tell.
/// - Energy may change by 0.1 where waves neither break nor are driven: heights go as its root, and benchmarks of
///   tsunamis allow 5 per cent of a height. Where water breaks, jumps or rubs it may not grow by more than 0.01.
/// - Momentum may change by 0.1 where there are no walls and slopes: a wave's is its energy over the celerity.
///
/// What is not judged is left out, with the reason.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/scoring/submitted.hpp"

namespace seiche::validation {

/// Columns of a history by their names above, `t` among them; of all the same length.
using History = std::map<std::string, std::vector<double>>;

/// The names of what may be judged: volume, energy, momentum.
const std::vector<std::string>& conserved_names();

/// Names, in the files, of `t` and of what is conserved, without those that a table of the case asks for.
std::vector<std::string> history_names(const std::vector<WantedTable>& wanted, const ColumnNames& renamed);

/// Takes the history out of files that the case's own tables leave alone; empty where there is none.
/// @throws std::invalid_argument naming file and column: two histories, fewer than two rows
History take_history(std::vector<io::Table>& files, const std::vector<WantedTable>& wanted, const ColumnNames& renamed);

/// Claims `conserved-volume` and so on of what the history holds, a figure, and measurements.
/// @param phenomenon  of the case: what its water conserves
void judge_history(const std::string& phenomenon, const History& history, evidence::Record& record);

}  // namespace seiche::validation
