/// Lines, words and numbers of the text files that solvers write; every complaint names file and line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seiche/io/table.hpp"

namespace seiche::validation {

/// A text file, line by line, without ends of lines and a byte order mark.
struct Text {
  std::string file;
  std::vector<std::string> lines;

  /// @throws std::invalid_argument "file: line 1: what" for index 0
  [[noreturn]] void fail(std::size_t index, const std::string& what) const;
};

/// @throws std::invalid_argument for what is no file, or not text
Text text_of(const std::filesystem::path& path);
/// The lines within the first four kilobytes, of whatever content.
Text opening_of(const std::filesystem::path& path);

/// Words between any of the separators; of blanks several count as one.
std::vector<std::string> words_of(const std::string& line, const std::string& separators);
/// Entries between single separators, blanks around them taken off.
std::vector<std::string> entries_of(const std::string& line, char separator);

/// None where the whole entry is not one finite number.
std::optional<double> number_in(std::string_view entry);
bool has_decimal_comma(const std::string& entry);
double number_at(const Text& text, std::size_t line, const std::string& entry, const std::string& column);
/// Numbers of a line from the given word on.
std::vector<double> numbers_of(const Text& text, std::size_t line, const std::vector<std::string>& words,
                               std::size_t from);
/// The numbers within the first brackets of a line: "location=( 0.5 1 )".
std::vector<double> bracketed(const Text& text, std::size_t line);

/// Blank, or beginning with #, % or //.
bool is_comment(const std::string& line);

/// Rows as they come, each with its line; turned into columns at the end.
class Rows {
 public:
  Rows(const Text& text, std::vector<std::string> names, std::vector<std::string> units = {});
  void add(std::size_t line, const std::vector<double>& row);
  /// @throws std::invalid_argument where there are none
  [[nodiscard]] io::Table table() const;

 private:
  io::Table table_;
};

/// What a folder of results holds.
struct FolderTables {
  std::string format;
  bool series = false;  ///< of times, which a restart may repeat
  std::vector<io::Table> tables = {};
  std::vector<std::filesystem::path> files = {};  ///< that were read
};

/// Tables with the same x, y, z and t become one, their other columns beside each other.
std::vector<io::Table> merged(const std::vector<io::Table>& parts);
/// The rows of another table with the same columns below those of this one.
void put_below(io::Table& table, const io::Table& more);

}  // namespace seiche::validation
