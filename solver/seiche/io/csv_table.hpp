#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace seiche::io {

/// A table of numbers with named columns, as in reference_data and in results to be scored.
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< one per name, all of the same length

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// @throws std::invalid_argument naming the column and those that are there
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
};

/// Reads a CSV file: comments start with '#', the first other line names the columns (a unit may follow in brackets:
/// "h [m]"), each further line holds as many finite numbers.
///
/// @throws std::invalid_argument naming file, line and column of the first thing that is wrong: no such file, binary
/// content, a line over 1 MiB, a missing, non-numeric or non-finite entry, no rows
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace seiche::io
