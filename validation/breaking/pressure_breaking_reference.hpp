/// Free particles under Gauss's principle against potential flow: the wave that a pressure pushes until it breaks,
/// whose surface exact::PressureForcedWave knows to many digits, for the same amplitude of the pressure.
///
/// Until the exact front is vertical the line of markers is compared, afterwards the outline of the water
/// (surface_contour.hpp): markers in a jet thinner than a cell have no mass about them and fly on their own.
///
/// How far apart they may be is known beforehand. A curve of curvature K bends by K h^2/8 within a cell of width h:
/// what a space of second order in h leaves, half a cell at most. Of a jet, nothing is known where it is thinner than a
/// cell: by as much as the exact water sticks out of the discs of a cell's width that fit into it the distance may be
/// larger.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "validation/breaking/free_particle_surface.hpp"
#include "validation/case/claims.hpp"
#include "validation/instruments/polyline_distance.hpp"

namespace seiche::validation {

/// In units of 1/k, g and the density; the depth is pi.
class PressureBreakingReference {
 public:
  PressureBreakingReference(double height, double pressure);

  [[nodiscard]] const exact::PressureForcedWave& wave() const { return wave_; }
  /// One wavelength of the surface.
  [[nodiscard]] Polyline surface(double time) const;
  [[nodiscard]] bool has_jet(double time) const { return time > vertical_tangent(); }
  [[nodiscard]] double vertical_tangent() const;
  /// See above.
  [[nodiscard]] double largest_distance(double time, double cell) const;

 private:
  exact::PressureForcedWave wave_;
};

/// One lattice at one time.
struct ComparedSurface {
  double time = 0;
  PolylineDistance distance;
  double limit = 0;
  Polylines outline;  ///< of the particles' water; none before the exact surface has a jet
};

/// One lattice at all frames.
struct ComparedLattice {
  double cell = 0;
  std::vector<ComparedSurface> frames;
  double overturned = std::numeric_limits<double>::quiet_NaN();  ///< when the line of markers first goes backwards
  double work = 0;                                               ///< of the pressure
};

ComparedSurface compare(const PressureBreakingReference& reference, const gauss_particles::Flow& flow, double cell,
                        double spacing);

struct BreakingComparison {
  std::vector<ComparedLattice> lattices;  ///< coarsest first
  double vertical_tangent = 0;            ///< of the exact surface
  double work = 0;                        ///< exact

  [[nodiscard]] const ComparedLattice& finest() const { return lattices.back(); }
};

struct BreakingLattice {
  double cell, tau;
};

/// Claims of the finest lattice, and of the coarsest against it.
/// @param times  of the frames;  @param steepest  the frame at which lattices are compared, before the front is
/// vertical
/// @param speed  of the wave before it is pushed
void claim_potential_flow(const Claims<BreakingComparison>& claims, const std::vector<double>& times,
                          std::size_t steepest, BreakingLattice finest, double speed);

/// Distances of all lattices at all frames.
evidence::Table distance_table(const BreakingComparison& comparison);

}  // namespace seiche::validation
