/// How input is refused.
#pragma once

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace seiche::validation {

/// Throws std::invalid_argument with a sentence, written as for fmt::format.
template <class... Words>
[[noreturn]] void fail(fmt::format_string<Words...> sentence, Words&&... words) {
  throw std::invalid_argument(fmt::format(sentence, std::forward<Words>(words)...));
}

}  // namespace seiche::validation
