/// Tables of the files in a folder of results, put together.
#pragma once

#include <filesystem>
#include <functional>
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
/// Another column, the same in every row.
void add_constant(io::Table& table, const std::string& name, const std::string& unit, double value);

/// The files of a folder that are of a kind, by name; nothing of what is in folders below.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            const std::function<bool(const std::filesystem::path&)>& is_of_kind);

}  // namespace seiche::validation
