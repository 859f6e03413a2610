#pragma once

#include <string_view>

namespace seiche::command {

/// Opens what the caller closed of standard input, output and error, so that no file of ours takes their place; and
/// makes a file that grows beyond its limit an error of the write, as a full disk is, not the end of the process.
void prepare_streams();

/// Writes "seiche: ..." to standard error, in printable characters; nothing happens where that cannot be written.
void complain(std::string_view sentence);

}  // namespace seiche::command
