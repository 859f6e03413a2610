/// Sums of what corrects the rates now and then, for one kind of lanes: density diffusion, density filter, particle
/// shifting, walls' pressures (formulas in right_hand_side.hpp); included by pair_sums.hpp.
#pragma once

#include "seiche/models/wcsph/lanes.hpp"

namespace seiche::wcsph {

/// Below it the matrix of a particle, 1 inside the fluid, is taken as singular: 4 of about 20 neighbours on one side.
inline constexpr double least_determinant = 1e-2;

inline constexpr double repulsion = 0.2;
inline constexpr double surface_divergence = 1.5;
inline constexpr double longest_shift = 0.1;  ///< over dx

template <class Lanes, class Kernel>
struct CorrectionSums {
  using Pack = typename Lanes::Pack;
  using Values = SideBySide<Lanes>;
  using Shape = LaneKernel<Values, Kernel>;

  static void density_gradient(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack xx{}, xz{}, zz{}, difference_x{}, difference_z{};
    visit<Kernel, Distance>(work, a, [&](const auto* candidate, const auto& b, const auto& pair, const auto& shape) {
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
    for (int l = 0; l < a.count; ++l) {
      const double determinant = xx[l] * zz[l] - xz[l] * xz[l];
      DensityGradient& gradient = work.gradients[a.first + l];
      const bool singular = scale * scale * determinant < least_determinant;
      gradient.x = singular ? 0 : (xz[l] * difference_z[l] - zz[l] * difference_x[l]) / determinant;
      gradient.z = singular ? 0 : (xz[l] * difference_x[l] - xx[l] * difference_z[l]) / determinant;
    }
  }

  static void density_diffusion(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack gradient_x, gradient_z;
    for (int l = 0; l < Lanes::width; ++l) {
      const DensityGradient& gradient = work.gradients[a.first + l];
      gradient_x[l] = gradient.x;
      gradient_z[l] = gradient.z;
    }
    Pack sum{};
    visit<Kernel, Distance>(work, a, [&](const auto* candidate, const auto& b, const auto& pair, const auto& shape) {
      // h_ab/(h_a + h_b)^2: the 1/2 is deferred.
      for (int k = 0; k < abreast; ++k) {
        const DensityGradient& other = work.gradients[candidate[k]];
        // psi . grad W = slope (steep - linear), r_ba = -r_ab.
        const Pack steep = -2.0 * (b[k]->density - a.density);
        const Pack linear = (gradient_x + other.x) * pair.x.at[k] + (gradient_z + other.z) * pair.z.at[k];
        const Pack term = other.volume * pair.inverse_width.at[k] * shape.slope.at[k] * (steep - linear);
        // At r = 0 the slope is rounding over r.
        sum += where_less(-pair.s.at[k], -1e-12, term);
      }
    });
    const Pack added = (0.5 * work.diffusion * Shape::slope_factor) * sum;
    for (int l = 0; l < a.count; ++l) work.ddensity[a.first + l] += added[l];
  }

  static void filter_moments(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack a00{}, ax{}, az{}, axx{}, axz{}, azz{}, m0{}, mx{}, mz{}, within{};
    visit<Kernel, Distance>(work, a, [&](const auto*, const auto& b, const auto& pair, const auto& shape) {
      const auto weight = pair.inverse_width * pair.inverse_width * shape.weight;
      for (int k = 0; k < abreast; ++k) {
        const double mass = b[k]->mass;
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
        within += where_less(pair.s.at[k], 1.0, Pack{} + 1.0);
      }
    });
    for (int l = 0; l < a.count; ++l) {
      work.moments[a.first + l] = {a00[l], ax[l], az[l], axx[l], axz[l], azz[l], m0[l], mx[l], mz[l], within[l] - 1};
    }
  }

  static void find_surface(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack divergence{};
    visit<Kernel, Distance>(work, a, [&](const auto*, const auto& b, const auto& pair, const auto& shape) {
      const Values square = pair.x * pair.x + pair.z * pair.z;
      const Values weight = square * (pair.inverse_width * pair.inverse_width) * shape.slope;
      for (int k = 0; k < abreast; ++k) {
        divergence -= (b[k]->mass / b[k]->density) * weight.at[k];
      }
    });
    divergence *= Shape::slope_factor;
    for (int l = 0; l < a.count; ++l) {
      work.at_surface[a.first + l] = divergence[l] < surface_divergence ? 1 : 0;
    }
  }

  /// Everything is read from the records, so that particles can be changed at once.
  static void shift(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    // (2 h)^2 W(dx), without the kernel's factor.
    using One = SideBySide<Lanes, 1>;
    const Pack inverse = 0.5 / a.smoothing;
    const Pack squared_usual =
        inverse * inverse *
        LaneKernel<One, Kernel>(One{{work.spacing * inverse}}, One{{inverse}}, One{{inverse}}).weight.at[0];
    const Pack per_usual = 1.0 / squared_usual;
    Pack surface{}, crowd_x{}, crowd_z{}, u_x{}, u_z{}, w_x{}, w_z{}, density_x{}, density_z{};
    visit<Kernel, Distance>(work, a, [&](const auto* candidate, const auto& b, const auto& pair, const auto& shape) {
      const Values squared = pair.inverse_width * pair.inverse_width;
      const Values weight = squared * shape.weight;
      for (int k = 0; k < abreast; ++k) {
        const Pack volume_slope = (b[k]->mass / b[k]->density) * squared.at[k] * shape.slope.at[k];
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
        surface = larger(surface, where_less(pair.s.at[k], 1.0, marked));
      }
    });
    constexpr double scale = Shape::slope_factor;
    for (int l = 0; l < a.count; ++l) {
      if (surface[l] > 0) continue;
      const double factor = -work.travel * a.smoothing[l] * scale;
      const double length = factor * factor * (crowd_x[l] * crowd_x[l] + crowd_z[l] * crowd_z[l]);
      const double longest = longest_shift * work.spacing;
      const double limit = length > longest * longest ? longest / __builtin_sqrt(length) : 1;
      const double x = limit * factor * crowd_x[l];
      const double z = limit * factor * crowd_z[l];
      const auto i = a.first + l;
      work.x[i] += x;
      work.z[i] += z;
      work.u[i] += scale * (u_x[l] * x + u_z[l] * z);
      work.w[i] += scale * (w_x[l] * x + w_z[l] * z);
      work.density[i] += scale * (density_x[l] * x + density_z[l] * z);
    }
  }

  static void wall_pressure(const PairWork& work, std::size_t c) {
    const Block<Lanes> a(work.records, work.clusters[c]);
    Pack pressure{}, lever_x{}, lever_z{}, weights{};
    visit<Kernel, Distance>(work, a, [&](const auto*, const auto& b, const auto& pair, const auto& shape) {
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
    for (int l = 0; l < a.count; ++l) {
      const double per_weight = weights[l] > 0 ? 1 / weights[l] : 0;
      work.means[a.first + l - work.first_wall] = {pressure[l] * per_weight, lever_x[l] * per_weight,
                                                   lever_z[l] * per_weight};
    }
  }
};

}  // namespace seiche::wcsph
