#include "seiche/models/wcsph/pair_loops.hpp"

#if SEICHE_PAIR_LOOPS_X86

#include <immintrin.h>

#ifndef __AVX2__  // flags that have the instructions may have more, and their intrinsics are not inlined into less
#pragma GCC target("arch=x86-64-v3")
#endif

#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

struct FourLanes {
  static constexpr int width = 4;
  using Pack = __m256d;
  SEICHE_INLINE static unsigned less(Pack a, Pack b) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
  }
  template <int count>
  SEICHE_INLINE static SideBySide<FourLanes, count> inverse_root(const SideBySide<FourLanes, count>& a) {
    return SideBySide<FourLanes, count>::of([&](int k) { return 1.0 / _mm256_sqrt_pd(a.at[k]); });
  }
};

}  // namespace

const PairLoops versions::avx2[2] = {loops_of<FourLanes, CubicSpline>(), loops_of<FourLanes, WendlandC2>()};

}  // namespace seiche::wcsph

#endif
