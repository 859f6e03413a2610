/// Where the program finds what comes with it: the reference data, the report's renderer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace seiche::validation {

/// share/seiche/<name>, in the folder above `program`'s (installed: PREFIX/bin beside PREFIX/share) or in its own
/// (built: the build tree's share/seiche holds links to the source, see ci/cmake/SeicheInstall.cmake). The program's
/// own place decides, never where it was built: an installed tree can be moved and does not read another's data.
/// @throws std::runtime_error naming both places if neither holds it
std::filesystem::path data_folder(const std::filesystem::path& program, const std::string& name);

/// The same for the program that runs.
std::filesystem::path data_folder(const std::string& name);

/// A table of the baseline (reports/record): its rows as words, without the header. Empty where it is not there.
std::vector<std::vector<std::string>> recorded_rows(const std::string& name);

/// The file of the program that runs.
std::filesystem::path running_program();

}  // namespace seiche::validation
