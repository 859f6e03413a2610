#pragma once

#include <map>
#include <string>
#include <vector>

#include "seiche/io/text_table.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// Wanted name of a column -> its name in the file, where that differs.
using ColumnNames = std::map<std::string, std::string>;

/// Name of a column or a file -> the gauge that it holds: its number or position in the wanted group column, or x:y
/// [m].
using GaugeNames = std::map<std::string, std::string>;

/// How the columns of files are to be understood, and what was made of them.
struct Understanding {
  ColumnNames renamed = {};
  GaugeNames gauges = {};
  std::vector<std::string> notes = {};  ///< sentences about what was converted, sorted, left out or taken for something
};

/// The columns of a table in the order of the template.
std::vector<Column> columns_of(const WantedTable& wanted);
/// The groups that a table asks for, and the points in one of them; 0 alone where there is no such column.
std::vector<double> groups_of(const WantedTable& wanted);
std::vector<double> points_of(const WantedTable& wanted, double group);
/// "x = 2.3 m", of a table with groups.
std::string group_in_words(const WantedTable& wanted, double group);
/// What was submitted of a table; empty where nothing was.
const std::vector<SubmittedGroup>& groups_in(const Submitted& submitted, const WantedTable& table);

/// Names that solvers give to a column that is called so here, in small letters; a name in that form.
const std::vector<std::string>& other_names(const std::string& wanted);
std::string plain_name(std::string name);
/// The number at the end of a name: "WG6", "sta_0006", "x=-2.5".
std::optional<double> number_at_end(const std::string& name);

struct NearestGroup {
  double group, apart;  ///< [m]
};
/// Of groups at places the nearest one, to a tenth of the distance between them; without y, of either, x alone counts.
std::optional<NearestGroup> nearest_group(const std::map<double, std::pair<double, double>>& places, double x,
                                          std::optional<double> y);

/// The name of a wanted column in the file; names, there, of all columns that the tables ask for.
std::string name_in_file(const std::string& wanted, const ColumnNames& renamed);
std::vector<std::string> names_in_files(const std::vector<WantedTable>& wanted, const ColumnNames& renamed);

/// 0, 1, ... so many.
std::vector<std::size_t> all_rows(std::size_t count);
/// Which rows of a series or profile count, in the order of the abscissa. Of rows at the same place the later counts. A
/// series that goes back and then on beyond where it was, was restarted: what was there from then on is replaced; rows
/// in another order are sorted.
struct RowOrder {
  std::vector<std::size_t> rows;
  std::size_t replaced = 0;
  bool sorted = false;
};
RowOrder in_order(const std::vector<double>& abscissa, const std::vector<std::size_t>& rows);

/// Finds the wanted tables in files and reads them: columns, units, order, groups, missing values.
///
/// A table is taken from the files that have one of its quantities, several of the same rows in as many files; what no
/// file has any quantity of was not submitted, and a quantity that no file has is missing in the result.
/// A column without a unit is taken to be in the wanted one, other units are converted. A group counts as the wanted
/// one when it differs from it by less than 1e-6 of the largest; where there is no group column, gauges are found by
/// their position, by numbers in the names of columns, or by that in the name of the file. Groups that are not asked
/// for are left out, those that are not there are missing in the result.
///
/// No value is NaN, what is 1e20 or more, -999, -9999 or -99999. A depth without value is 0 where the reference is less
/// than a hundredth of its largest, and an error elsewhere; so is the velocity there. Without a depth it is a gap.
///
/// @throws std::invalid_argument, in one line, naming file, line and column
Submitted submitted_from(const std::vector<io::Table>& files, const std::vector<WantedTable>& wanted,
                         Understanding& understood);

/// The tables with those quantities alone that every submitted group of them has.
std::vector<WantedTable> given_of(std::vector<WantedTable> wanted, const Submitted& submitted);

/// Whether a point lies where the group has no value between others.
bool in_gap(const SubmittedGroup& group, double x);

/// The reference of a group at points: NaN where it is unknown, and in the group's gaps.
std::vector<double> reference_at(const WantedQuantity& quantity, const SubmittedGroup& group,
                                 const std::vector<double>& x);

/// A table to be filled in, as CSV: comments that say what is asked for, the header, and a row per point.
std::string template_of(const WantedTable& wanted, const std::string& opening);

}  // namespace seiche::validation
