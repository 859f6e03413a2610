#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// Reads reference_data/<source>/table.csv and notes its path and SHA-256 in `read`, which belongs to a record.
///
/// @throws std::runtime_error when the table is not the one whose SHA-256 source.toml states
io::Table reference_table(const std::string& source, std::map<std::string, std::string>& read);

/// The row of a table whose columns have these numbers, to 1e-9; none where no row has them.
std::optional<std::size_t> row_where(const io::Table& table, const std::map<std::string, double>& numbers);
/// Its number in a column.
/// All rows that have these numbers.
io::Table rows_where(const io::Table& table, const std::map<std::string, double>& numbers);
std::optional<double> entry_where(const io::Table& table, const std::map<std::string, double>& numbers,
                                  const std::string& column);

}  // namespace seiche::validation
