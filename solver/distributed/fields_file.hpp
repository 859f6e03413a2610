/// Numbers at the nodes of a lattice, written to one HDF5 file by all processes together.
///
/// Every number becomes a one-dimensional dataset of (columns + 1)(rows + 1) values, row by row, with `name`, `unit`
/// and `meaning`; the file's root has the attributes `columns`, `rows` and `time`. The file appears when it is whole.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "distributed/decomposition.hpp"

namespace seiche::distributed {

struct Field {
  std::string name;
  std::string unit;
  std::string meaning;
  std::span<const double> values;  ///< at the nodes of the patch
};

/// All processes call it. Throws PetscFailure, std::runtime_error with the path.
void write_fields(Decomposition& decomposition, const std::vector<Field>& fields, double time,
                  const std::filesystem::path& target);

}  // namespace seiche::distributed
