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

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "validation/breaking/free_particle_surface.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/polyline_distance.hpp"

namespace seiche::validation::breaking {

inline constexpr double forced_length = 2 * std::numbers::pi;
inline constexpr double depth = std::numbers::pi;
inline const std::string cauchy =
    "Longuet-Higgins & Cokelet, Proc. R. Soc. A 350 (1976) 1: potential flow, computed by Cauchy's integral";

/// The surface at one time, and potential flow where that is compared.
struct BreakingFrame {
  double time = 0;
  double crest_x = 0;
  Polyline markers, exact;         ///< of three wavelengths
  Polylines outline = {};          ///< of the particles' water; none before the exact surface has a jet
  PolylineDistance distance = {};  ///< of the two surfaces
  double limit = 0;                ///< of that
};

/// One lattice.
struct BreakingRun {
  double cell = 0;
  std::vector<BreakingFrame> frames, film;
  double crest = nan;       ///< above the bottom, at the time `at`
  double overturned = nan;  ///< first time at which the line of markers goes backwards; NaN: never
  double work = 0;          ///< of the pressure
  double balance = 0;       ///< largest defect of energy, work and loss
  double loss = 0;          ///< by the penalty
};

struct BreakingRuns {
  std::vector<BreakingRun> lattices;  ///< coarsest first
  double vertical_tangent = 0;        ///< of the exact surface
  double exact_work = 0;
  double overhang = nan;  ///< of potential flow, beside another start: see breaking_gauss.cpp

  [[nodiscard]] const BreakingRun& finest() const { return lattices.back(); }
  [[nodiscard]] double wider_crest() const { return lattices[lattices.size() - 2].crest; }
};

struct BreakingLattice {
  double cell, tau;
};

/// Of a surface on cells of this width: see above.
inline Bound near_surface(double cell) {
  return {.limit = Amount::told_by_run(2 * cell),
          .reason =
              "sagitta K h^2/8 of the exact surface's largest curvature K within a cell, half a cell at most; "
              "for a jet, half a cell plus the length over which the exact jet is thinner than a cell"};
}
/// Of an rms distance over that on cells twice as wide.
inline Bound nearer_on_half_cells() {
  return {.limit = std::pow(0.5, 1.5),
          .reason = "second order in the cell width, with half an order allowed for the random shifts"};
}
/// @param late  by how much the results' front is vertical later than the exact one
template <class Results, class Late>
void claim_vertical_front(const Claims<Results>& claims, Late late, double limit) {
  claims.check(
      "vertical-tangent",
      "The time of the first vertical front agrees with potential flow within one step and the time that the wave "
      "takes for half a cell.",
      "time at which the line of markers first overhangs, minus the exact time [(g k)^(-1/2)]", late,
      Bound{.limit = limit,
            .reason = "the front position is known to half a cell, which the wave travels in that time, and is checked "
                      "after every step"});
}

/// Potential flow at the frame's time; the wavelength is 2 pi, in units of 1/k, g and the density.
void compare(BreakingFrame& frame, const exact::PressureForcedWave& exact, const gauss_particles::Flow& flow,
             double cell, double spacing);

/// Claims of the finest lattice, and of the coarsest against it.
/// @param times  of the frames;  @param steepest  the frame at which lattices are compared, before the front is
/// vertical
/// @param speed  of the wave before it is pushed
void claim_potential_flow(const Claims<BreakingRuns>& claims, const std::vector<double>& times, std::size_t steepest,
                          BreakingLattice finest, double speed);

/// Distances of all lattices at all frames.
void tabulate(evidence::Exhibit& exhibit, const BreakingRuns& runs);

}  // namespace seiche::validation::breaking
