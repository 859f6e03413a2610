#pragma once

#include <string>

#include "reports/evidence/record.hpp"
#include "seiche/io/csv_table.hpp"

namespace seiche::validation {

/// Reads reference_data/<source>/table.csv and notes its SHA-256 in the record.
///
/// @throws std::runtime_error when the table is not the one whose SHA-256 source.toml states
io::Table reference_table(const std::string& source, evidence::Record& record);

}  // namespace seiche::validation
