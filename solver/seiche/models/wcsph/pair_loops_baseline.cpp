#include <cmath>

#include "seiche/models/wcsph/pair_sums.hpp"

namespace seiche::wcsph {
namespace {

/// Any machine whose compiler knows the vector types of GCC.
struct TwoLanes {
  static constexpr int width = 2;
  using Pack [[gnu::vector_size(16)]] = double;
  SEICHE_INLINE static unsigned less(Pack a, Pack b) { return (a[0] < b[0] ? 1U : 0U) | (a[1] < b[1] ? 2U : 0U); }
  template <int count>
  SEICHE_INLINE static SideBySide<TwoLanes, count> inverse_root(const SideBySide<TwoLanes, count>& a) {
    return SideBySide<TwoLanes, count>::of([&](int k) {
      return 1.0 / Pack{std::sqrt(a.at[k][0]), std::sqrt(a.at[k][1])};
    });
  }
};

}  // namespace

const PairLoops versions::baseline[2] = {loops_of<TwoLanes, CubicSpline>(), loops_of<TwoLanes, WendlandC2>()};

const PairLoops& pair_loops(KernelName kernel, int lanes) {
  const auto k = static_cast<std::size_t>(kernel);
#if SEICHE_PAIR_LOOPS_X86
  if (lanes >= 8 && __builtin_cpu_supports("x86-64-v4")) return versions::avx512[k];
  if (lanes >= 4 && __builtin_cpu_supports("x86-64-v3")) return versions::avx2[k];
#endif
  return versions::baseline[k];
}

}  // namespace seiche::wcsph
