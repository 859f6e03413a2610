/// The loops of pair_loops.hpp for one kind of lanes; included by each version after its target is chosen, so nothing
/// of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/diffusion_sums.hpp"
#include "seiche/models/wcsph/filter_sums.hpp"
#include "seiche/models/wcsph/lane_blocks.hpp"
#include "seiche/models/wcsph/shifting_sums.hpp"
#include "seiche/models/wcsph/wall_pressure_sums.hpp"

namespace seiche::wcsph {

/// eta^2 = 0.01 h_ab^2 in terms of h_a + h_b.
inline constexpr double softening = 0.0025;

/// What depends on the places, smoothing lengths and densities of pairs.
template <class Lanes>
struct Separation {
  using Values = SideBySide<Lanes, abreast>;
  Values x, z, s;
  Values inverse_area;  ///< 1/(r (h_a + h_b))
  Values inverse_width, inverse_densities;
  Values viscous;  ///< (h_a + h_b)/((rho_a + rho_b) (r^2 + eta^2))

  SEICHE_INLINE Separation(const Block<Lanes>& a, const Record* const (&b)[abreast]) {
    x = Values::of([&](int k) { return a.x - b[k]->x; });
    z = Values::of([&](int k) { return a.z - b[k]->z; });
    const Values square = x * x + (z * z + least_square);
    const Values width = Values::of([&](int k) { return a.smoothing + b[k]->smoothing; });
    const Values densities = Values::of([&](int k) { return a.density + b[k]->density; });
    const Values softened = square + softening * (width * width);
    const Values both = softened * densities;
    // One root for all: 1/(r p), p = (h_a + h_b) (rho_a + rho_b) (r^2 + eta^2).
    const Values product = both * width;
    const Values scaled = square * product;
    const Values root = inverse_root(scaled * product);
    const Values distance = scaled * root;
    inverse_area = both * root;
    inverse_width = inverse_area * distance;
    const Values inverse_both = (distance * root) * width;
    inverse_densities = inverse_both * softened;
    viscous = inverse_both * width;
    s = distance * inverse_width;
  }
};

template <class Lanes, class Kernel, Friction friction, bool limited>
void fluid_rates(const PairWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack xx{}, xz{}, zz{};
    if constexpr (friction == Friction::turbulent) {
      for (int l = 0; l < Lanes::width; ++l) {
        const Stress& stress = work.stress[cluster.first + l];
        xx[l] = stress.xx;
        xz[l] = stress.xz;
        zz[l] = stress.zz;
      }
    }
    Pack du{}, dw{}, ddensity{}, smooth_u{}, smooth_w{}, sigma{};
    visit_candidates<Kernel, Separation<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values u = Values::of([&](int k) { return a.u - b[k]->u; });
          const Values w = Values::of([&](int k) { return a.w - b[k]->w; });
          const Values approach = pair.x * u + pair.z * w;
          const Values squared = pair.inverse_width * pair.inverse_width;
          const Values scaled_mass = Values::of([&](int k) { return work.mass[candidate[k]] * squared.at[k]; });
          const Values slope = scaled_mass * shape.slope;
          const Values weight = scaled_mass * pair.inverse_densities * shape.weight;
          Values pressures = Values::of([&](int k) { return a.pressure + b[k]->pressure; });
          if constexpr (friction == Friction::artificial) {
            const Values sound = Values::of([&](int k) { return a.sound + b[k]->sound; });
            pressures = pressures + sound * negative(approach) * pair.viscous;
          }
          const Values push = pressures * slope;
          for (int k = 0; k < abreast; ++k) {
            ddensity += slope.at[k] * approach.at[k];
            du -= push.at[k] * pair.x.at[k];
            dw -= push.at[k] * pair.z.at[k];
            smooth_u += weight.at[k] * u.at[k];
            smooth_w += weight.at[k] * w.at[k];
          }
          if constexpr (friction == Friction::laminar || friction == Friction::turbulent) {
            const Values square = pair.x * pair.x + pair.z * pair.z;
            const Values drag = 4 * work.kinematic_viscosity * square * (pair.viscous * pair.inverse_width) * slope;
            for (int k = 0; k < abreast; ++k) {
              du += drag.at[k] * u.at[k];
              dw += drag.at[k] * w.at[k];
            }
          }
          if constexpr (friction == Friction::turbulent) {
            for (int k = 0; k < abreast; ++k) {
              const Stress& other = work.stress[candidate[k]];
              const Pack sum_xz = xz + other.xz;
              du += slope.at[k] * ((xx + other.xx) * pair.x.at[k] + sum_xz * pair.z.at[k]);
              dw += slope.at[k] * (sum_xz * pair.x.at[k] + (zz + other.zz) * pair.z.at[k]);
            }
          }
          if constexpr (limited) {
            for (int k = 0; k < abreast; ++k) {
              const Pack rate = magnitude<Lanes>(approach.at[k]) * (pair.viscous.at[k] * (a.density + b[k]->density));
              sigma = Lanes::largest(sigma, Lanes::where_less(pair.s.at[k], 1.0, rate));
            }
          }
        });
    // Deferred constants; densities were sums, not means.
    const double xsph = 2 * work.xsph * Shape::weight_factor;
    store<Lanes>(a.u - xsph * smooth_u, work.dx, cluster);
    store<Lanes>(a.w - xsph * smooth_w, work.dz, cluster);
    store<Lanes>(Shape::slope_factor * du, work.du, cluster);
    store<Lanes>(Shape::slope_factor * dw - work.gravity, work.dw, cluster);
    store<Lanes>(Shape::slope_factor * ddensity, work.ddensity, cluster);
    if constexpr (limited) {
      store<Lanes>((a.sound * (1 / work.sound_scale) + 0.5 * sigma) / a.smoothing, work.limit, cluster);
    }
  }
}

