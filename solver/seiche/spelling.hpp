#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace seiche {

/// ": did you mean X?", X the one of the known words that takes the fewest single-letter edits (Levenshtein distance) to
/// get from a mistyped one, the first of several; ":" alone where that takes more than a third of its letters.
std::string did_you_mean(std::string_view mistyped, const std::vector<std::string>& known);

}  // namespace seiche
