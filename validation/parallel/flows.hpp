/// The flows of seiche-parallel: what they are, and what is claimed of them.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "reports/evidence/record.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "validation/instruments/plan/oblique_wave.hpp"

namespace seiche::parallel {

struct Options {
  std::string flow = "hump";
  std::size_t columns = 400;
  std::size_t rows = 200;
  std::size_t layers = 0;  ///< of hexahedra; 0: the plan model
  double angle = 30;       ///< of a wave that is reflected [deg]
  double spacing = 0.5;    ///< of the lattice, in depths
  double amplitude = 0.2;  ///< in depths
  double time = 20;        ///< in sqrt(depth/g)
  double step = 0.2;
  double every = 0;         ///< between files; 0: one at the end
  double tolerance = 1e-9;  ///< relative residual
  std::string scheme = "one_step";
  std::filesystem::path out = "seiche-parallel";
};

void add_options(CLI::App& app, Options& options);

/// Throw std::invalid_argument.
dispersive_shallow_water_2d::Rectangle water(const Options& options);
dispersive_shallow_water_2d::VelocityAt velocity(const Options& options);
/// The same water in layers of hexahedra, with vertical velocities linear in the height.
lagrangian_mesh_3d::Layer layered_water(const Options& options);
lagrangian_mesh_3d::VelocityAt layered_velocity(const Options& options);

/// The lattices of these have the columns and rows that they need.
inline bool fits_itself(const Options& options) {
  return options.flow == "reflection" || options.flow == "island";
}

/// A solitary wave that meets a wall at an angle, in a window that follows it (validation/mach_reflection).
validation::ObliqueWave oblique_wave(const Options& options);
validation::ReflectionWindow reflection_window(const Options& options);
/// The conical island in 0.32 m of water (validation/instruments/plan/island_flow.hpp).
validation::ConicalIsland::Settings island(const Options& options);

/// In metres and seconds: what the options give in depths and sqrt(depth/g).
struct Units {
  double length = 1;
  double time = 1;
};
Units units(const Options& options);

/// What the run found, in depths and sqrt(depth/g).
struct Findings {
  long steps = 0;
  double energy = 0;
  double energy_change = 0;
  double energy_rise = 0;
  double rim_difference = 0;
  double ahead = 0;               ///< height of the surface at the window's front
  double wall = 0, incident = 0;  ///< heights of the reflected wave at the wall and of the incident one; NaN: not seen
  double run_up = 0;              ///< of the shoreline
};
evidence::Record begun(const Options& options);
void judge(evidence::Record& record, const Options& options, const Findings& findings);

}  // namespace seiche::parallel
