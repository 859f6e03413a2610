/// Numbers below 2.2e-308 count as zero while an object of this class lives, in the thread that made it.
///
/// Waves over still water decay geometrically into denormal numbers, which rounding then keeps alive (0.6 of the
/// smallest one rounds to itself), and processors compute with them an order of magnitude slower.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace seiche {

class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) {
    if ((before_ & both) != both) _mm_setcsr(before_ | both);
  }
  ~FlushDenormals() {
    if ((before_ & both) != both) _mm_setcsr(before_);
  }
#else
  FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned both = 0x8040;  // results flushed to zero, and operands taken for it
  unsigned before_;
#endif
};

}  // namespace seiche
