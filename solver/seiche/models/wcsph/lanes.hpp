/// What all loops over pairs on lanes share: records of a cluster as packs of lanes, kernels on them, the visit of
/// candidates; internal to them.
///
/// A pair's terms are a long chain of dependent operations. Those of a few candidates side by side, operation by
/// operation, keep the processor's units busy.
///
/// `Lanes` has Pack, a vector of Lanes::width doubles; on it less (one bit per lane) and inverse_root.
///
/// Included by each version of the loops after its target is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {

/// The larger of two numbers in each lane.
template <class Pack>
SEICHE_INLINE Pack larger(Pack a, Pack b) {
  return a > b ? a : b;
}
/// `value` where a < b, 0 elsewhere.
template <class Pack>
SEICHE_INLINE Pack where_less(Pack a, double b, Pack value) {
  return a < b ? value : Pack{};
}

/// `count` packs of lanes, one per candidate.
template <class Lanes, int count = abreast>
struct SideBySide {
  using Pack = typename Lanes::Pack;
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
    return of([&](int k) { return a.at[k] + b; });
  }
  SEICHE_INLINE friend SideBySide operator-(const SideBySide& a, double b) {
    return of([&](int k) { return a.at[k] - b; });
  }
  SEICHE_INLINE friend SideBySide operator-(double a, const SideBySide& b) {
    return of([&](int k) { return a - b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide operator*(double a, const SideBySide& b) {
    return of([&](int k) { return a * b.at[k]; });
  }
  SEICHE_INLINE friend SideBySide positive(const SideBySide& a) {
    return of([&](int k) { return a.at[k] > 0.0 ? a.at[k] : Pack{}; });
  }
  SEICHE_INLINE friend SideBySide negative(const SideBySide& a) {
    return of([&](int k) { return a.at[k] < 0.0 ? a.at[k] : Pack{}; });
  }
  SEICHE_INLINE friend SideBySide inverse_root(const SideBySide& a) {
    return Lanes::template inverse_root<count>(a);
  }
};

/// Kernels as functions of s = r/(h_a + h_b) = q/2:
///
///     W = weight_factor i^2 weight,   F = (1/r) dW/dr = slope_factor i^2 slope,   i = 1/(h_a + h_b)
///
/// @tparam Values  SideBySide
template <class Values, class Kernel>
struct LaneKernel;

template <class Values>
struct LaneKernel<Values, CubicSpline> {
  static constexpr double weight_factor = 8 * CubicSpline::factor;
  static constexpr double slope_factor = 24 * CubicSpline::factor;
  Values weight, slope;
  /// weight = outer^3 - 4 inner^3, slope = (4 inner^2 - outer^2) i/r with outer = (1-s)_+, inner = (1/2-s)_+; the
  /// factor of the cube goes into `inner`.
  SEICHE_INLINE LaneKernel(const Values& s, const Values& inverse_area, const Values& /*inverse_width*/) {
    constexpr double root = 1.5874010519681994;  // 4^(1/3)
    const Values outer = positive(1.0 - s);
    const Values inner = positive(root * outer - 0.5 * root);
    const Values outer_square = outer * outer;
    const Values inner_square = inner * inner;
    weight = outer_square * outer - inner_square * inner;
    slope = (root * inner_square - outer_square) * inverse_area;
  }
};

template <class Values>
struct LaneKernel<Values, WendlandC2> {
  static constexpr double weight_factor = 4 * WendlandC2::factor;
  static constexpr double slope_factor = -80 * WendlandC2::factor;
  Values weight, slope;
  SEICHE_INLINE LaneKernel(const Values& s, const Values& /*inverse_area*/, const Values& inverse_width) {
    const Values rest = positive(1.0 - s);
    const Values cube = rest * rest * rest;
    weight = cube * rest * (4.0 * s + 1.0);
    slope = cube * (inverse_width * inverse_width);
  }
};

/// Records of a cluster.
template <class Lanes>
struct Block : Cluster {
  using Pack = typename Lanes::Pack;
  Pack x, z, u, w, density, pressure, smoothing;

  SEICHE_INLINE Block(const Record* records, const Cluster& cluster) : Cluster(cluster) {
    for (int l = 0; l < Lanes::width; ++l) {
      const Record& record = records[first + l];
      x[l] = record.x;
      z[l] = record.z;
      u[l] = record.u;
      w[l] = record.w;
      density[l] = record.density;
      pressure[l] = record.pressure;
      smoothing[l] = record.smoothing;
    }
  }
  SEICHE_INLINE void store(Pack values, double* to) const {
    if (count == Lanes::width) {
      __builtin_memcpy(to + first, &values, sizeof values);
    } else {
      for (int l = 0; l < count; ++l) to[first + l] = values[l];
    }
  }
};

/// Keeps 1/r finite at r = 0, far below any distance squared.
inline constexpr double least_square = 1e-200;

/// What depends on the places and smoothing lengths of pairs alone.
template <class Lanes>
struct Distance {
  using Values = SideBySide<Lanes>;
  Values x, z, s;
  Values inverse_area;  ///< 1/(r (h_a + h_b))
  Values inverse_width;

  SEICHE_INLINE Distance(const Block<Lanes>& a, const Record* const (&b)[abreast]) {
    x = Values::of([&](int k) { return a.x - b[k]->x; });
    z = Values::of([&](int k) { return a.z - b[k]->z; });
    const Values square = x * x + (z * z + least_square);
    const Values width = Values::of([&](int k) { return a.smoothing + b[k]->smoothing; });
    const Values scaled = square * width;
    inverse_area = inverse_root(scaled * width);
    const Values distance = scaled * inverse_area;
    inverse_width = distance * inverse_area;
    s = distance * inverse_width;
  }
};

/// Calls use(candidate, b, pair, shape) with the next few candidates of a cluster, their records, what depends on the
/// places of the pairs, and the kernel there, until the list ends. Records after them are on their way to the cache
/// when their turn comes.
/// @tparam Pair  Distance, or more
template <class Kernel, template <class> class Pair, class Lanes, class Use>
SEICHE_INLINE void visit(const PairWork& work, const Block<Lanes>& a, Use use) {
  for (const std::int32_t* candidate = a.begin; candidate < a.end; candidate += abreast) {
    const Record* b[abreast];
    for (int k = 0; k < abreast; ++k) {
      b[k] = work.records + candidate[k];
      __builtin_prefetch(work.records + candidate[k + candidates_ahead]);
    }
    const Pair<Lanes> pair(a, b);
    use(candidate, b, pair, LaneKernel<SideBySide<Lanes>, Kernel>(pair.s, pair.inverse_area, pair.inverse_width));
  }
}

}  // namespace seiche::wcsph
