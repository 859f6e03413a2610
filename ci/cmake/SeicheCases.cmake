# The registry of cases, generated from the files, and a ctest entry per case and tier, generated from the registry.

# seiche_fingerprints(OUTPUT folder/check.cpp...): a rule for OUTPUT, the fingerprints of checks of this folder.
function(seiche_fingerprints output)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE here)
  list(TRANSFORM ARGN PREPEND ${here}/ OUTPUT_VARIABLE checks)
  file(GLOB_RECURSE code CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/seiche/*.[ch]pp
       ${PROJECT_SOURCE_DIR}/reports/evidence/*.[ch]pp ${PROJECT_SOURCE_DIR}/validation/*.[ch]pp
       ${PROJECT_SOURCE_DIR}/verification/*.[ch]pp)
  set(program ${PROJECT_SOURCE_DIR}/ci/cmake/fingerprints.py)
  add_custom_command(OUTPUT ${output} DEPENDS ${code} ${program} VERBATIM COMMENT "Fingerprints of ${here}"
    COMMAND ${Python3_EXECUTABLE} -B ${program} --source ${PROJECT_SOURCE_DIR} --toolchain "${SEICHE_TOOLCHAIN}"
            --output ${output} ${checks})
endfunction()

# seiche_registry(OUT phenomenon/case.cpp...): OUT becomes the list of generated sources.
function(seiche_registry out)
  set(declarations "")
  set(entries "")
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH phenomenon)
    cmake_path(GET source STEM name)
    string(APPEND declarations "namespace cases::${name} { void ${name}(Case& c); }\n"
                               "namespace articles { extern const char* const ${name}; }\n"
                               "namespace fingerprints { extern const char* const ${name}; }\n")
    string(APPEND entries
      "      {\"${name}\", \"${phenomenon}\", articles::${name}, fingerprints::${name}, cases::${name}::${name}},\n")
  endforeach()
  set(SEICHE_CASE_DECLARATIONS "${declarations}")
  set(SEICHE_CASE_ENTRIES "${entries}")
  configure_file(case/all_cases.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/all_cases.cpp)

  set(articles ${CMAKE_CURRENT_BINARY_DIR}/articles.cpp)
  set(program ${PROJECT_SOURCE_DIR}/ci/cmake/articles.py)
  add_custom_command(OUTPUT ${articles} DEPENDS ${ARGN} ${program} VERBATIM COMMENT "Articles of the cases"
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMAND ${Python3_EXECUTABLE} -B ${program} --output ${articles} ${ARGN})
  set(fingerprints ${CMAKE_CURRENT_BINARY_DIR}/case_fingerprints.cpp)
  seiche_fingerprints(${fingerprints} ${ARGN})
  set(${out} ${articles} ${fingerprints} ${CMAKE_CURRENT_BINARY_DIR}/all_cases.cpp PARENT_SCOPE)
endfunction()

# seiche_case_tests(command): the command writes the list of tests after every build; ctest reads it.
function(seiche_case_tests command)
  set(tests ${CMAKE_CURRENT_BINARY_DIR}/case_tests.cmake)
  set(limit "")
  if(SEICHE_SANITIZE)
    # Particles take fifty times as long: what their first minutes do, the others do again.
    set(limit --most-seconds 90)
  endif()
  add_custom_command(TARGET ${command} POST_BUILD BYPRODUCTS ${tests} VERBATIM
    COMMAND ${command} list --ctest ${tests} --evidence ${PROJECT_BINARY_DIR}/evidence ${limit})
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${PROJECT_SOURCE_DIR}/ci/cmake/CtestTiers.cmake ${tests})
endfunction()
