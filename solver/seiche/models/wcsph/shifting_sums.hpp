/// Sums of the particle shifting, formulas in particle_shifting.hpp; included by pair_sums.hpp.
#pragma once

#include "seiche/models/wcsph/lane_blocks.hpp"

namespace seiche::wcsph {

inline constexpr double repulsion = 0.2;
inline constexpr double surface_divergence = 1.5;
inline constexpr double longest_shift = 0.1;  ///< over dx

template <class Lanes, class Kernel>
void find_surface(const ShiftWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack divergence{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values square = pair.x * pair.x + pair.z * pair.z;
          const Values weight = square * (pair.inverse_width * pair.inverse_width) * shape.slope;
          for (int k = 0; k < abreast; ++k) {
            divergence -= (work.mass[candidate[k]] / b[k]->density) * weight.at[k];
          }
        });
    divergence *= Shape::slope_factor;
    for (int l = 0; l < cluster.count; ++l) {
      work.at_surface[cluster.first + l] = divergence[l] < surface_divergence ? 1 : 0;
    }
  }
}

/// Everything is read from the records, so that particles can be changed at once.
template <class Lanes, class Kernel>
void shift(const ShiftWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    // (2 h)^2 W(dx), without the kernel's factor.
    using One = SideBySide<Lanes, 1>;
    const Pack inverse = 0.5 / a.smoothing;
    const Pack squared_usual =
        inverse * inverse *
        LaneKernel<One, Kernel>(One{{work.spacing * inverse}}, One{{inverse}}, One{{inverse}}).weight.at[0];
    const Pack per_usual = 1.0 / squared_usual;
    Pack surface{}, crowd_x{}, crowd_z{}, u_x{}, u_z{}, w_x{}, w_z{}, density_x{}, density_z{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values squared = pair.inverse_width * pair.inverse_width;
          const Values weight = squared * shape.weight;
          for (int k = 0; k < abreast; ++k) {
            const Pack volume_slope = (work.mass[candidate[k]] / b[k]->density) * squared.at[k] * shape.slope.at[k];
            const Pack x = volume_slope * pair.x.at[k];
            const Pack z = volume_slope * pair.z.at[k];
            const Pack close = weight.at[k] * per_usual;
            const Pack crowd = 1.0 + repulsion * ((close * close) * (close * close));
            crowd_x += crowd * x;
            crowd_z += crowd * z;
            const Pack u = b[k]->u - a.u;
            const Pack w = b[k]->w - a.w;
            const Pack density = b[k]->density - a.density;
            u_x += u * x;
            u_z += u * z;
            w_x += w * x;
            w_z += w * z;
            density_x += density * x;
            density_z += density * z;
            const Pack marked = Pack{} + work.at_surface[candidate[k]];
            surface = Lanes::largest(surface, Lanes::where_less(pair.s.at[k], 1.0, marked));
          }
        });
    constexpr double scale = Shape::slope_factor;
    for (int l = 0; l < cluster.count; ++l) {
      if (surface[l] > 0) continue;
      const double factor = -work.travel * a.smoothing[l] * scale;
      const double length = factor * factor * (crowd_x[l] * crowd_x[l] + crowd_z[l] * crowd_z[l]);
      const double longest = longest_shift * work.spacing;
      const double limit = length > longest * longest ? longest / __builtin_sqrt(length) : 1;
      const double x = limit * factor * crowd_x[l];
      const double z = limit * factor * crowd_z[l];
      const auto i = cluster.first + l;
      work.x[i] += x;
      work.z[i] += z;
      work.u[i] += scale * (u_x[l] * x + u_z[l] * z);
      work.w[i] += scale * (w_x[l] * x + w_z[l] * z);
      work.density[i] += scale * (density_x[l] * x + density_z[l] * z);
    }
  }
}

}  // namespace seiche::wcsph
