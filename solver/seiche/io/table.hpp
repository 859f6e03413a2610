#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <vector>

namespace seiche::io {

/// Numbers in named columns, as in reference_data and in results to be scored, with where each of them was read.
struct Table {
  std::string source;                           ///< the file
  std::vector<std::string> names;               ///< all different
  std::vector<std::string> units;               ///< one per name; empty where none was stated
  std::vector<std::vector<double>> columns;     ///< one per name, all numbers finite; of equal lengths in a text file
  std::vector<long> lines;                      ///< line of each row in a text file; empty otherwise
  std::map<std::string, std::string> unusable;  ///< what is there by name but is no column of numbers, and why

  [[nodiscard]] bool has(const std::string& name) const;
  /// @throws std::invalid_argument naming file, column, and those that are there
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  [[nodiscard]] const std::string& unit(const std::string& name) const;
  /// Length of the first column.
  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// "line 12" of a text file, "element 3" (counted from 0) of a dataset.
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  [[nodiscard]] std::size_t index(const std::string& name) const;
};

/// Reads a CSV (read_csv) or an HDF5 file (hdf5_table.hpp); the content decides which, not the name.
///
/// @param wanted  datasets to be read from an HDF5 file; empty for all
/// @throws std::invalid_argument in one line that names the file and what is wrong where
Table read_table(const std::filesystem::path& file, const std::vector<std::string>& wanted = {});

/// Reads a CSV file: comments start with '#', the first other line names the columns (a unit may follow in brackets:
/// "h [m]"), each further line holds as many finite numbers. Lines end with `\n`, `\r\n` or `\r`; a byte order mark at
/// the beginning and double quotes around an entry are taken off.
///
/// No more than one line is held beside the numbers, and a line is given up at 1 MiB.
///
/// @throws std::invalid_argument, in one line, naming file, line and column of the first thing that is wrong: no such
/// file, binary content, a line over 1 MiB, a column without a name or named twice, a missing, non-numeric or
/// non-finite entry, no rows
Table read_csv(const std::filesystem::path& file);
/// The same from a stream, under the name that its errors give.
Table read_csv(std::istream& in, const std::string& name);

}  // namespace seiche::io
