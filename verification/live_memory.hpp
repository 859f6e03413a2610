/// How much memory a program holds, for tests and benchmarks of what a model needs.
#pragma once

#include <malloc.h>

namespace seiche::verification {

/// Bytes allocated and not freed, by all threads; 0 in programs with a sanitizer, which have another allocator.
inline double live_bytes() {
  const struct mallinfo2 held = mallinfo2();
  return static_cast<double>(held.uordblks) + static_cast<double>(held.hblkhd);
}

}  // namespace seiche::verification
