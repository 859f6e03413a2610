/// FFTW's planner is the one part of it that two threads must not enter together.
#pragma once

#include <mutex>

namespace seiche::linear {

inline std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace seiche::linear
