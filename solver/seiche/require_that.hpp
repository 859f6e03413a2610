/// Refusals with a sentence of their own, beside those of require.hpp. For sources, not for headers: it needs fmt.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace seiche {

/// Throws an Error with the formatted sentence, which names the parameter, its value and what is allowed, unless the
/// condition is met. The arguments are evaluated in any case.
template <class Error = std::invalid_argument, class... Arguments>
void require_that(bool met, fmt::format_string<Arguments...> sentence, Arguments&&... arguments) {
  if (!met) throw Error(fmt::format(sentence, std::forward<Arguments>(arguments)...));
}

/// What a parameter's word stands for. Throws std::invalid_argument that lists the words there are.
template <class Value>
Value value_named(std::string_view parameter, std::string_view word,
                  std::initializer_list<std::pair<std::string_view, Value>> all) {
  std::string words;
  for (const auto& [known, value] : all) {
    if (known == word) return value;
    words.append(words.empty() ? "" : ", ").append(known);
  }
  throw std::invalid_argument(fmt::format("{} = \"{}\"; allowed: {}", parameter, word, words));
}

}  // namespace seiche
