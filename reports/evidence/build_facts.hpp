#pragma once

#include <string_view>

/// Facts known when the program is built; defined in files that the build generates.
namespace seiche::build_facts {

extern const std::string_view version;
extern const std::string_view commit;
extern const bool dirty;
extern const std::string_view compiler;
extern const std::string_view flags;
extern const std::string_view build_type;
extern const std::string_view catch2_version;

}  // namespace seiche::build_facts
