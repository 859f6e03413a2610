#include "distributed/fields_file.hpp"

#include <system_error>

#include <fmt/format.h>
#include <petscviewerhdf5.h>

namespace seiche::distributed {

namespace {

void attribute(PetscViewer file, const char* object, const char* name, const std::string& text) {
  check(PetscViewerHDF5WriteAttribute(file, object, name, PETSC_STRING, text.c_str()));
}

}  // namespace

void write_fields(Decomposition& decomposition, const std::vector<Field>& fields, double time,
                  const std::filesystem::path& target) {
  std::filesystem::path partial = target;
  partial += ".part";
  {
    Viewer file;
    check(PetscViewerHDF5Open(PETSC_COMM_WORLD, partial.c_str(), FILE_MODE_WRITE, file.place()));
    for (const Field& field : fields) {
      const DistributedVector ordered = decomposition.in_order(field.values);
      check(PetscObjectSetName(reinterpret_cast<PetscObject>(static_cast<Vec>(ordered)), field.name.c_str()));
      check(VecView(ordered, file));
      attribute(file, field.name.c_str(), "name", field.name);
      attribute(file, field.name.c_str(), "unit", field.unit);
      attribute(file, field.name.c_str(), "meaning", field.meaning);
    }
    const plan_lattice::Shape lattice = decomposition.patch().lattice;
    const auto columns = static_cast<PetscInt>(lattice.columns);
    const auto rows = static_cast<PetscInt>(lattice.rows);
    check(PetscViewerHDF5WriteAttribute(file, "/", "columns", PETSC_INT, &columns));
    check(PetscViewerHDF5WriteAttribute(file, "/", "rows", PETSC_INT, &rows));
    check(PetscViewerHDF5WriteAttribute(file, "/", "time", PETSC_DOUBLE, &time));
  }
  // The viewer is closed by all before the first process renames.
  check(MPI_Barrier(PETSC_COMM_WORLD));
  std::error_code failure;
  if (rank() == 0) std::filesystem::rename(partial, target, failure);
  if (Decomposition::largest(failure ? 1.0 : 0.0) > 0) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", target.string(), failure.message()));
  }
}

}  // namespace seiche::distributed
