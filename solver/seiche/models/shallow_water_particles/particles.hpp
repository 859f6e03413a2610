/// A row of touching particles: particle i is the rectangle between edges i and i+1 and carries a constant mass.
///
/// Edges are the unknowns, not centres and widths: particles touch by construction, each is symmetric about its own
/// position, and the sawtooth mode of a centre-and-width description cannot exist.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <boost/align/aligned_allocator.hpp>

#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

/// Its data start on a cache line, for full-width vector loads.
using Array = std::vector<double, boost::alignment::aligned_allocator<double, 64>>;

/// State of the row at one instant.
struct Particles {
  Array edge;      ///< N + 1 positions [m], strictly increasing
  Array mass;      ///< N masses per width and density [m^2], positive
  Array velocity;  ///< N mass-mean velocities [m/s]

  [[nodiscard]] std::size_t size() const { return mass.size(); }
  [[nodiscard]] double width(std::size_t i) const { return edge[i + 1] - edge[i]; }
  [[nodiscard]] double depth(std::size_t i) const { return mass[i] / width(i); }
  [[nodiscard]] double centre(std::size_t i) const { return 0.5 * (edge[i] + edge[i + 1]); }

  /// Throws std::invalid_argument unless there are at least 4 particles, sizes agree, every number is finite, edges
  /// increase strictly and masses are positive (a dry region is the absence of particles).
  void validate() const;
};

/// Sum of m u [m^3/s].
double total_momentum(std::span<const double> mass, std::span<const double> velocity);

// Initial particles: edges first, then masses and velocities as exact integrals.
//
// An edge belongs exactly on every initial discontinuity. Equal masses resolve shallow water finer than equal widths
// and are the better choice at equal N; equal widths are the choice of the source's figures.

using Function = std::function<double(double)>;

/// Uniform water between `left` and `right`.
struct Stretch {
  double left, right;
  shallow_water::State state;
};

/// `count` + 1 edges of equal spacing over [left, right].
Array equal_width_edges(double left, double right, std::size_t count);

/// Particles with masses and momenta by Gauss quadrature (5 points in 8 parts of each particle) of depth and velocity,
/// which must be smooth inside each particle.
Particles particles_from_profile(Array edges, const Function& depth, const Function& velocity);

/// Uniform stretches that touch, with `count` particles altogether: widths (or masses) as equal as whole numbers of
/// particles per stretch allow, edges exactly on the boundaries.
Particles uniform_stretches(const std::vector<Stretch>& stretches, std::size_t count, bool equal_masses = false);

/// Dam break: state `left` over [start, dam], `right` over [dam, end].
Particles dam_break(double start, double dam, double end, shallow_water::State left, shallow_water::State right,
                    std::size_t count, bool equal_masses = false);

/// A jump (bore) from depth `behind` down to `ahead` at x = `jump`, water ahead at rest, right-moving. Throws
/// std::invalid_argument unless behind > ahead: the opposite would create energy.
Particles bore(double gravity, double start, double jump, double end, double behind, double ahead, std::size_t count,
               bool equal_masses = false);

}  // namespace seiche::shallow_water_particles
