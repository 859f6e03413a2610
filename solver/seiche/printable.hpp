#pragma once

#include <string>
#include <string_view>

namespace seiche {

/// Text of strangers (names in a file, a record's words) as a terminal may show it, in one line: '?' stands for every
/// control character (C0, DEL and C1, with which escape sequences begin), for the marks that turn the direction of
/// writing, and for each byte that is no UTF-8.
std::string printable(std::string_view text);

}  // namespace seiche
