#pragma once

#include <map>
#include <string>
#include <vector>

#include "seiche/io/table.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// Wanted name of a column -> its name in the file, where that differs.
using ColumnNames = std::map<std::string, std::string>;

/// The columns of a table in the order of the template.
std::vector<Column> columns_of(const WantedTable& wanted);

/// Names, in the file, of all columns that the tables ask for.
std::vector<std::string> names_in_files(const std::vector<WantedTable>& wanted, const ColumnNames& renamed);

/// Finds the wanted tables in files and checks them: columns, units, lengths, order, groups.
///
/// A table is taken from the file that has one of its quantities; what no file has any quantity of was not submitted.
/// A column without a unit is taken to be in the wanted one. Rows of groups that are not asked for are left out; a
/// group counts as the wanted one when it differs from it by less than 1e-6 of the largest.
///
/// @throws std::invalid_argument, in one line, naming file, line and column
Submitted submitted_from(const std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                         const ColumnNames& renamed);

/// A table to be filled in, as CSV: comments that say what is asked for, the header, and a row per point.
std::string template_of(const WantedTable& wanted, const std::string& opening);

}  // namespace seiche::validation
