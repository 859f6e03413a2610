/// Refusals with a sentence of their own, beside those of require.hpp. For sources, not for headers: it needs fmt.
#pragma once

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace seiche {

/// Throws an Error with the formatted sentence, which names the parameter, its value and what is allowed, unless the
/// condition is met. The arguments are evaluated in any case.
template <class Error = std::invalid_argument, class... Arguments>
void require_that(bool met, fmt::format_string<Arguments...> sentence, Arguments&&... arguments) {
  if (!met) throw Error(fmt::format(sentence, std::forward<Arguments>(arguments)...));
}

}  // namespace seiche
