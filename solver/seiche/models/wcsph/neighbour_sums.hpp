/// Sums over neighbours one particle at a time, for what is done seldom; internal to Flow.
#pragma once

#include <cmath>
#include <cstddef>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

/// Calls particle(i, cluster) for every particle of the clusters [begin, end), on all threads.
template <class Visit>
void for_each_particle(const Neighbours& neighbours, std::size_t begin, std::size_t end, Visit particle) {
  neighbours.share(begin, end, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      const Cluster& cluster = neighbours.clusters()[c];
      for (std::int32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
        particle(static_cast<std::size_t>(i), cluster);
      }
    }
  });
}

/// Calls pair(j, x_ab, z_ab, r, h_ab) for every record j within the support of particle i, itself included.
template <class Pair>
void for_each_neighbour(const Stage& stage, const Cluster& cluster, std::size_t i, Pair pair) {
  const Record& a = stage.records()[i];
  for (const std::int32_t* candidate = cluster.begin; candidate != cluster.end; ++candidate) {
    const auto j = static_cast<std::size_t>(*candidate);
    const Record& b = stage.records()[j];
    const double x = a.x - b.x;
    const double z = a.z - b.z;
    const double h = 0.5 * (a.smoothing + b.smoothing);
    const double square = x * x + z * z;
    if (square < support * support * h * h) pair(j, x, z, std::sqrt(square), h);
  }
}

}  // namespace seiche::wcsph
