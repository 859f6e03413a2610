#pragma once

#include <map>
#include <string>

#include "seiche/io/text_table.hpp"

namespace seiche::validation {

/// Reads reference_data/<source>/table.csv and notes its path and SHA-256 in `read`, which belongs to a record.
///
/// @throws std::runtime_error when the table is not the one whose SHA-256 source.toml states
io::Table reference_table(const std::string& source, std::map<std::string, std::string>& read);

}  // namespace seiche::validation
