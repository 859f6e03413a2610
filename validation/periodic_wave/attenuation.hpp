/// What a way takes from a periodic wave: how it is measured, and how it is asked of other solvers and judged.
#pragma once

#include <string>
#include <vector>

#include "seiche/exact/stokes_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/periodic_wave/surface_fit.hpp"

namespace seiche::validation {

inline const std::string attenuation_source = "Schwartz (1974); Synolakis et al., Pure Appl. Geophys. 165 (2008) 2197";
/// What a wavelength may take from the height, and as much of a wavelength from the phase.
inline constexpr double per_wavelength = 0.005;
inline const std::string per_wavelength_reason =
    "0.5 % per wavelength: after ten wavelengths the 5 % that tsunami benchmarks allow against exact solutions "
    "(Synolakis et al. 2008)";

/// Depth, gravity and density 1.
exact::StokesWave wave_of(double height, double length);
double period_of(const exact::StokesWave& wave);

/// Between the instants at which a wave is looked at, in periods, or between its gauges, in wavelengths: no whole
/// number, nor half, after which a wave that stands still, or runs back, looks right.
inline constexpr double apart = 0.75;
/// All of them, up to so many.
std::vector<double> ways(long periods);

/// What a wavelength changes: slopes of straight lines through the stations.
struct Rates {
  double decay = 0;  ///< of the height, relative
  double lead = 0;   ///< in wavelengths
};

/// @param way    in wavelengths, of each
/// @param found  leads from -1/2 to 1/2, which are joined to the nearest
Rates rates_of(const std::vector<double>& way, const std::vector<Fundamental>& found);

/// The tables that others are asked for.
std::vector<WantedTable> wanted_waves(const Values& values);
void judge_waves(const Values& values, const Submitted& submitted, const SolverFacts& facts, evidence::Record& record);

}  // namespace seiche::validation
