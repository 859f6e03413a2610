/// What `seiche exact` computed, as CSV, JSON or HDF5.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seiche/exact/catalogue.hpp"

namespace seiche::command {

struct ExactResult {
  const exact::ExactSolution* solution = nullptr;
  std::map<std::string, double> parameters;
  std::vector<std::vector<double>> rows;  ///< inputs, then outputs; NaN for an input that stands for the surface
  std::vector<double> scalars;            ///< empty if they were not asked for
  std::optional<double> uncertainty;      ///< relative to the solution's own scale, where scalars were asked for
};

std::string as_csv(const ExactResult& result);
std::string as_json(const ExactResult& result);
/// One dataset per column, scalars and parameters as attributes of the root. Written atomically.
void write_hdf5(const ExactResult& result, const std::filesystem::path& file);

}  // namespace seiche::command
