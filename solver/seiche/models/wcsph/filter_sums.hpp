/// Sums of the density filter, formulas in density_filter.hpp; included by pair_sums.hpp.
#pragma once

#include "seiche/models/wcsph/lane_blocks.hpp"

namespace seiche::wcsph {

template <class Lanes, class Kernel>
void filter_moments(const FilterWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack a00{}, ax{}, az{}, axx{}, axz{}, azz{}, m0{}, mx{}, mz{}, within{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const auto weight = pair.inverse_width * pair.inverse_width * shape.weight;
          for (int k = 0; k < abreast; ++k) {
            const double mass = work.mass[candidate[k]];
            const Pack x = pair.x.at[k];
            const Pack z = pair.z.at[k];
            const Pack heavy = mass * weight.at[k];
            const Pack volume = (mass / b[k]->density) * weight.at[k];
            a00 += volume;
            ax += volume * x;
            az += volume * z;
            axx += volume * x * x;
            axz += volume * x * z;
            azz += volume * z * z;
            m0 += heavy;
            mx += heavy * x;
            mz += heavy * z;
            within += Lanes::where_less(pair.s.at[k], 1.0, Pack{} + 1.0);
          }
        });
    for (int l = 0; l < cluster.count; ++l) {
      work.moments[cluster.first + l] = {a00[l], ax[l], az[l], axx[l], axz[l],
                                         azz[l], m0[l], mx[l], mz[l],  within[l] - 1};
    }
  }
}

}  // namespace seiche::wcsph
