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

  SEICHE_INLINE Separation(const Block<Lanes>& a, const typename Lanes::Record* const (&b)[abreast]) {
    x = Values::of([&](int k) { return Lanes::distances(a.x, b[k]->x, a.place_unit); });
    z = Values::of([&](int k) { return Lanes::distances(a.z, b[k]->z, a.place_unit); });
    const Values square = x * x + (z * z + Lanes::least_square);
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

/// Largest (c + sigma)/h of the particles of a cluster, sigma of its pairs given.
template <class Lanes>
SEICHE_INLINE typename Lanes::Scalar largest_limit(const RateWork<typename Lanes::Record>& work, const Block<Lanes>& a,
                                                   typename Lanes::Pack sigma, const Cluster& cluster) {
  using Scalar = typename Lanes::Scalar;
  const auto per_scale = static_cast<Scalar>(1 / work.sound_scale);
  const typename Lanes::Pack limit = (a.sound * per_scale + Scalar(0.5) * sigma) / a.smoothing;
  Scalar largest = 0;
  for (int l = 0; l < cluster.count; ++l) {
    if (limit[l] > largest) largest = limit[l];
  }
  return static_cast<Scalar>(work.per_length) * largest;
}

template <class Lanes, class Kernel, Friction friction, bool limited>
void fluid_rates(const RateWork<typename Lanes::Record>& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first, work.place_unit);
    Pack xx{}, xz{}, zz{};
    if constexpr (friction == Friction::turbulent) {
      for (int l = 0; l < Lanes::width; ++l) {
        const auto& stress = work.stress[cluster.first + l];
        xx[l] = stress.xx;
        xz[l] = stress.xz;
        zz[l] = stress.zz;
      }
    }
    Sum<Lanes> du, dw, ddensity, smooth_u, smooth_w;
    Pack sigma{};
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
          ddensity.add(slope, approach);
          du.subtract(push, pair.x);
          dw.subtract(push, pair.z);
          smooth_u.add(weight, u);
          smooth_w.add(weight, w);
          if constexpr (friction == Friction::laminar || friction == Friction::turbulent) {
            const Values square = pair.x * pair.x + pair.z * pair.z;
            const double viscosity = 4 * work.kinematic_viscosity * work.per_length;
            const Values drag = viscosity * square * (pair.viscous * pair.inverse_width) * slope;
            du.add(drag, u);
            dw.add(drag, w);
          }
          if constexpr (friction == Friction::turbulent) {
            const Values sum_xz = Values::of([&](int k) { return xz + work.stress[candidate[k]].xz; });
            du.add(slope, Values::of([&](int k) {
                     return (xx + work.stress[candidate[k]].xx) * pair.x.at[k] + sum_xz.at[k] * pair.z.at[k];
                   }));
            dw.add(slope, Values::of([&](int k) {
                     return sum_xz.at[k] * pair.x.at[k] + (zz + work.stress[candidate[k]].zz) * pair.z.at[k];
                   }));
          }
          if constexpr (limited) {
            for (int k = 0; k < abreast; ++k) {
              const Pack rate = magnitude<Lanes>(approach.at[k]) * (pair.viscous.at[k] * (a.density + b[k]->density));
              sigma = Lanes::largest(sigma, Lanes::where_less(pair.s.at[k], 1, rate));
            }
          }
        });
    // Deferred constants; densities were sums, not means.
    const double xsph = 2 * work.xsph * Shape::weight_factor;
    const double slope_factor = Shape::slope_factor * work.per_length;
    store<Lanes>(a.u - smooth_u.times(xsph), work.dx, cluster);
    store<Lanes>(a.w - smooth_w.times(xsph), work.dz, cluster);
    store<Lanes>(du.times(slope_factor), work.du, cluster);
    store<Lanes>(dw.times(slope_factor) - static_cast<typename Lanes::Scalar>(work.gravity), work.dw, cluster);
    store<Lanes>(ddensity.times(slope_factor * work.density_unit), work.ddensity, cluster);
    if constexpr (limited) work.limit[c] = largest_limit<Lanes>(work, a, sigma, cluster);
  }
}

template <class Lanes, class Kernel, bool limited>
void wall_rates(const RateWork<typename Lanes::Record>& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    Sum<Lanes> ddensity;
    Pack sigma{};
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first, work.place_unit);
    visit_candidates<Kernel, Separation<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values approach =
              Values::of([&](int k) { return pair.x.at[k] * (a.u - b[k]->u) + pair.z.at[k] * (a.w - b[k]->w); });
          const Values slope = Values::of([&](int k) {
            const Pack inverse_width = pair.inverse_width.at[k];
            return work.mass[candidate[k]] * (inverse_width * inverse_width) * shape.slope.at[k];
          });
          ddensity.add(slope, approach);
          if constexpr (limited) {
            for (int k = 0; k < abreast; ++k) {
              const Pack rate = magnitude<Lanes>(approach.at[k]) * (pair.viscous.at[k] * (a.density + b[k]->density));
              sigma = Lanes::largest(sigma, Lanes::where_less(pair.s.at[k], 1, rate));
            }
          }
        });
    store<Lanes>(ddensity.times(Shape::slope_factor * work.per_length * work.density_unit), work.ddensity, cluster);
    if constexpr (limited) work.limit[c] = largest_limit<Lanes>(work, a, sigma, cluster);
  }
}

