/// Tables of numbers in text files, as people and programs write them.
///
/// - Entries are separated by semicolons, tabs, commas or blanks: whatever makes numbers of the first two lines that
///   hold nothing else. Lines end with `\n`, `\r\n` or `\r`; the encoding is UTF-8, any of eight bits, or UTF-16 with
///   its byte order mark.
/// - Any lines may come before the numbers. The columns are named by the last line with as many entries that is not
///   itself of numbers, whether it is a comment (#, %, !, //) or not; a unit follows in brackets, "h [m]", "h(m)", or
///   in a line of its own. The header may be repeated further down.
/// - Numbers may have a decimal comma where commas do not separate, Fortran's exponents (1.5D-3, 1.5-103) and signs.
///   No value is nan, NA, null, -, asterisks, or nothing between two separators: NaN in the table.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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

/// A text file, line by line, without ends of lines and a byte order mark.
struct Text {
  std::string file;
  std::vector<std::string> lines;

  /// @throws std::invalid_argument "file: line 1: what" for index 0
  [[noreturn]] void fail(std::size_t index, std::string what) const;
};

/// @param most  bytes to be read; content beyond is left out, whatever it is
/// @throws std::invalid_argument for what is no file, not text, has a line over 1 MiB or more than 1 GiB
Text text_of(const std::filesystem::path& path, std::size_t most = std::string::npos);
Text text_of(std::istream& in, const std::string& name, std::size_t most = std::string::npos);

/// Words between any of the separators; of blanks several count as one.
std::vector<std::string> words_of(const std::string& line, const std::string& separators = " \t");
/// Entries between single separators, blanks and quotes around them taken off.
std::vector<std::string> entries_of(const std::string& line, char separator);
/// Blank, or beginning with #, %, ! or //.
bool is_comment(const std::string& line);

/// None where the whole entry is not one finite number.
std::optional<double> number_in(std::string_view entry);
/// The same, and NaN for what stands for no value.
std::optional<double> value_in(std::string_view entry);
/// Values of all words. @throws std::invalid_argument
std::vector<double> values_of(const Text& text, std::size_t line, const std::vector<std::string>& words);

/// Rows as they come, each with its line; turned into columns at the end.
class Rows {
 public:
  /// @param columns  names, each with its unit in brackets where it is known: "h [m]"
  Rows(const Text& text, const std::vector<std::string>& columns);
  /// @throws std::invalid_argument where the row has another number of entries than the columns
  void add(std::size_t line, const std::vector<double>& row);
  /// @throws std::invalid_argument where there are none
  [[nodiscard]] Table table() const;

 private:
  const Text& text_;
  Table table_;
};

/// Columns of a file that names none, by how many there are; empty where that says nothing.
using UsualColumns = std::function<std::vector<std::string>(std::size_t)>;

/// @param columns  names instead of those of the file
/// @throws std::invalid_argument, in one line, naming file, line and column of the first thing that is wrong
Table read_text_table(const Text& text, const std::vector<std::string>& columns = {}, const UsualColumns& usual = {});

}  // namespace seiche::io
