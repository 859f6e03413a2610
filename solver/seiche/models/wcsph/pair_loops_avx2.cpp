#include "seiche/models/wcsph/pair_loops.hpp"

#if SEICHE_PAIR_LOOPS_X86

#include <immintrin.h>

#ifndef __AVX2__  // flags that have the instructions may have more, and their intrinsics are not inlined into less
#pragma GCC target("arch=x86-64-v3")
#endif

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

struct FourLanes : FullLanes {
  static constexpr int width = 4;
  using Pack = __m256d;
  using Places = Pack;
  using Wide = Pack;
  SEICHE_INLINE static Pack distances(Places a, double b, double /*unit*/) { return a - b; }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return _mm256_max_pd(a, b); }
  SEICHE_INLINE static Pack positive(Pack a) { return _mm256_max_pd(a, _mm256_setzero_pd()); }
  SEICHE_INLINE static Pack negative(Pack a) { return _mm256_min_pd(a, _mm256_setzero_pd()); }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
  }
  /// `value` where a < b, 0 elsewhere.
  SEICHE_INLINE static Pack where_less(Pack a, double b, Pack value) {
    return _mm256_and_pd(_mm256_cmp_pd(a, _mm256_set1_pd(b), _CMP_LT_OQ), value);
  }
  template <int count>
  SEICHE_INLINE static SideBySide<FourLanes, count> inverse_root(const SideBySide<FourLanes, count>& a) {
    return SideBySide<FourLanes, count>::of([&](int k) { return 1.0 / _mm256_sqrt_pd(a.at[k]); });
  }
};

struct EightSingleLanes : MixedLanes {
  static constexpr int width = 8;
  using Pack = __m256;
  using Places = __m256i;
  struct Wide {
    __m256d low, high;
  };
  SEICHE_INLINE static Pack distances(Places a, std::int32_t b, float unit) {
    return _mm256_cvtepi32_ps(_mm256_sub_epi32(a, _mm256_set1_epi32(b))) * unit;
  }
  SEICHE_INLINE static void add(Wide& sum, Pack part) {
    sum.low += _mm256_cvtps_pd(_mm256_castps256_ps128(part));
    sum.high += _mm256_cvtps_pd(_mm256_extractf128_ps(part, 1));
  }
  SEICHE_INLINE static Pack narrow(double factor, const Wide& sum) {
    return _mm256_set_m128(_mm256_cvtpd_ps(factor * sum.high), _mm256_cvtpd_ps(factor * sum.low));
  }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return _mm256_max_ps(a, b); }
  SEICHE_INLINE static Pack positive(Pack a) { return _mm256_max_ps(a, _mm256_setzero_ps()); }
  SEICHE_INLINE static Pack negative(Pack a) { return _mm256_min_ps(a, _mm256_setzero_ps()); }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
  }
  SEICHE_INLINE static Pack where_less(Pack a, float b, Pack value) {
    return _mm256_and_ps(_mm256_cmp_ps(a, _mm256_set1_ps(b), _CMP_LT_OQ), value);
  }
  template <int count>
  SEICHE_INLINE static SideBySide<EightSingleLanes, count> inverse_root(const SideBySide<EightSingleLanes, count>& a) {
    return SideBySide<EightSingleLanes, count>::of([&](int k) { return 1.0F / _mm256_sqrt_ps(a.at[k]); });
  }
};

}  // namespace

const PairLoops versions::avx2 = loops_of<FourLanes, EightSingleLanes>();

}  // namespace seiche::wcsph

#endif
