/// The rates of change and the search for candidates, for one kind of lanes; included by each version after its target
/// is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/correction_sums.hpp"
#include "seiche/models/wcsph/lanes.hpp"

namespace seiche::wcsph {

/// eta^2 = 0.01 h_ab^2 in terms of h_a + h_b.
inline constexpr double softening = 0.0025;

/// What depends on the places, smoothing lengths and densities of pairs.
template <class Lanes>
struct Separation {
  using Values = SideBySide<Lanes>;
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

/// The rates of change of a cluster.
template <class Lanes, class Kernel>
struct RateSums {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes>;
  using Shape = LaneKernel<Values, Kernel>;

  /// Adds a b of each candidate.
  SEICHE_INLINE static void add(Pack& sum, const Values& a, const Values& b) {
    for (int k = 0; k < abreast; ++k) sum += a.at[k] * b.at[k];
  }

  /// c of (5) for gamma = 7 without powers, times sound_scale.
  template <class Value>
  SEICHE_INLINE static Value sound(const PairWork& work, Value density) {
    const Value s = density * work.inverse_density;
    return work.sound_speed * (s * s * s);
  }

  /// Takes sigma of the next candidates into account: a pair counts within its support.
  template <class Records>
  SEICHE_INLINE static void add_limit(Pack& sigma, const Block<Lanes>& a, const Records& b,
                                      const Separation<Lanes>& pair, const Values& approach) {
    for (int k = 0; k < abreast; ++k) {
      const Pack speed = larger(approach.at[k], -approach.at[k]);
      const Pack rate = speed * (pair.viscous.at[k] * (a.density + b[k]->density));
      sigma = larger(sigma, where_less(pair.s.at[k], 1, rate));
    }
  }

  /// Largest (c + sigma)/h of the particles of a cluster, sigma of its pairs given.
  SEICHE_INLINE static double largest_limit(const PairWork& work, const Block<Lanes>& a, Pack sigma) {
    const double per_scale = 1 / work.sound_scale;
    const Pack limit = (sound(work, a.density) * per_scale + 0.5 * sigma) / a.smoothing;
    double largest = 0;
    for (int l = 0; l < a.count; ++l) {
      if (limit[l] > largest) largest = limit[l];
    }
    return largest;
  }

  template <Friction friction>
  static void fluid_rates(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack xx{}, xz{}, zz{};
    if constexpr (friction == Friction::turbulent) {
      for (int l = 0; l < Lanes::width; ++l) {
        const auto& stress = work.stress[a.first + l];
        xx[l] = stress.xx;
        xz[l] = stress.xz;
        zz[l] = stress.zz;
      }
    }
    const Pack own_sound = sound(work, a.density);
    Pack du{}, dw{}, ddensity{}, smooth_u{}, smooth_w{}, sigma{};
    visit<Kernel, Separation>(
        work, a, [&]([[maybe_unused]] const auto* candidate, const auto& b, const auto& pair, const auto& shape) {
          const Values u = Values::of([&](int k) { return a.u - b[k]->u; });
          const Values w = Values::of([&](int k) { return a.w - b[k]->w; });
          const Values approach = pair.x * u + pair.z * w;
          const Values squared = pair.inverse_width * pair.inverse_width;
          const Values scaled_mass = Values::of([&](int k) { return b[k]->mass * squared.at[k]; });
          const Values slope = scaled_mass * shape.slope;
          const Values weight = scaled_mass * pair.inverse_densities * shape.weight;
          Values pressures = Values::of([&](int k) { return a.pressure + b[k]->pressure; });
          if constexpr (friction == Friction::artificial) {
            const Values sounds = Values::of([&](int k) { return own_sound + sound(work, b[k]->density); });
            pressures = pressures + sounds * negative(approach) * pair.viscous;
          }
          const Values push = pressures * slope;
          add(ddensity, slope, approach);
          add(smooth_u, weight, u);
          add(smooth_w, weight, w);
          Values drag;
          if constexpr (friction == Friction::laminar || friction == Friction::turbulent) {
            const Values square = pair.x * pair.x + pair.z * pair.z;
            const double viscosity = 4 * work.kinematic_viscosity;
            drag = viscosity * square * (pair.viscous * pair.inverse_width) * slope;
          }
          // Candidate by candidate: where a group of them begins shall not matter.
          for (int k = 0; k < abreast; ++k) {
            du -= push.at[k] * pair.x.at[k];
            dw -= push.at[k] * pair.z.at[k];
            if constexpr (friction == Friction::laminar || friction == Friction::turbulent) {
              du += drag.at[k] * u.at[k];
              dw += drag.at[k] * w.at[k];
            }
            if constexpr (friction == Friction::turbulent) {
              const Stress& stress = work.stress[candidate[k]];
              const Pack sum_xz = xz + stress.xz;
              du += slope.at[k] * ((xx + stress.xx) * pair.x.at[k] + sum_xz * pair.z.at[k]);
              dw += slope.at[k] * (sum_xz * pair.x.at[k] + (zz + stress.zz) * pair.z.at[k]);
            }
          }
          if (work.limit != nullptr) add_limit(sigma, a, b, pair, approach);
        });
    // Deferred constants; densities were sums, not means.
    const double xsph = 2 * work.xsph * Shape::weight_factor;
    a.store(a.u - xsph * smooth_u, work.dx);
    a.store(a.w - xsph * smooth_w, work.dz);
    a.store(Shape::slope_factor * du, work.du);
    a.store(Shape::slope_factor * dw - work.gravity, work.dw);
    a.store(Shape::slope_factor * ddensity, work.ddensity);
    if (work.limit != nullptr) work.limit[c] = largest_limit(work, a, sigma);
  }

