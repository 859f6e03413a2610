#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "validation/case/case.hpp"
#include "validation/case/refusal.hpp"

namespace seiche::command {

using validation::fail;

/// What --tier names. @throws std::invalid_argument
validation::Tier tier_from(const std::string& text);

/// What stands between separators; one part without any.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// "a=1,b=2", the option repeated, taken apart. @throws std::invalid_argument naming the option
std::vector<std::pair<std::string, std::string>> split_settings(const std::string& option,
                                                                const std::vector<std::string>& texts);

/// A number, which may be infinite; one that is not. @throws std::invalid_argument naming what it is of
double number(const std::string& what, std::string_view text);
double finite_number(const std::string& what, std::string_view text);

/// Values for a case: its defaults for the tier, then the configuration file, then the settings, later ones winning.
///
/// @param config  TOML file, see apply_configuration(); empty for none
/// @throws std::invalid_argument naming file, parameter, value and range
validation::Values values_for(const validation::Case& one, validation::Tier tier, const std::filesystem::path& config,
                              const std::vector<std::string>& settings);

/// Values of a published set. @throws std::invalid_argument listing the sets, and where the settings change it
validation::Values published_values(const validation::Case& one, const std::string& set,
                                    const std::vector<std::string>& settings);

}  // namespace seiche::command
