/// Tables of the files in a folder of results, put together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// What a folder of results holds.
struct FolderTables {
  std::string format;
  std::vector<io::Table> tables = {};
  std::vector<std::filesystem::path> files = {};  ///< that were read
};

/// Tables with the same x, y, z and t become one, their other columns beside each other.
std::vector<io::Table> merged(const std::vector<io::Table>& parts);
/// The rows of another table with the same columns below those of this one.
void put_below(io::Table& table, const io::Table& more);

}  // namespace seiche::validation
