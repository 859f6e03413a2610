/// Sums of the extrapolation to walls, formula in wall_pressure.hpp; included by pair_sums.hpp.
#pragma once

#include "seiche/models/wcsph/lane_blocks.hpp"

namespace seiche::wcsph {

template <class Lanes, class Kernel>
void wall_pressure(const WallPressureWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack pressure{}, lever_x{}, lever_z{}, weights{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* /*candidate*/, const auto& b, const auto& pair, const auto& shape) {
          const auto weight = pair.inverse_width * pair.inverse_width * shape.weight;
          for (int k = 0; k < abreast; ++k) {
            const double density = b[k]->density;
            const Pack heavy = density * weight.at[k];
            pressure += (b[k]->pressure * density) * heavy;
            lever_x += pair.x.at[k] * heavy;
            lever_z += pair.z.at[k] * heavy;
            weights += weight.at[k];
          }
        });
    for (int l = 0; l < cluster.count; ++l) {
      const double per_weight = weights[l] > 0 ? 1 / weights[l] : 0;
      work.means[cluster.first + l] = {pressure[l] * per_weight, lever_x[l] * per_weight, lever_z[l] * per_weight};
    }
  }
}

}  // namespace seiche::wcsph
