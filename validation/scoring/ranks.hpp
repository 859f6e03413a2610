/// Where an error stands among those of other solvers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace seiche::validation {

/// Of every error of the record: how many results of other solvers for its case in the folder have a larger one. Files
/// that are no records are passed over.
std::vector<std::string> ranks(const std::filesystem::path& folder, const std::string& stem);

}  // namespace seiche::validation
