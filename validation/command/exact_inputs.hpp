/// An exact solution as the initial state, or the paddle, of another solver.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "seiche/exact/catalogue.hpp"
#include "validation/command/commands.hpp"

namespace seiche::command {

/// Names that --write takes.
const std::vector<std::string>& input_formats();

/// Writes the files and returns their names.
/// @throws std::invalid_argument where the solution has not what the solver needs, and for bad options
std::vector<std::filesystem::path> write_inputs(const exact::ExactSolution& solution,
                                                const std::map<std::string, double>& parameters,
                                                const ExactOptions& options);

}  // namespace seiche::command