  static void wall_rates(const PairWork& work, std::size_t c) {
    Pack ddensity{}, sigma{};
    const Block<Lanes> a(work.records, work.clusters[c]);
    visit<Kernel, Separation>(work, a, [&](const auto*, const auto& b, const auto& pair, const auto& shape) {
      const Values approach =
          Values::of([&](int k) { return pair.x.at[k] * (a.u - b[k]->u) + pair.z.at[k] * (a.w - b[k]->w); });
      const Values slope = Values::of([&](int k) {
        const Pack inverse_width = pair.inverse_width.at[k];
        return b[k]->mass * (inverse_width * inverse_width) * shape.slope.at[k];
      });
      add(ddensity, slope, approach);
      if (work.limit != nullptr) add_limit(sigma, a, b, pair, approach);
    });
    a.store(Shape::slope_factor * ddensity, work.ddensity);
    if (work.limit != nullptr) work.limit[c] = largest_limit(work, a, sigma);
  }

  /// tau/rho = 2 nu_t (S - (1/3) tr S) - (2/3) C_I Delta^2 |S|^2, nu_t = (C_S Delta)^2 |S|, |S| = sqrt(2 S:S).
  static void strain_stress(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack u_x{}, u_z{}, w_x{}, w_z{};
    visit<Kernel, Distance>(work, a, [&](const auto* candidate, const auto& b, const auto& pair, const auto& shape) {
      const Values squared = pair.inverse_width * pair.inverse_width;
      const Values slope =
          Values::of([&](int k) { return work.stress[candidate[k]].volume * squared.at[k] * shape.slope.at[k]; });
      const Values u = Values::of([&](int k) { return slope.at[k] * (a.u - b[k]->u); });
      const Values w = Values::of([&](int k) { return slope.at[k] * (a.w - b[k]->w); });
      add(u_x, u, pair.x);
      add(u_z, u, pair.z);
      add(w_x, w, pair.x);
      add(w_z, w, pair.z);
    });
    constexpr double factor = -Shape::slope_factor;
    const Pack xx = factor * u_x;
    const Pack zz = factor * w_z;
    const Pack xz = (0.5 * factor) * (u_z + w_x);
    const Pack norm2 = 2.0 * (xx * xx + zz * zz) + 4.0 * (xz * xz);
    const Pack norm = norm2 * inverse_root(SideBySide<Lanes, 1>{{norm2 + least_square}}).at[0];
    const Pack eddy = (2 * work.eddy_factor) * norm;
    const Pack trace = (1.0 / 3) * (xx + zz);
    const Pack isotropic = work.isotropic_factor * norm2;
    const Pack stress_xx = (eddy * (xx - trace) - isotropic) / a.density;
    const Pack stress_zz = (eddy * (zz - trace) - isotropic) / a.density;
    const Pack stress_xz = eddy * xz / a.density;
    for (int l = 0; l < a.count; ++l) {
      auto& stress = work.stress[a.first + l];
      stress.xx = stress_xx[l];
      stress.xz = stress_xz[l];
      stress.zz = stress_zz[l];
    }
  }
};

template <class Lanes>
Found search(const Record* records, double skin, const Cluster& cluster, const IndexRange* ranges, std::size_t count,
             std::int32_t* list) {
  using Pack = typename Lanes::Pack;
  const unsigned valid = (1U << cluster.count) - 1;
  const Block<Lanes> a(records, cluster);
  Found found;
  for (std::size_t r = 0; r < count; ++r) {
    for (std::int32_t j = ranges[r].begin; j < ranges[r].end; ++j) {
      const Record& b = records[j];
      const Pack x = a.x - b.x;
      const Pack z = a.z - b.z;
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

/// Clusters first, ..., last - 1, one after the other.
template <void (*sum)(const PairWork& work, std::size_t cluster)>
void clusters(const PairWork& work, std::size_t first, std::size_t last) {
  for (std::size_t c = first; c < last; ++c) sum(work, c);
}

template <class Lanes, class Kernel>
constexpr PairLoops loops_of() {
  using Rates = RateSums<Lanes, Kernel>;
  using Corrections = CorrectionSums<Lanes, Kernel>;
  return {.lanes = static_cast<std::size_t>(Lanes::width),
          .search = search<Lanes>,
          .fluid = {clusters<Rates::template fluid_rates<Friction::none>>,
                    clusters<Rates::template fluid_rates<Friction::artificial>>,
                    clusters<Rates::template fluid_rates<Friction::laminar>>,
                    clusters<Rates::template fluid_rates<Friction::turbulent>>},
          .wall = clusters<Rates::wall_rates>,
          .strain = clusters<Rates::strain_stress>,
          .density_gradient = clusters<Corrections::density_gradient>,
          .diffusion = clusters<Corrections::density_diffusion>,
          .surface = clusters<Corrections::find_surface>,
          .shift = clusters<Corrections::shift>,
          .wall_pressure = clusters<Corrections::wall_pressure>,
          .filter = clusters<Corrections::filter_moments>};
}

}  // namespace seiche::wcsph