template <class Lanes, class Kernel, bool limited>
void wall_rates(const PairWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    Pack ddensity{}, sigma{};
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    visit_candidates<Kernel, Separation<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          for (int k = 0; k < abreast; ++k) {
            const Pack approach = pair.x.at[k] * (a.u - b[k]->u) + pair.z.at[k] * (a.w - b[k]->w);
            const Pack inverse_width = pair.inverse_width.at[k];
            ddensity += work.mass[candidate[k]] * (inverse_width * inverse_width) * shape.slope.at[k] * approach;
            if constexpr (limited) {
              const Pack rate = magnitude<Lanes>(approach) * (pair.viscous.at[k] * (a.density + b[k]->density));
              sigma = Lanes::largest(sigma, Lanes::where_less(pair.s.at[k], 1.0, rate));
            }
          }
        });
    store<Lanes>(Shape::slope_factor * ddensity, work.ddensity, cluster);
    if constexpr (limited) {
      store<Lanes>((a.sound * (1 / work.sound_scale) + 0.5 * sigma) / a.smoothing, work.limit, cluster);
    }
  }
}

/// tau/rho = 2 nu_t (S - (1/3) tr S) - (2/3) C_I Delta^2 |S|^2, nu_t = (C_S Delta)^2 |S|, |S| = sqrt(2 S:S).
template <class Lanes, class Kernel>
void strain_stress(const PairWork& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first);
    Pack u_x{}, u_z{}, w_x{}, w_z{};
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values squared = pair.inverse_width * pair.inverse_width;
          for (int k = 0; k < abreast; ++k) {
            const Pack slope = work.stress[candidate[k]].volume * squared.at[k] * shape.slope.at[k];
            const Pack u = slope * (a.u - b[k]->u);
            const Pack w = slope * (a.w - b[k]->w);
            u_x += u * pair.x.at[k];
            u_z += u * pair.z.at[k];
            w_x += w * pair.x.at[k];
            w_z += w * pair.z.at[k];
          }
        });
    const Pack xx = -Shape::slope_factor * u_x;
    const Pack zz = -Shape::slope_factor * w_z;
    const Pack xz = -0.5 * Shape::slope_factor * (u_z + w_x);
    const Pack norm2 = 2.0 * (xx * xx + zz * zz) + 4.0 * (xz * xz);
    const Pack norm = norm2 * inverse_root(SideBySide<Lanes, 1>{{norm2 + least_square}}).at[0];
    const Pack eddy = 2 * work.eddy_factor * norm;
    const Pack trace = (1.0 / 3) * (xx + zz);
    const Pack isotropic = work.isotropic_factor * norm2;
    const Pack stress_xx = (eddy * (xx - trace) - isotropic) / a.density;
    const Pack stress_zz = (eddy * (zz - trace) - isotropic) / a.density;
    const Pack stress_xz = eddy * xz / a.density;
    for (int l = 0; l < cluster.count; ++l) {
      Stress& stress = work.stress[cluster.first + l];
      stress.xx = stress_xx[l];
      stress.xz = stress_xz[l];
      stress.zz = stress_zz[l];
    }
  }
}

