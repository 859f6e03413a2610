#pragma once

#include <functional>
#include <string>

namespace seiche::io {

/// Runs `action` in a child process of at most `seconds` of processor time, and returns the text it returns.
///
/// For libraries that may crash or spin on damaged input. The child's standard error is discarded.
///
/// @throws std::invalid_argument  with the message of the std::exception that `action` threw
/// @throws std::runtime_error     when the child crashed or ran out of time, saying which
std::string isolated(const std::function<std::string()>& action, unsigned seconds);

}  // namespace seiche::io
