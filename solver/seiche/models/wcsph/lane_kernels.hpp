/// Kernels on lanes, as functions of s = r/(h_a + h_b) = q/2; internal to the pair loops.
///
///     W = weight_factor i^2 weight,   F = (1/r) dW/dr = slope_factor i^2 slope,   i = 1/(h_a + h_b)
///
/// Included by each version of the loops after its target is chosen, so nothing of the standard library is used here.
#pragma once

#include "seiche/models/wcsph/candidate_packs.hpp"
#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {

/// Values is SideBySide.
template <class Values, class Kernel>
struct LaneKernel;

template <class Values>
struct LaneKernel<Values, CubicSpline> {
  static constexpr double weight_factor = 8 * CubicSpline::factor;
  static constexpr double slope_factor = 24 * CubicSpline::factor;
  Values weight, slope;
  /// weight = outer^3 - 4 inner^3, slope = (4 inner^2 - outer^2) i/r with outer = (1-s)_+, inner = (1/2-s)_+; the
  /// factor of the cube goes into `inner`.
  SEICHE_INLINE LaneKernel(const Values& s, const Values& inverse_area, const Values& /*inverse_width*/) {
    constexpr double root = 1.5874010519681994;  // 4^(1/3)
    const Values outer = positive(1.0 - s);
    const Values inner = positive(root * outer - 0.5 * root);
    const Values outer_square = outer * outer;
    const Values inner_square = inner * inner;
    weight = outer_square * outer - inner_square * inner;
    slope = (root * inner_square - outer_square) * inverse_area;
  }
};

template <class Values>
struct LaneKernel<Values, WendlandC2> {
  static constexpr double weight_factor = 4 * WendlandC2::factor;
  static constexpr double slope_factor = -80 * WendlandC2::factor;
  Values weight, slope;
  SEICHE_INLINE LaneKernel(const Values& s, const Values& /*inverse_area*/, const Values& inverse_width) {
    const Values rest = positive(1.0 - s);
    const Values cube = rest * rest * rest;
    weight = cube * rest * (4.0 * s + 1.0);
    slope = cube * (inverse_width * inverse_width);
  }
};

}  // namespace seiche::wcsph
