# The registry of cases, generated from the files, and a ctest entry per case and tier, generated from the registry.

# seiche_registry(OUT phenomenon/case.cpp...): OUT becomes the list of generated sources.
function(seiche_registry out)
  set(declarations "")
  set(entries "")
  set(generated "")
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH phenomenon)
    cmake_path(GET source STEM name)
    string(APPEND declarations "namespace cases { Case ${name}(); }\nnamespace articles { extern const char* const ${name}; }\n")
    string(APPEND entries "      {\"${name}\", \"${phenomenon}\", articles::${name}, cases::${name}},\n")
    set(article ${CMAKE_CURRENT_BINARY_DIR}/articles/${name}.cpp)
    add_custom_command(OUTPUT ${article}
      COMMAND ${CMAKE_COMMAND} -DSOURCE=${CMAKE_CURRENT_SOURCE_DIR}/${source} -DNAME=${name} -DOUTPUT=${article}
              -P ${PROJECT_SOURCE_DIR}/ci/cmake/ExtractArticle.cmake
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${source} ${PROJECT_SOURCE_DIR}/ci/cmake/ExtractArticle.cmake VERBATIM)
    list(APPEND generated ${article})
  endforeach()
  set(SEICHE_CASE_DECLARATIONS "${declarations}")
  set(SEICHE_CASE_ENTRIES "${entries}")
  configure_file(case/all_cases.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/all_cases.cpp)
  set(${out} ${generated} ${CMAKE_CURRENT_BINARY_DIR}/all_cases.cpp PARENT_SCOPE)
endfunction()

# seiche_case_tests(command): the command writes the list of tests after every build; ctest reads it.
function(seiche_case_tests command)
  set(tests ${CMAKE_CURRENT_BINARY_DIR}/case_tests.cmake)
  add_custom_command(TARGET ${command} POST_BUILD BYPRODUCTS ${tests} VERBATIM
    COMMAND ${command} list --ctest ${tests} --evidence ${PROJECT_BINARY_DIR}/evidence)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${PROJECT_SOURCE_DIR}/ci/cmake/CtestTiers.cmake ${tests})
endfunction()
