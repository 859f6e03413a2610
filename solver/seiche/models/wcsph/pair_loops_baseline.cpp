#include <cmath>

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

/// Any machine whose compiler knows the vector types of GCC.
struct TwoLanes : FullLanes {
  static constexpr int width = 2;
  using Pack [[gnu::vector_size(16)]] = double;
  using Places = Pack;
  using Wide = Pack;
  SEICHE_INLINE static Pack distances(Places a, double b, double /*unit*/) { return a - b; }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return a > b ? a : b; }
  SEICHE_INLINE static Pack positive(Pack a) { return a > 0.0 ? a : Pack{}; }
  SEICHE_INLINE static Pack negative(Pack a) { return a < 0.0 ? a : Pack{}; }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) { return (a[0] < b[0] ? 1U : 0U) | (a[1] < b[1] ? 2U : 0U); }
  /// `value` where a < b, 0 elsewhere.
  SEICHE_INLINE static Pack where_less(Pack a, double b, Pack value) { return a < b ? value : Pack{}; }
  template <int count>
  SEICHE_INLINE static SideBySide<TwoLanes, count> inverse_root(const SideBySide<TwoLanes, count>& a) {
    return SideBySide<TwoLanes, count>::of([&](int k) {
      return 1.0 / Pack{std::sqrt(a.at[k][0]), std::sqrt(a.at[k][1])};
    });
  }
};

struct FourSingleLanes : MixedLanes {
  static constexpr int width = 4;
  using Pack [[gnu::vector_size(16)]] = float;
  using Places [[gnu::vector_size(16)]] = std::uint32_t;
  using Signed [[gnu::vector_size(16)]] = std::int32_t;
  using Half [[gnu::vector_size(16)]] = double;
  struct Wide {
    Half low, high;
  };
  SEICHE_INLINE static Pack distances(Places a, std::int32_t b, float unit) {
    return __builtin_convertvector(Signed(a - static_cast<std::uint32_t>(b)), Pack) * unit;
  }
  SEICHE_INLINE static void add(Wide& sum, Pack part) {
    sum.low += Half{part[0], part[1]};
    sum.high += Half{part[2], part[3]};
  }
  SEICHE_INLINE static Pack narrow(double factor, const Wide& sum) {
    const Half low = factor * sum.low;
    const Half high = factor * sum.high;
    return Pack{static_cast<float>(low[0]), static_cast<float>(low[1]), static_cast<float>(high[0]),
                static_cast<float>(high[1])};
  }
  SEICHE_INLINE static Pack largest(Pack a, Pack b) { return a > b ? a : b; }
  SEICHE_INLINE static Pack positive(Pack a) { return a > 0.0F ? a : Pack{}; }
  SEICHE_INLINE static Pack negative(Pack a) { return a < 0.0F ? a : Pack{}; }
  SEICHE_INLINE static unsigned less(Pack a, Pack b) {
    unsigned bits = 0;
    for (int l = 0; l < width; ++l) bits |= a[l] < b[l] ? 1U << static_cast<unsigned>(l) : 0U;
    return bits;
  }
  SEICHE_INLINE static Pack where_less(Pack a, float b, Pack value) { return a < b ? value : Pack{}; }
  template <int count>
  SEICHE_INLINE static SideBySide<FourSingleLanes, count> inverse_root(const SideBySide<FourSingleLanes, count>& a) {
    return SideBySide<FourSingleLanes, count>::of([&](int k) {
      const Pack& of = a.at[k];
      return 1.0F / Pack{std::sqrt(of[0]), std::sqrt(of[1]), std::sqrt(of[2]), std::sqrt(of[3])};
    });
  }
};

}  // namespace

const PairLoops versions::baseline = loops_of<TwoLanes, FourSingleLanes>();

}  // namespace seiche::wcsph
