#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "seiche/io/text_table.hpp"

namespace seiche::io {

/// Whether a file begins with the signature of HDF5, or has it after a user block of 512, 1024, 2048, ... bytes.
bool is_hdf5(const std::filesystem::path& file);

/// Reads datasets of numbers that have one dimension, beside others of length one; a single number counts as such. A
/// dataset is named by its path without the leading slash: "h", "run/h". Its unit is the text attribute `unit` or
/// `units`. Whatever else is there by name, or holds an infinite number, or more numbers than one file may, is listed
/// as unusable with the reason; so is what lies in another file (external storage, external links, virtual datasets).
///
/// The HDF5 library can crash on damaged files, or never end, so that it reads in a child process.
///
/// @param wanted   datasets to be read; empty for all
/// @param seconds  processor time after which a file that sends the library round in circles is given up
/// @throws std::invalid_argument, in one line, when the file cannot be opened or is damaged
Table read_hdf5(const std::filesystem::path& file, const std::vector<std::string>& wanted = {}, unsigned seconds = 10);

/// Whether every dataset carries checksums (Fletcher32), without which damage to its numbers is not seen. A file that
/// cannot be opened has none.
bool has_checksums(const std::filesystem::path& file);

/// Runs `action` in a child process of at most `seconds` of processor time, and returns the text it returns.
///
/// For libraries that may crash or spin on damaged input. The child's standard error is discarded.
///
/// @throws std::invalid_argument  with the message of the std::exception that `action` threw
/// @throws std::runtime_error     when the child crashed or ran out of time, saying which
std::string isolated(const std::function<std::string()>& action, unsigned seconds);

}  // namespace seiche::io
