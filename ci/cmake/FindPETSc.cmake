# PETSc::PETSc: PETSc with MPI, double precision, real numbers and HDF5, which pkg-config knows; and MPI's launcher,
# MPIEXEC_EXECUTABLE. Only PETSc itself is linked: its parallel HDF5 must not stand for the serial one of other code.
find_package(PkgConfig QUIET)
pkg_check_modules(PETSC QUIET IMPORTED_TARGET PETSc)
find_package(MPI QUIET COMPONENTS CXX)
# petscviewerhdf5.h includes the header of the HDF5 that PETSc was built with.
find_path(PETSC_HDF5_INCLUDE_DIR hdf5.h PATHS /usr/include/hdf5/openmpi /usr/include/hdf5/mpich ${PETSC_INCLUDE_DIRS}
          NO_DEFAULT_PATH)
find_path(PETSC_CONF_DIR petscconf.h PATHS ${PETSC_INCLUDE_DIRS})
if(PETSC_CONF_DIR)
  file(STRINGS ${PETSC_CONF_DIR}/petscconf.h petsc_facts REGEX "define PETSC_(USE_REAL_DOUBLE|USE_COMPLEX|HAVE_HDF5) 1")
  if(petsc_facts MATCHES "USE_REAL_DOUBLE" AND petsc_facts MATCHES "HAVE_HDF5" AND NOT petsc_facts MATCHES "USE_COMPLEX")
    set(PETSC_FITS ON)
  endif()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PETSc
  REQUIRED_VARS PETSC_FITS PETSC_LINK_LIBRARIES PETSC_HDF5_INCLUDE_DIR MPI_CXX_FOUND VERSION_VAR PETSC_VERSION
  REASON_FAILURE_MESSAGE "ci/setup --with-petsc installs it. It must be of real numbers in double precision, with HDF5.")
if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
  add_library(PETSc::PETSc INTERFACE IMPORTED)
  target_include_directories(PETSc::PETSc SYSTEM INTERFACE ${PETSC_INCLUDE_DIRS} ${PETSC_HDF5_INCLUDE_DIR})
  target_link_libraries(PETSc::PETSc INTERFACE ${PETSC_LINK_LIBRARIES} MPI::MPI_CXX)
endif()
mark_as_advanced(PETSC_HDF5_INCLUDE_DIR PETSC_CONF_DIR)
