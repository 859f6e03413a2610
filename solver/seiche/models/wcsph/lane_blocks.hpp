/// What all loops over pairs on lanes share: records of a cluster as packs, distances, the visit of candidates;
/// internal to them.
///
/// `Lanes` has Pack, a vector of Lanes::width doubles; on it positive and negative (largest or smallest of it and 0),
/// largest, less (one bit per lane), where_less and inverse_root.
///
/// Included by each version of the loops after its target is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/lane_kernels.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"

namespace seiche::wcsph {

/// Keeps 1/r finite at r = 0, far below any distance squared.
inline constexpr double least_square = 1e-200;

template <class Lanes>
struct Block {
  typename Lanes::Pack x, z, u, w, density, pressure, smoothing, sound;
};

template <class Lanes>
SEICHE_INLINE Block<Lanes> load_block(const Record* records) {
  Block<Lanes> a;
  for (int l = 0; l < Lanes::width; ++l) {
    const Record& record = records[l];
    a.x[l] = record.x;
    a.z[l] = record.z;
    a.u[l] = record.u;
    a.w[l] = record.w;
    a.density[l] = record.density;
    a.pressure[l] = record.pressure;
    a.smoothing[l] = record.smoothing;
    a.sound[l] = record.sound;
  }
  return a;
}

template <class Lanes>
SEICHE_INLINE void store(typename Lanes::Pack values, double* to, const Cluster& cluster) {
  if (cluster.count == Lanes::width) {
    __builtin_memcpy(to + cluster.first, &values, sizeof values);
  } else {
    for (int l = 0; l < cluster.count; ++l) to[cluster.first + l] = values[l];
  }
}

template <class Lanes>
SEICHE_INLINE typename Lanes::Pack magnitude(typename Lanes::Pack value) {
  return Lanes::largest(value, -value);
}

/// Records of the next candidates; those after them are on their way to the cache when their turn comes.
SEICHE_INLINE void load_records(const Record* records, const std::int32_t* candidate, const Record* (&b)[abreast]) {
  for (int k = 0; k < abreast; ++k) {
    b[k] = records + candidate[k];
    __builtin_prefetch(records + candidate[k + candidates_ahead]);
  }
}

/// What depends on the places and smoothing lengths of pairs alone.
template <class Lanes>
struct Distance {
  using Values = SideBySide<Lanes, abreast>;
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

/// Calls visit(candidate, b, pair, shape) with the next few candidates of a cluster, their records, what depends on the
/// places of the pairs, and the kernel there, until the list ends.
/// @tparam Pair  Distance, or more
template <class Kernel, class Pair, class Lanes, class Visit>
SEICHE_INLINE void visit_candidates(const Record* records, const Cluster& cluster, const Block<Lanes>& a, Visit visit) {
  using Shape = LaneKernel<typename Pair::Values, Kernel>;
  for (const std::int32_t* candidate = cluster.begin; candidate < cluster.end; candidate += abreast) {
    const Record* b[abreast];
    load_records(records, candidate, b);
    const Pair pair(a, b);
    visit(candidate, b, pair, Shape(pair.s, pair.inverse_area, pair.inverse_width));
  }
}

}  // namespace seiche::wcsph
