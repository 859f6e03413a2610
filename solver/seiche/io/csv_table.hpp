#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "seiche/io/table.hpp"

namespace seiche::io {

/// Reads a CSV file: comments start with '#', the first other line names the columns (a unit may follow in brackets:
/// "h [m]"), each further line holds as many finite numbers. Lines end with `\n`, `\r\n` or `\r`; a byte order mark at
/// the beginning and double quotes around an entry are taken off.
///
/// No more than one line is held beside the numbers, and a line is given up at 1 MiB.
///
/// @throws std::invalid_argument, in one line, naming file, line and column of the first thing that is wrong: no such
/// file, binary content, a line over 1 MiB, a column without a name or named twice, a missing, non-numeric or
/// non-finite entry, no rows
Table read_csv(const std::filesystem::path& file);
/// The same from a stream, under the name that its errors give.
Table read_csv(std::istream& in, const std::string& name);

}  // namespace seiche::io
