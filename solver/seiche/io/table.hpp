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
  std::vector<std::vector<double>> columns;     ///< one per name, NaN for no value; of equal lengths in a text file
  std::vector<long> lines;                      ///< line of each row in a text file; empty otherwise
  std::map<std::string, std::string> unusable;  ///< what is there by name but is no column of numbers, and why

  [[nodiscard]] bool has(const std::string& name) const;
  /// @throws std::invalid_argument naming file, column, and those that are there
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const { return columns[index(name)]; }
  [[nodiscard]] const std::string& unit(const std::string& name) const { return units[index(name)]; }
  /// Length of the first column.
  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// "line 12" of a text file, "element 3" (counted from 0) of a dataset.
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  [[nodiscard]] std::size_t index(const std::string& name) const;
};

/// Reads a text (text_table.hpp) or an HDF5 file (hdf5_table.hpp); the content decides which, not the name.
///
/// @param wanted  datasets to be read from an HDF5 file; empty for all
/// @throws std::invalid_argument in one line that names the file and what is wrong where
Table read_table(const std::filesystem::path& file, const std::vector<std::string>& wanted = {});

/// Reads a text file (text_table.hpp) that has a finite number in every place, as those of reference_data.
Table read_csv(const std::filesystem::path& file);
/// The same from a stream, under the name that its errors give.
Table read_csv(std::istream& in, const std::string& name);

}  // namespace seiche::io
