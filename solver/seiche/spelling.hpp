#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace seiche {

/// The one of the known words that takes the fewest single-letter edits (Levenshtein distance) to get from a mistyped
/// one; the first of several. `known` must not be empty.
std::string nearest_spelling(std::string_view mistyped, const std::vector<std::string>& known);

}  // namespace seiche
