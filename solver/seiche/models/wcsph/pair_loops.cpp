#include "seiche/models/wcsph/pair_loops.hpp"

namespace seiche::wcsph {

const PairLoops& pair_loops() {
#if SEICHE_PAIR_LOOPS_X86
  if (__builtin_cpu_supports("x86-64-v4")) return versions::avx512;
  if (__builtin_cpu_supports("x86-64-v3")) return versions::avx2;
#endif
  return versions::baseline;
}

}  // namespace seiche::wcsph
