/// The exact solitary wave in a channel of particles of variable mass, and what is read off on its way.
/// Depth, gravity and density are 1.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {

/// Rows of the meshes of a case: those of a ladder that are coarser than its own, and its own, which is the last.
std::vector<long> rows_up_to(long own, std::span<const long> ladder);

/// Surface and velocities of the wave with its crest at a place.
variable_mass::Start solitary_start(const exact::SolitaryWave& wave, double crest);

/// The surface at one instant, in ascending x.
struct SurfaceLine {
  double time = 0;
  std::vector<double> x, y;

  /// Highest crest of a part of it; a height of NaN where there is none.
  [[nodiscard]] CurveCrest highest(double from, double to) const;
  /// Crests above a threshold of a part of it: all, and those that are the highest place within a distance.
  [[nodiscard]] std::vector<CurveCrest> crests(double threshold, double from, double to) const;
  [[nodiscard]] std::vector<CurveCrest> waves(double threshold, double apart, double from, double to) const;
  /// Top of the parabola, by least squares, through what is within a distance of a place: a crest with ripples on it.
  [[nodiscard]] double smoothed_height(double place, double within) const;
};
SurfaceLine surface_line(const variable_mass::Flow& flow);

/// What a run leaves: surfaces at equal intervals and, with them, the budget of energy over the kinetic energy of the
/// beginning.
struct SolitaryRun {
  long rows = 0;
  std::vector<SurfaceLine> surfaces;
  std::vector<double> time, kinetic, potential, dissipated;
  double energy_defect = 0;  ///< largest change of energy with what was booked, at any step
  double mass_defect = 0;    ///< largest, of the whole
  double drift = 0;          ///< largest |A_i - m_i/rho| at the end over the square of a row's height
  double seconds = 0;        ///< of processor, per step
  long steps = 0;
  long nodes = 0;

  [[nodiscard]] const SurfaceLine& last() const { return surfaces.back(); }
  /// The line nearest to a time.
  [[nodiscard]] const SurfaceLine& at(double time) const;
};

/// @param rest      the mesh of the flow under a flat surface, from which potential energies count
/// @param interval  between the surfaces that are kept
SolitaryRun follow_solitary(variable_mass::Flow& flow, const free_lagrangian::Mesh& rest, long rows, double time,
                            double tau, double interval, const std::function<void(double)>& progress = {});

}  // namespace seiche::validation
