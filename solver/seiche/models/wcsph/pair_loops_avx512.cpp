#include "seiche/models/wcsph/pair_loops.hpp"

#if SEICHE_PAIR_LOOPS_X86

#include <immintrin.h>

#ifndef __AVX512F__  // flags that have the instructions may have more, and their intrinsics are not inlined into less
#pragma GCC target("arch=x86-64-v4")
#endif

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

struct EightLanes : FullLanes {
  static constexpr int width = 8;
  using Pack = __m512d;
  using Places = Pack;
  using Wide = Pack;
  SEICHE_INLINE static Pack distances(Places a, double b, double /*unit*/) { return a - b; }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return _mm512_max_pd(a, b); }
  SEICHE_INLINE static Pack positive(Pack a) { return _mm512_max_pd(a, _mm512_setzero_pd()); }
  SEICHE_INLINE static Pack negative(Pack a) { return _mm512_min_pd(a, _mm512_setzero_pd()); }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  /// `value` where a < b, 0 elsewhere.
  SEICHE_INLINE static Pack where_less(Pack a, double b, Pack value) {
    return _mm512_maskz_mov_pd(_mm512_cmp_pd_mask(a, _mm512_set1_pd(b), _CMP_LT_OQ), value);
  }
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

struct SixteenLanes : MixedLanes {
  static constexpr int width = 16;
  using Pack = __m512;
  using Places = __m512i;
  struct Wide {
    __m512d low, high;
  };
  SEICHE_INLINE static Pack distances(Places a, std::int32_t b, float unit) {
    return _mm512_cvtepi32_ps(_mm512_sub_epi32(a, _mm512_set1_epi32(b))) * unit;
  }
  SEICHE_INLINE static void add(Wide& sum, Pack part) {
    sum.low += _mm512_cvtps_pd(_mm512_castps512_ps256(part));
    sum.high += _mm512_cvtps_pd(_mm512_extractf32x8_ps(part, 1));
  }
  SEICHE_INLINE static Pack narrow(double factor, const Wide& sum) {
    return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(factor * sum.low)),
                              _mm512_cvtpd_ps(factor * sum.high), 1);
  }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return _mm512_max_ps(a, b); }
  SEICHE_INLINE static Pack positive(Pack a) { return _mm512_max_ps(a, _mm512_setzero_ps()); }
  SEICHE_INLINE static Pack negative(Pack a) { return _mm512_min_ps(a, _mm512_setzero_ps()); }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  SEICHE_INLINE static Pack where_less(Pack a, float b, Pack value) {
    return _mm512_maskz_mov_ps(_mm512_cmp_ps_mask(a, _mm512_set1_ps(b), _CMP_LT_OQ), value);
  }
  /// From 14 bits by one step of Newton's.
  template <int count>
  SEICHE_INLINE static SideBySide<SixteenLanes, count> inverse_root(const SideBySide<SixteenLanes, count>& a) {
    using Values = SideBySide<SixteenLanes, count>;
    const Values y = Values::of([&](int k) { return _mm512_rsqrt14_ps(a.at[k]); });
    const Values e = 1.0 - (a * y) * y;
    return 0.5 * (y * e) + y;
  }
};

}  // namespace

const PairLoops versions::avx512 = loops_of<EightLanes, SixteenLanes>();

}  // namespace seiche::wcsph

#endif
