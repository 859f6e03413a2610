/// How far a computed profile is from an exact one: three measures that answer different questions.
///
///   cell  mean-value error per particle or cell: |mean - exact mean|. The one for orders of convergence.
///   rec   reconstruction against exact, pointwise: what a user of the reconstructed profile gets.
///   pc    piecewise constant against exact: the only one comparable with a picture of rectangles; its Linf at a jump
///   is
///         of the size of the jump for every scheme.
///
/// L1 and L2 are divided by the length (its root); means of velocity are mass means.
#pragma once

#include <functional>
#include <vector>

#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water {

struct Norms {
  double l1 = 0;
  double l2 = 0;
  double linf = 0;
};

struct ProfileError {
  Norms depth;
  Norms velocity;
};

/// `breaks`: positions of discontinuities and kinks of the exact profile; integrals are split there and are otherwise
/// sums of 32 or more points per cell, exact up to quadrature error. Velocity counts where the exact depth is positive.
ProfileError cell_error(const MeasuredProfile& profile, const ExactProfile& exact,
                        const std::vector<double>& breaks = {});
ProfileError piecewise_constant_error(const MeasuredProfile& profile, const ExactProfile& exact,
                                      const std::vector<double>& breaks = {});
/// Throws std::invalid_argument without a reconstruction.
ProfileError reconstruction_error(const MeasuredProfile& profile, const ExactProfile& exact,
                                  const std::vector<double>& breaks = {});

/// Number of cells whose mean depth lies strictly between 5 % and 95 % of the way from `ahead` to `behind`, among those
/// that overlap [from, to].
int jump_width(const MeasuredProfile& profile, double behind, double ahead, double from, double to);

/// Position where a step from depth `behind` (left) to `ahead` (right) would hold the same volume between the edges
/// nearest to `from` and `to`: the volume-true position of a smeared jump.
double jump_position(const MeasuredProfile& profile, double behind, double ahead, double from, double to);

}  // namespace seiche::shallow_water