template <class Lanes>
Found search(const Record* records, const Cluster& cluster, const IndexRange* ranges, std::size_t count, double skin,
             std::int32_t* list) {
  using Pack = typename Lanes::Pack;
  const unsigned valid = (1U << cluster.count) - 1;
  Pack ax, az, ah;
  for (int l = 0; l < Lanes::width; ++l) {
    ax[l] = records[cluster.first + l].x;
    az[l] = records[cluster.first + l].z;
    ah[l] = records[cluster.first + l].smoothing;
  }
  Found found;
  for (std::size_t r = 0; r < count; ++r) {
    for (std::int32_t j = ranges[r].begin; j < ranges[r].end; ++j) {
      const Record& b = records[j];
      const Pack x = ax - b.x;
      const Pack z = az - b.z;
      const Pack square = x * x + z * z;
      const Pack width = ah + b.smoothing;
      const Pack reach = width + skin;
      const bool near = (Lanes::less(square, reach * reach) & valid) != 0;
      list[found.candidates] = j;
      found.candidates += near ? 1 : 0;
      found.pairs += __builtin_popcount(Lanes::less(square, width * width) & valid);
    }
  }
  return found;
}

template <class Lanes, class Kernel, bool limited>
PairLoop fluid_loop(Friction friction) {
  switch (friction) {
    case Friction::none:
      return fluid_rates<Lanes, Kernel, Friction::none, limited>;
    case Friction::artificial:
      return fluid_rates<Lanes, Kernel, Friction::artificial, limited>;
    case Friction::laminar:
      return fluid_rates<Lanes, Kernel, Friction::laminar, limited>;
    case Friction::turbulent:
      return fluid_rates<Lanes, Kernel, Friction::turbulent, limited>;
  }
  return nullptr;
}

template <class Lanes>
constexpr PairLoops loops_of() {
  return {
      .lanes = static_cast<std::size_t>(Lanes::width),
      .fluid =
          [](KernelName kernel, Friction friction, bool limited) {
            if (kernel == KernelName::cubic_spline) {
              return limited ? fluid_loop<Lanes, CubicSpline, true>(friction)
                             : fluid_loop<Lanes, CubicSpline, false>(friction);
            }
            return limited ? fluid_loop<Lanes, WendlandC2, true>(friction)
                           : fluid_loop<Lanes, WendlandC2, false>(friction);
          },
      .wall = [](KernelName kernel, bool limited) -> PairLoop {
        if (kernel == KernelName::cubic_spline) {
          return limited ? wall_rates<Lanes, CubicSpline, true> : wall_rates<Lanes, CubicSpline, false>;
        }
        return limited ? wall_rates<Lanes, WendlandC2, true> : wall_rates<Lanes, WendlandC2, false>;
      },
      .strain = [](KernelName kernel) -> PairLoop {
        return kernel == KernelName::cubic_spline ? strain_stress<Lanes, CubicSpline>
                                                  : strain_stress<Lanes, WendlandC2>;
      },
      .density_gradient = [](KernelName kernel) -> DiffusionLoop {
        return kernel == KernelName::cubic_spline ? density_gradient<Lanes, CubicSpline>
                                                  : density_gradient<Lanes, WendlandC2>;
      },
      .diffusion = [](KernelName kernel) -> DiffusionLoop {
        return kernel == KernelName::cubic_spline ? density_diffusion<Lanes, CubicSpline>
                                                  : density_diffusion<Lanes, WendlandC2>;
      },
      .surface = [](KernelName kernel) -> ShiftLoop {
        return kernel == KernelName::cubic_spline ? find_surface<Lanes, CubicSpline> : find_surface<Lanes, WendlandC2>;
      },
      .shift = [](KernelName kernel) -> ShiftLoop {
        return kernel == KernelName::cubic_spline ? shift<Lanes, CubicSpline> : shift<Lanes, WendlandC2>;
      },
      .wall_pressure = [](KernelName kernel) -> WallPressureLoop {
        return kernel == KernelName::cubic_spline ? wall_pressure<Lanes, CubicSpline>
                                                  : wall_pressure<Lanes, WendlandC2>;
      },
      .filter = [](KernelName kernel) -> FilterLoop {
        return kernel == KernelName::cubic_spline ? filter_moments<Lanes, CubicSpline>
                                                  : filter_moments<Lanes, WendlandC2>;
      },
      .search = search<Lanes>,
  };
}

}  // namespace seiche::wcsph
