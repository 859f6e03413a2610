# Debian packages by CPack: one per component of SeicheInstall.cmake; ci/package makes them. The version is the project's.
#
# Programs depend on the libraries that dpkg-shlibdeps finds in them. What is listed here is what it cannot see: modules
# that Python imports, and packages that projects which find_package(seiche) need.
if(SEICHE_PYTHON_MODULE AND NOT Python3_EXECUTABLE STREQUAL "/usr/bin/python3")
  message(STATUS "No Debian packages from this build: they need the system's /usr/bin/python3, not ${Python3_EXECUTABLE}")
  return()
endif()
set(SEICHE_MAINTAINER "seiche developers <seiche@localhost.invalid>")
set(SEICHE_DEBIAN_REVISION 1)
set(debian_version ${PROJECT_VERSION}-${SEICHE_DEBIAN_REVISION})

# seiche_package(component package SECTION section DESCRIPTION text [DEPENDS ...] [RECOMMENDS ...] [SUGGESTS ...]):
# the first line of the text is the summary. Every package has its copyright and changelog.
set(CPACK_COMPONENTS_ALL "")
macro(seiche_package component package)
  cmake_parse_arguments(of "" "SECTION;DESCRIPTION" "DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER CPACK_DEBIAN_${component} prefix)
  set(${prefix}_PACKAGE_NAME ${package})
  set(${prefix}_PACKAGE_SECTION ${of_SECTION})
  set(${prefix}_DESCRIPTION "${of_DESCRIPTION}")
  foreach(field IN ITEMS DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN of_${field} ", " ${prefix}_PACKAGE_${field})
  endforeach()
  install(FILES ${PROJECT_BINARY_DIR}/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

string(CONCAT about
  "seiche verifies and validates solvers of free-surface flow: exact solutions,\n"
  "laboratory data and published computations, each turned into claims with a\n"
  "measured value, a limit, the reason for the limit and a verdict.\n\n")
seiche_package(command seiche SECTION science
  DEPENDS libopenblas0-serial python3 python3-numpy python3-h5py python3-matplotlib python3-jinja2 python3-markdown
          python3-jsonschema
  SUGGESTS bash-completion chromium libseiche-dev python3-seiche
  DESCRIPTION "verification and validation of water-wave solvers\n${about}This package has the command, its reference \
data, its report and examples.")
seiche_package(development libseiche-dev SECTION libdevel
  DEPENDS libboost-dev libeigen3-dev libfftw3-dev libfmt-dev libgsl-dev libhdf5-dev libpugixml-dev libsuitesparse-dev
          pkg-config
  RECOMMENDS cmake g++
  SUGGESTS seiche
  DESCRIPTION "discrete models and exact solutions of water waves (development files)\n${about}This package has the \
library of models and exact solutions, for C++\nprograms: headers, the static library and its CMake package.")
if(SEICHE_PYTHON_MODULE)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(python ${Python_VERSION_MAJOR})
  seiche_package(python python3-seiche SECTION python
    DEPENDS "python3 (>= ${python}.${Python_VERSION_MINOR})" "python3 (<< ${python}.${next_minor})" python3-numpy
    SUGGESTS python3-h5py python3-netcdf4 python3-scipy python3-vtk9 python3-xarray seiche
    DESCRIPTION "exact solutions of water waves for Python\n${about}This package has the Python module of the exact \
solutions, and a program\nthat turns results of solvers into tables.")
endif()
if(SEICHE_WITH_PETSC)
  seiche_package(parallel seiche-parallel SECTION science
    DEPENDS mpi-default-bin
    SUGGESTS seiche
    DESCRIPTION "water-wave flows on many processes\n${about}This package has the program of plan flows on many \
processes (MPI and PETSc).")
  seiche_package(distributed libseiche-distributed-dev SECTION libdevel
    DEPENDS "libseiche-dev (= ${debian_version})" libhdf5-mpi-dev mpi-default-dev petsc-dev
    DESCRIPTION "discrete models of water waves on many processes (development files)\n${about}This package has the \
models that MPI and PETSc share out among processes,\nfor C++ programs: headers and the static library.")
endif()

# Copyright and changelog of the packages.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
if(NOT licence MATCHES "^MIT License\n\nCopyright \\(c\\) ([^\n]+)\n\n(.*[^\n])\n*$")
  message(FATAL_ERROR "LICENSE is not the MIT licence that ci/debian/copyright.in stands for")
endif()
set(SEICHE_COPYRIGHT "${CMAKE_MATCH_1}")
string(REPLACE "\n" "\n " SEICHE_LICENCE "${CMAKE_MATCH_2}")
string(REPLACE "\n \n" "\n .\n" SEICHE_LICENCE "${SEICHE_LICENCE}")
configure_file(${PROJECT_SOURCE_DIR}/ci/debian/copyright.in ${PROJECT_BINARY_DIR}/debian/copyright @ONLY)
set(changelog ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz)
file(GLOB changes CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
add_custom_command(OUTPUT ${changelog} VERBATIM
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/ci/debian/changelog.py ${PROJECT_SOURCE_DIR}/CHANGELOG.md
          ${changelog} --version ${PROJECT_VERSION} --revision ${SEICHE_DEBIAN_REVISION}
          --maintainer ${SEICHE_MAINTAINER}
  DEPENDS ${PROJECT_SOURCE_DIR}/ci/debian/changelog.py ${changes})
add_custom_target(debian_changelog ALL DEPENDS ${changelog})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # would stand before every package's own
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE ${PROJECT_NAME})
set(CPACK_DEBIAN_PACKAGE_RELEASE ${SEICHE_DEBIAN_REVISION})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${SEICHE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_THREADS 0)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/ci/debian/postinst
                                               ${PROJECT_SOURCE_DIR}/ci/debian/prerm)
include(CPack)
