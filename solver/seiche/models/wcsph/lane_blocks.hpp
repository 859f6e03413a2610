/// What all loops over pairs on lanes share: records of a cluster as packs, distances, the visit of candidates;
/// internal to them.
///
/// `Lanes` has the Record that it reads; Pack, a vector of Lanes::width Scalars; on it positive and negative (largest
/// or smallest of it and 0), largest, less (one bit per lane), where_less and inverse_root; Places and the
/// distances() of one from them; Wide, sums of Packs in double precision.
///
/// Included by each version of the loops after its target is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/lane_kernels.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"

namespace seiche::wcsph {

/// What all lanes of doubles have in common.
struct FullLanes {
  using Record = wcsph::Record;
  using Scalar = double;
  static constexpr bool single = false;
  /// Keeps 1/r finite at r = 0, far below any distance squared.
  static constexpr double least_square = 1e-200;
};

/// And all of single precision.
struct MixedLanes {
  using Record = MixedRecord;
  using Scalar = float;
  static constexpr bool single = true;
  /// Keeps 1/r finite at r = 0, below the square of what places are rounded by.
  static constexpr double least_square = 1e-20;
};

/// One coordinate of a cluster's records.
template <class Lanes, class Place>
SEICHE_INLINE typename Lanes::Places places(const typename Lanes::Record* records, Place Lanes::Record::*place) {
  typename Lanes::Places packed;
  if constexpr (Lanes::single) {
    Place values[Lanes::width];
    for (int l = 0; l < Lanes::width; ++l) values[l] = records[l].*place;
    __builtin_memcpy(&packed, values, sizeof packed);
  } else {
    for (int l = 0; l < Lanes::width; ++l) packed[l] = records[l].*place;
  }
  return packed;
}

/// Records of a cluster.
template <class Lanes>
struct Block {
  typename Lanes::Places x, z;
  typename Lanes::Pack u, w, density, pressure, smoothing, sound;
  typename Lanes::Scalar place_unit;
};

template <class Lanes>
SEICHE_INLINE Block<Lanes> load_block(const typename Lanes::Record* records, double place_unit = 1) {
  Block<Lanes> a;
  a.place_unit = static_cast<typename Lanes::Scalar>(place_unit);
  a.x = places<Lanes>(records, &Lanes::Record::x);
  a.z = places<Lanes>(records, &Lanes::Record::z);
  for (int l = 0; l < Lanes::width; ++l) {
    const typename Lanes::Record& record = records[l];
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
SEICHE_INLINE void store(typename Lanes::Pack values, typename Lanes::Scalar* to, const Cluster& cluster) {
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

/// A sum over candidates in double precision; of single precision, those side by side are added up before.
template <class Lanes>
class Sum {
 public:
  using Values = SideBySide<Lanes, abreast>;

  /// Adds a b of each candidate.
  SEICHE_INLINE void add(const Values& a, const Values& b) {
    if constexpr (Lanes::single) {
      typename Lanes::Pack part = a.at[0] * b.at[0];
      for (int k = 1; k < abreast; ++k) part += a.at[k] * b.at[k];
      Lanes::add(sum_, part);
    } else {
      for (int k = 0; k < abreast; ++k) sum_ += a.at[k] * b.at[k];
    }
  }
  SEICHE_INLINE void subtract(const Values& a, const Values& b) {
    if constexpr (Lanes::single) {
      typename Lanes::Pack part = a.at[0] * b.at[0];
      for (int k = 1; k < abreast; ++k) part += a.at[k] * b.at[k];
      Lanes::add(sum_, -part);
    } else {
      for (int k = 0; k < abreast; ++k) sum_ -= a.at[k] * b.at[k];
    }
  }
  [[nodiscard]] SEICHE_INLINE Sum plus(const Sum& other) const {
    Sum both;
    if constexpr (Lanes::single) {
      both.sum_ = {sum_.low + other.sum_.low, sum_.high + other.sum_.high};
    } else {
      both.sum_ = sum_ + other.sum_;
    }
    return both;
  }
  /// Times a factor, in the precision of the lanes.
  [[nodiscard]] SEICHE_INLINE typename Lanes::Pack times(double factor) const {
    if constexpr (Lanes::single) {
      return Lanes::narrow(factor, sum_);
    } else {
      return factor * sum_;
    }
  }

 private:
  typename Lanes::Wide sum_{};
};

/// Records of the next candidates; those after them are on their way to the cache when their turn comes.
template <class SomeRecord>
SEICHE_INLINE void load_records(const SomeRecord* records, const std::int32_t* candidate,
                                const SomeRecord* (&b)[abreast]) {
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

  SEICHE_INLINE Distance(const Block<Lanes>& a, const typename Lanes::Record* const (&b)[abreast]) {
    x = Values::of([&](int k) { return Lanes::distances(a.x, b[k]->x, a.place_unit); });
    z = Values::of([&](int k) { return Lanes::distances(a.z, b[k]->z, a.place_unit); });
    const Values square = x * x + (z * z + Lanes::least_square);
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
SEICHE_INLINE void visit_candidates(const typename Lanes::Record* records, const Cluster& cluster,
                                    const Block<Lanes>& a, Visit visit) {
  using Shape = LaneKernel<typename Pair::Values, Kernel>;
  for (const std::int32_t* candidate = cluster.begin; candidate < cluster.end; candidate += abreast) {
    const typename Lanes::Record* b[abreast];
    load_records(records, candidate, b);
    const Pair pair(a, b);
    visit(candidate, b, pair, Shape(pair.s, pair.inverse_area, pair.inverse_width));
  }
}

}  // namespace seiche::wcsph
