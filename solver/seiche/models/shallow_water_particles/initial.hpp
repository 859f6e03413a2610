/// Initial particles: edges first, then masses and velocities as exact integrals.
///
/// An edge belongs exactly on every initial discontinuity. Equal masses resolve shallow water finer than equal widths
/// and are the better choice at equal N; equal widths are the choice of the source's figures.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

using Function = std::function<double(double)>;

/// Uniform water between `left` and `right`.
struct Stretch {
  double left = 0;
  double right = 0;
  shallow_water::State state;
};

/// `count` + 1 edges of equal spacing over [left, right].
Array equal_width_edges(double left, double right, std::size_t count);

/// Edges such that every particle holds the same mass of h(x) over [left, right]; `mass_up_to(x)` is the integral of h
/// from `left`, increasing. Bisection to round-off. An edge is then moved onto each of `discontinuities`: the nearest
/// inner edge that is not taken yet. Throws std::invalid_argument if a discontinuity lies outside or too few edges.
Array equal_mass_edges(const Function& mass_up_to, double left, double right, std::size_t count,
                       const std::vector<double>& discontinuities = {});

/// Particles with masses and momenta from primitives of h and h u: differences of the primitives at the edges.
Particles particles_from_primitives(Array edges, const Function& mass_up_to, const Function& momentum_up_to);

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
