/// The flows of seiche-parallel: what they are, and what is claimed of them.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "reports/evidence/record.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_3d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"

namespace seiche::parallel {

struct Options {
  std::string flow = "hump";
  std::size_t columns = 400;
  std::size_t rows = 200;
  std::size_t layers = 0;  ///< of hexahedra; 0: the plan model
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

/// What the run found.
struct Findings {
  long steps = 0;
  double energy = 0;
  double energy_change = 0;
  double rim_difference = 0;
};
evidence::Record begun(const Options& options);
void judge(evidence::Record& record, const Options& options, const Findings& findings);

}  // namespace seiche::parallel
