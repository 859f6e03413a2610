# What `cmake --install` puts where. The components are the Debian packages of SeichePackage.cmake:
#
#   command      seiche with its renderer, reference data, examples, completion and manual
#   development  libseiche.a, its headers, find_package(seiche)
#   python       the Python module
#   parallel     seiche-parallel and its manual                                             where PETSc is there
#   distributed  libseiche_distributed.a, its headers, find_package(seiche COMPONENTS distributed)   with PETSc too
#
# Nothing installed holds a path of the source, the build or the prefix.

# seiche_install_needs(component file...): before anything is copied, so that an install is whole or does not begin.
function(seiche_install_needs component)
  foreach(file IN LISTS ARGN)
    install(CODE "if(NOT EXISTS \"${file}\")
      message(FATAL_ERROR \"${file} is not built: cmake --build ${PROJECT_BINARY_DIR} makes it\")
    endif()" COMPONENT ${component})
  endforeach()
endfunction()
seiche_install_needs(development $<TARGET_FILE:seiche>)
if(PROJECT_IS_TOP_LEVEL)
  seiche_install_needs(command $<TARGET_FILE:seiche_command> ${PROJECT_BINARY_DIR}/manual/seiche.1.gz)
  if(SEICHE_PYTHON_MODULE)
    seiche_install_needs(python $<TARGET_FILE:seiche_python>)
  endif()
  if(SEICHE_WITH_PETSC)
    seiche_install_needs(parallel $<TARGET_FILE:seiche_parallel> ${PROJECT_BINARY_DIR}/manual/seiche-parallel.1.gz)
    seiche_install_needs(distributed $<TARGET_FILE:seiche_distributed>)
  endif()
endif()

# Libraries, for projects that find_package(seiche) or that contain this one.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/seiche)
install(TARGETS seiche EXPORT seiche-targets ARCHIVE COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/solver/seiche TYPE INCLUDE COMPONENT development
        FILES_MATCHING PATTERN "*.hpp")
install(EXPORT seiche-targets NAMESPACE seiche:: DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/solver/seiche-config.cmake.in
                              ${PROJECT_BINARY_DIR}/seiche-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/seiche-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/seiche-config.cmake ${PROJECT_BINARY_DIR}/seiche-config-version.cmake
              ${PROJECT_SOURCE_DIR}/ci/cmake/FindCHOLMOD.cmake
        DESTINATION ${package_dir} COMPONENT development)
if(SEICHE_WITH_PETSC)
  install(TARGETS seiche_distributed EXPORT seiche-distributed-targets ARCHIVE COMPONENT distributed)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/solver/distributed
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/seiche_distributed
          COMPONENT distributed FILES_MATCHING PATTERN "*.hpp")
  install(EXPORT seiche-distributed-targets NAMESPACE seiche:: DESTINATION ${package_dir} COMPONENT distributed)
  install(FILES ${PROJECT_SOURCE_DIR}/ci/cmake/FindPETSc.cmake DESTINATION ${package_dir} COMPONENT distributed)
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# What the command needs beside itself, in share/seiche and not in CMAKE_INSTALL_DATADIR: the command looks there
# (validation/case/data_folder.hpp). In the build tree it finds links to the source in the same place.
if(NOT CMAKE_INSTALL_BINDIR MATCHES "^[^/]+$")
  message(FATAL_ERROR "CMAKE_INSTALL_BINDIR is ${CMAKE_INSTALL_BINDIR}: must be one folder below the prefix, for the "
                      "command looks for its data in ../share/seiche")
endif()
set(data reports/render reports/schema reports/record reports/atlas.toml reports/formulas.toml reports/problems.toml reference_data)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/seiche)
foreach(path IN LISTS data)
  cmake_path(GET path FILENAME name)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${path} ${PROJECT_BINARY_DIR}/share/seiche/${name} SYMBOLIC)
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${path})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${path} DESTINATION share/seiche COMPONENT command
            PATTERN tests EXCLUDE PATTERN __pycache__ EXCLUDE)
  else()
    install(FILES ${PROJECT_SOURCE_DIR}/${path} DESTINATION share/seiche COMPONENT command)
  endif()
endforeach()

# seiche_manual(target component PAGE.1.in): the page PAGE.1 from the template and from what the program's --help prints.
function(seiche_manual target component template)
  cmake_path(GET template STEM LAST_ONLY page)
  set(page ${PROJECT_BINARY_DIR}/manual/${page}.gz)
  add_custom_command(OUTPUT ${page} VERBATIM
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/ci/cmake/manual.py $<TARGET_FILE:${target}>
            ${PROJECT_SOURCE_DIR}/${template} ${page} --version ${PROJECT_VERSION}
    DEPENDS ${target} ${PROJECT_SOURCE_DIR}/ci/cmake/manual.py ${PROJECT_SOURCE_DIR}/${template}
    COMMENT "Writing the manual of ${target}")
  add_custom_target(${target}_manual ALL DEPENDS ${page})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()

install(TARGETS seiche_command RUNTIME COMPONENT command)
seiche_manual(seiche_command command validation/command/seiche.1.in)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/ci/score-files DESTINATION share/seiche/ci COMPONENT command)
install(FILES ${PROJECT_SOURCE_DIR}/validation/command/seiche-completion.bash RENAME seiche
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT command)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command
        PATTERN __pycache__ EXCLUDE PATTERN "*.sh" EXCLUDE)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/examples/score_your_solver/run.sh
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/score_your_solver COMPONENT command)
foreach(solver IN ITEMS openfoam gerris published)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/examples/solvers/${solver}/run.sh
          DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/solvers/${solver} COMPONENT command)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
if(SEICHE_WITH_PETSC)
  install(TARGETS seiche_parallel RUNTIME COMPONENT parallel)
  seiche_manual(seiche_parallel parallel validation/parallel/seiche-parallel.1.in)
endif()

# Below the prefix, where the interpreter looks for modules below its own. Debian's has two places: one for packages
# (deb_system), the same for all its versions, and one for what is installed beside them.
if(SEICHE_PYTHON_MODULE)
  execute_process(OUTPUT_VARIABLE python_directory OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY
    COMMAND ${Python3_EXECUTABLE} -c [[if True:
      import sysconfig
      scheme = {"deb_system"} & set(sysconfig.get_scheme_names()) or {sysconfig.get_default_scheme()}
      print(sysconfig.get_path("platlib", *scheme, vars={"base": "", "platbase": ""})[1:])
      ]])
  set(SEICHE_PYTHON_DIRECTORY ${python_directory} CACHE STRING "Where the Python module is installed, below the prefix")
  install(TARGETS seiche_python LIBRARY DESTINATION ${SEICHE_PYTHON_DIRECTORY}/seiche COMPONENT python)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/seiche DESTINATION ${SEICHE_PYTHON_DIRECTORY} COMPONENT python
          FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
endif()

include(SeichePackage)
