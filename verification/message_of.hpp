/// What an exception says.
#pragma once

#include <stdexcept>
#include <string>

namespace seiche::verification {

/// Of what an action throws; empty where it throws none of that kind.
template <class Failure = std::invalid_argument, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Failure& failure) {
    return failure.what();
  }
  return {};
}

}  // namespace seiche::verification
