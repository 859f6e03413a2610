#pragma once

#include <string>
#include <string_view>

#include "validation/case/case.hpp"

namespace seiche::validation {

/// Sets what a TOML text says of a case: keys at the top apply to every case, a table [CASE] to that case alone.
///
/// @param name  of the file, for messages
/// @throws std::invalid_argument, in one line, naming file, line, parameter, value and range
void apply_configuration(std::string_view text, const std::string& name, const Case& one, Values& values);

}  // namespace seiche::validation