/// tau/rho = 2 nu_t (S - (1/3) tr S) - (2/3) C_I Delta^2 |S|^2, nu_t = (C_S Delta)^2 |S|, |S| = sqrt(2 S:S).
template <class Lanes, class Kernel>
void strain_stress(const RateWork<typename Lanes::Record>& work, std::size_t first, std::size_t last) {
  using Pack = typename Lanes::Pack;
  using Scalar = typename Lanes::Scalar;
  using Values = SideBySide<Lanes, abreast>;
  using Shape = LaneKernel<Values, Kernel>;
  for (std::size_t c = first; c < last; ++c) {
    const Cluster cluster = work.clusters[c];
    const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first, work.place_unit);
    Sum<Lanes> u_x, u_z, w_x, w_z;
    visit_candidates<Kernel, Distance<Lanes>>(
        work.records, cluster, a,
        [&](const std::int32_t* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values squared = pair.inverse_width * pair.inverse_width;
          const Values slope =
              Values::of([&](int k) { return work.stress[candidate[k]].volume * squared.at[k] * shape.slope.at[k]; });
          const Values u = Values::of([&](int k) { return slope.at[k] * (a.u - b[k]->u); });
          const Values w = Values::of([&](int k) { return slope.at[k] * (a.w - b[k]->w); });
          u_x.add(u, pair.x);
          u_z.add(u, pair.z);
          w_x.add(w, pair.x);
          w_z.add(w, pair.z);
        });
    const double factor = -Shape::slope_factor * work.per_length;
    const Pack xx = u_x.times(factor);
    const Pack zz = w_z.times(factor);
    const Pack xz = u_z.plus(w_x).times(0.5 * factor);
    const Pack norm2 = Scalar(2) * (xx * xx + zz * zz) + Scalar(4) * (xz * xz);
    const Pack norm = norm2 * inverse_root(SideBySide<Lanes, 1>{{norm2 + Scalar(Lanes::least_square)}}).at[0];
    const Pack eddy = Scalar(2 * work.eddy_factor) * norm;
    const Pack trace = Scalar(1.0 / 3) * (xx + zz);
    const Pack isotropic = Scalar(work.isotropic_factor) * norm2;
    const Pack stress_xx = (eddy * (xx - trace) - isotropic) / a.density;
    const Pack stress_zz = (eddy * (zz - trace) - isotropic) / a.density;
    const Pack stress_xz = eddy * xz / a.density;
    for (int l = 0; l < cluster.count; ++l) {
      auto& stress = work.stress[cluster.first + l];
      stress.xx = stress_xx[l];
      stress.xz = stress_xz[l];
      stress.zz = stress_zz[l];
    }
  }
}

template <class Lanes>
Found search(const SearchWork<typename Lanes::Record>& work, const Cluster& cluster, const IndexRange* ranges,
             std::size_t count, std::int32_t* list) {
  using Pack = typename Lanes::Pack;
  const unsigned valid = (1U << cluster.count) - 1;
  const Block<Lanes> a = load_block<Lanes>(work.records + cluster.first, work.place_unit);
  const auto skin = static_cast<typename Lanes::Scalar>(work.skin);
  Found found;
  for (std::size_t r = 0; r < count; ++r) {
    for (std::int32_t j = ranges[r].begin; j < ranges[r].end; ++j) {
      const typename Lanes::Record& b = work.records[j];
      const Pack x = Lanes::distances(a.x, b.x, a.place_unit);
      const Pack z = Lanes::distances(a.z, b.z, a.place_unit);
      const Pack square = x * x + z * z;
      const Pack width = a.smoothing + b.smoothing;
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
RateLoop<typename Lanes::Record> fluid_loop(Friction friction) {
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
constexpr RateLoops<typename Lanes::Record> rate_loops_of() {
  using Loop = RateLoop<typename Lanes::Record>;
  return {
      .lanes = static_cast<std::size_t>(Lanes::width),
      .fluid = [](KernelName kernel, Friction friction, bool limited) -> Loop {
        if (kernel == KernelName::cubic_spline) {
          return limited ? fluid_loop<Lanes, CubicSpline, true>(friction)
                         : fluid_loop<Lanes, CubicSpline, false>(friction);
        }
        return limited ? fluid_loop<Lanes, WendlandC2, true>(friction) : fluid_loop<Lanes, WendlandC2, false>(friction);
      },
      .wall = [](KernelName kernel, bool limited) -> Loop {
        if (kernel == KernelName::cubic_spline) {
          return limited ? wall_rates<Lanes, CubicSpline, true> : wall_rates<Lanes, CubicSpline, false>;
        }
        return limited ? wall_rates<Lanes, WendlandC2, true> : wall_rates<Lanes, WendlandC2, false>;
      },
      .strain = [](KernelName kernel) -> Loop {
        return kernel == KernelName::cubic_spline ? strain_stress<Lanes, CubicSpline>
                                                  : strain_stress<Lanes, WendlandC2>;
      },
      .search = search<Lanes>,
  };
}

/// @tparam Lanes  of doubles; @tparam MixedLanes  of single precision, with sums in double precision
template <class Lanes, class MixedLanes>
constexpr PairLoops loops_of() {
  return {
      .full = rate_loops_of<Lanes>(),
      .mixed = rate_loops_of<MixedLanes>(),
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
  };
}

}  // namespace seiche::wcsph
