/// An exact solution as the initial state, or the paddle, of another solver.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "seiche/exact/catalogue.hpp"

namespace seiche::command {

struct InputOptions {
  std::string format;  ///< openfoam, dualsphysics, geoclaw or vtk
  std::filesystem::path folder;
  std::string grid;
  std::vector<std::string> points;  ///< of --at; the instant
  std::string centres;              ///< OpenFOAM's field C
  std::string up = "z";
  double origin_x = 0;   ///< where the solution's x = 0 is in the solver
  double origin_up = 0;  ///< and its height 0
  double width = 1;      ///< of a strip in plan, where the solution knows no y
};

/// Names that --write takes.
const std::vector<std::string>& input_formats();

/// Writes the files and returns their names.
/// @throws std::invalid_argument where the solution has not what the solver needs, and for bad options
std::vector<std::filesystem::path> write_inputs(const exact::ExactSolution& solution,
                                                const std::map<std::string, double>& parameters,
                                                const InputOptions& options);

}  // namespace seiche::command
