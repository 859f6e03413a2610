/// PETSc as C++ sees it here: its life, owners of its objects, and errors as exceptions.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <petscdm.h>
#include <petscksp.h>

namespace seiche::distributed {

/// PETSc, or MPI or HDF5 below it, failed.
class PetscFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws PetscFailure with PETSc's own words for any code but 0.
void check(PetscErrorCode code);

/// MPI and PETSc from here to the end of the object's life. Takes PETSc's options off the command line's end: what
/// follows "--" belongs to PETSc ("-- -pc_type icc -log_view"), what precedes it to the program.
class Runtime {
 public:
  Runtime(int& argc, char** argv);
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;
  ~Runtime();

  /// For a process that cannot go on: whether all others say the same within some seconds. Where they do not, they wait
  /// for this one, or will; MPI_Abort ends them.
  [[nodiscard]] bool all_failed() const;

 private:
  MPI_Comm failures_ = MPI_COMM_NULL;  // of its own, as others may be in the middle of a reduction
};

int rank();   ///< of this process
int ranks();  ///< number of processes

/// Sole owner of a PETSc object.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Owner {
 public:
  Owner() = default;
  Owner(Owner&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owner& operator=(Owner&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;
  ~Owner() {
    if (object_ != nullptr) destroy(&object_);
  }

  operator Object() const { return object_; }  // NOLINT(google-explicit-constructor): PETSc takes handles by value
  /// Where PETSc puts a new object; there must be none yet.
  [[nodiscard]] Object* place() { return &object_; }

 private:
  Object object_ = nullptr;
};

using Grid = Owner<DM, DMDestroy>;
using DistributedVector = Owner<Vec, VecDestroy>;
using DistributedMatrix = Owner<Mat, MatDestroy>;
using KrylovSolver = Owner<KSP, KSPDestroy>;
using Scatter = Owner<VecScatter, VecScatterDestroy>;
using Viewer = Owner<PetscViewer, PetscViewerDestroy>;

}  // namespace seiche::distributed
