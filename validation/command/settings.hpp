#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "validation/case/case.hpp"

namespace seiche::command {

/// "name=value" taken apart. @throws std::invalid_argument when there is no '='
std::pair<std::string, std::string> split_setting(const std::string& text);

/// Values for a case: its defaults for the tier, then the configuration file, then the settings, later ones winning.
///
/// In the file, keys at the top apply to every case, a table [CASE] to that case alone.
/// @param config  empty for none
/// @throws std::invalid_argument naming file, parameter, value and range
validation::Values values_for(const validation::Case& one, validation::Tier tier, const std::filesystem::path& config,
                              const std::vector<std::string>& settings);

}  // namespace seiche::command
