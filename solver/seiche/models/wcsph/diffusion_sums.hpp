/// Sums of the density diffusion, formulas in density_diffusion.hpp; included by pair_sums.hpp.
#pragma once

#include "seiche/models/wcsph/lane_blocks.hpp"

namespace seiche::wcsph {

/// Below it the matrix of a particle, 1 inside the fluid, is taken as singular: 4 of about 20 neighbours on one side.
inline constexpr double least_determinant = 1e-2;

template <class Lanes, class Kernel>
void density_gradient(const DiffusionWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack xx{}, xz{}, zz{}, difference_x{}, difference_z{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values squared = pair.inverse_width * pair.inverse_width;
          for (int k = 0; k < abreast; ++k) {
            const Pack slope = work.gradients[candidate[k]].volume * squared.at[k] * shape.slope.at[k];
            const Pack difference = b[k]->density - a.density;
            const Pack x = slope * pair.x.at[k];
            const Pack z = slope * pair.z.at[k];
            xx += x * pair.x.at[k];
            xz += x * pair.z.at[k];
            zz += z * pair.z.at[k];
            difference_x += difference * x;
            difference_z += difference * z;
          }
        });
    // sum V (rho_b - rho_a) grad_j W = g_i sum V (r_ba)_i grad_j W.
    constexpr double scale = Shape::slope_factor;
    for (int l = 0; l < cluster.count; ++l) {
      const double determinant = xx[l] * zz[l] - xz[l] * xz[l];
      DensityGradient& gradient = work.gradients[cluster.first + l];
      const bool singular = scale * scale * determinant < least_determinant;
      gradient.x = singular ? 0 : (xz[l] * difference_z[l] - zz[l] * difference_x[l]) / determinant;
      gradient.z = singular ? 0 : (xz[l] * difference_x[l] - xx[l] * difference_z[l]) / determinant;
    }
  }
}

template <class Lanes, class Kernel>
void density_diffusion(const DiffusionWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack gradient_x, gradient_z;
    for (int l = 0; l < Lanes::width; ++l) {
      const DensityGradient& gradient = work.gradients[cluster.first + l];
      gradient_x[l] = gradient.x;
      gradient_z[l] = gradient.z;
    }
    Pack sum{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          // h_ab/(h_a + h_b)^2: the 1/2 is deferred.
          for (int k = 0; k < abreast; ++k) {
            const DensityGradient& other = work.gradients[candidate[k]];
            // psi . grad W = slope (steep - linear), r_ba = -r_ab.
            const Pack steep = -2.0 * (b[k]->density - a.density);
            const Pack linear = (gradient_x + other.x) * pair.x.at[k] + (gradient_z + other.z) * pair.z.at[k];
            const Pack term = other.volume * pair.inverse_width.at[k] * shape.slope.at[k] * (steep - linear);
            // At r = 0 the slope is rounding over r.
            sum += Lanes::where_less(-pair.s.at[k], -1e-12, term);
          }
        });
    const Pack added = (0.5 * work.strength * Shape::slope_factor) * sum;
    for (int l = 0; l < cluster.count; ++l) work.ddensity[cluster.first + l] += added[l];
  }
}

}  // namespace seiche::wcsph
