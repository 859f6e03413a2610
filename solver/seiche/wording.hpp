#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace seiche {

/// ": did you mean X?", X the one of the known words that takes the fewest single-letter edits (Levenshtein distance)
/// to get from a mistyped one, the first of several; ":" alone where that takes more than a third of its letters.
std::string did_you_mean(std::string_view mistyped, const std::vector<std::string>& known);

/// Text of strangers (names in a file, a record's words) as a terminal may show it, in one line: '?' stands for every
/// control character (C0, DEL and C1, with which escape sequences begin), for the marks that turn the direction of
/// writing, and for each byte that is no UTF-8.
std::string printable(std::string_view text);

}  // namespace seiche
