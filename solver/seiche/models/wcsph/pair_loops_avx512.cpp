#include "seiche/models/wcsph/pair_loops.hpp"

#if SEICHE_PAIR_LOOPS_X86

#pragma GCC diagnostic push  // the header of GCC 12 has undefined values on purpose, and is warned of once inlined
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <immintrin.h>
#pragma GCC diagnostic pop

#ifndef __AVX512F__  // flags that have the instructions may have more, and their intrinsics are not inlined into less
#pragma GCC target("arch=x86-64-v4")
#endif

#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

struct EightLanes {
  static constexpr int width = 8;
  using Pack = __m512d;
  SEICHE_INLINE static unsigned less(Pack a, Pack b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  /// From 14 bits: a^(-1/2) = y (1-e)^(-1/2) = y (1 + e/2 + 3/8 e^2 + 5/16 e^3 + O(2^-56)), e = 1 - a y^2.
  template <int count>
  SEICHE_INLINE static SideBySide<EightLanes, count> inverse_root(const SideBySide<EightLanes, count>& a) {
    using Values = SideBySide<EightLanes, count>;
    const Values y = Values::of([&](int k) { return _mm512_rsqrt14_pd(a.at[k]); });
    const Values e = 1.0 - (a * y) * y;
    const Values rest = (0.3125 * e + 0.375) * e + 0.5;
    return (y * e) * rest + y;
  }
};

}  // namespace

const PairLoops versions::avx512[2] = {loops_of<EightLanes, CubicSpline>(), loops_of<EightLanes, WendlandC2>()};

}  // namespace seiche::wcsph

#endif
