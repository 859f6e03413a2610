/// Several independent values that go through the same operations side by side; internal to the pair loops.
///
/// A pair's terms are a long chain of dependent operations. Those of a few candidates at once, operation by operation,
/// keep the processor's units busy.
///
/// Included by each version of the loops after its target is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {

/// `count` packs of lanes, one per candidate.
template <class Lanes, int count>
struct SideBySide {
  using Pack = typename Lanes::Pack;
  using Scalar = typename Lanes::Scalar;
  Pack at[count];

  template <class Operation>
  SEICHE_INLINE static SideBySide of(Operation operation) {
    SideBySide result;
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k) result.at[k] = operation(k);
    return result;
  }
  SEICHE_INLINE friend SideBySide operator+(const SideBySide& a, const SideBySide& b) {
    return of([&](int k) { return a.at[k] + b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide operator-(const SideBySide& a, const SideBySide& b) {
    return of([&](int k) { return a.at[k] - b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide operator*(const SideBySide& a, const SideBySide& b) {
    return of([&](int k) { return a.at[k] * b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide operator+(const SideBySide& a, double b) {
    return of([&](int k) { return a.at[k] + static_cast<Scalar>(b); });
  }
  SEICHE_INLINE friend SideBySide operator-(const SideBySide& a, double b) {
    return of([&](int k) { return a.at[k] - static_cast<Scalar>(b); });
  }
  SEICHE_INLINE friend SideBySide operator-(double a, const SideBySide& b) {
    return of([&](int k) { return static_cast<Scalar>(a) - b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide operator*(double a, const SideBySide& b) {
    return of([&](int k) { return static_cast<Scalar>(a) * b.at[k]; });
  }
};

template <class Lanes, int count>
SEICHE_INLINE SideBySide<Lanes, count> positive(const SideBySide<Lanes, count>& a) {
  return SideBySide<Lanes, count>::of([&](int k) { return Lanes::positive(a.at[k]); });
}
template <class Lanes, int count>
SEICHE_INLINE SideBySide<Lanes, count> negative(const SideBySide<Lanes, count>& a) {
  return SideBySide<Lanes, count>::of([&](int k) { return Lanes::negative(a.at[k]); });
}
template <class Lanes, int count>
SEICHE_INLINE SideBySide<Lanes, count> inverse_root(const SideBySide<Lanes, count>& a) {
  return Lanes::template inverse_root<count>(a);
}

}  // namespace seiche::wcsph
