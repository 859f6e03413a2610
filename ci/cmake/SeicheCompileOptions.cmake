# What every target of the project is compiled with. `seiche_options` is never installed.
add_library(seiche_options INTERFACE)
set(shadow -Wshadow)
if(CMAKE_UNITY_BUILD)  # files that are compiled together see each other's constants
  set(shadow -Wshadow=local)
endif()
target_compile_features(seiche_options INTERFACE cxx_std_20)
target_compile_options(seiche_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion ${shadow}
  # Designated initialisers leave out what has a default.
  -Wno-missing-field-initializers
  # Honours `#pragma omp simd` without a threading runtime.
  -fopenmp-simd
  # sqrt and comparisons vectorise without these two; both keep IEEE results (unlike -ffast-math, never used here).
  -fno-math-errno -fno-trapping-math
  # __FILE__ and source_location relative to the project, so that builds in different folders give the same bytes.
  -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 sees overlaps in `"text" + std::string` that are not there (GCC bug 105651), and reads of uninitialised
  # memory where Boost.Odeint copies a stepper and where sanitizers instrument std::variant; from a precompiled header
  # it also says what it keeps to itself of system headers (GCC bug 105329).
  target_compile_options(seiche_options INTERFACE
    -Wno-restrict -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# Products of Eigen's matrices would open threads of their own beside those that the models are told to use.
target_compile_definitions(seiche_options INTERFACE EIGEN_DONT_PARALLELIZE)
target_include_directories(seiche_options INTERFACE ${PROJECT_SOURCE_DIR})
# Everywhere alike: a precompiled header serves only what is compiled with the same options.
target_compile_options(seiche_options INTERFACE -fPIC)
target_link_libraries(seiche_options INTERFACE fmt::fmt OpenMP::OpenMP_CXX)

if(SEICHE_WARNINGS_AS_ERRORS)
  target_compile_options(seiche_options INTERFACE -Werror)
endif()
if(SEICHE_NATIVE)
  target_compile_options(seiche_options INTERFACE -march=native)
endif()
set(outsiders "")  # what a program outside this build needs beside an instrumented library
if(SEICHE_SANITIZE)
  string(APPEND outsiders "-fsanitize=${SEICHE_SANITIZE} ")
  target_compile_options(seiche_options INTERFACE
    -fsanitize=${SEICHE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(seiche_options INTERFACE -fsanitize=${SEICHE_SANITIZE})
  if(SEICHE_SANITIZE MATCHES thread)
    target_compile_definitions(seiche_options INTERFACE SEICHE_THREADS_FROM=64)
  endif()
endif()
if(SEICHE_COVERAGE)
  string(APPEND outsiders "--coverage")
  # Atomic counters, GCC's choice beside threads, cost five times the time of the loops that they count.
  target_compile_options(seiche_options INTERFACE --coverage -fprofile-update=single)
  target_link_options(seiche_options INTERFACE --coverage)
endif()
string(STRIP "${outsiders}" outsiders)  # the cache keeps a space at an end in quotes
set(SEICHE_OUTSIDERS_FLAGS "${outsiders}" CACHE INTERNAL "Flags of programs that link to the installed library")

# Cases, tests and the command hold no inner loops: half the time of compiling.
add_library(seiche_light_options INTERFACE)
target_compile_options(seiche_light_options INTERFACE $<$<CONFIG:Release>:-O1>)

# seiche_precompiled(target header...): precompiled headers, the standard ones and more, for every target that says
# REUSE_FROM target. That target has no macros but the common ones: the compiler refuses a precompiled header where one
# of its macros is missing.
function(seiche_precompiled target)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/empty.cpp CONTENT "")
  add_library(${target} OBJECT ${PROJECT_BINARY_DIR}/empty.cpp)
  target_link_libraries(${target} PRIVATE seiche_options)
  target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/ci/cmake/standard_headers.hpp ${ARGN})
endfunction()
seiche_precompiled(seiche_standard_headers)

# What records say of the build.
set(SEICHE_CATCH2_VERSION ${Catch2_VERSION})
get_target_property(options seiche_options INTERFACE_COMPILE_OPTIONS)
list(FILTER options EXCLUDE REGEX "prefix-map")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
list(JOIN options " " options)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${options}" SEICHE_FLAGS)
# What decides numbers beside the sources and the parameters.
set(SEICHE_TOOLCHAIN "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${SEICHE_FLAGS} Eigen ${Eigen3_VERSION} \
Boost ${Boost_VERSION} GSL ${GSL_VERSION} HDF5 ${HDF5_VERSION} FFTW ${FFTW_fftw3_VERSION} fmt ${fmt_VERSION}")
