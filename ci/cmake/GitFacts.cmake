# Writes the commit and whether the checkout is clean into OUTPUT, touching the file only when that changed.
set(commit unknown)
set(dirty false)
find_program(git git)
if(git AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${git} rev-parse HEAD WORKING_DIRECTORY ${SOURCE_DIR}
                  OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(commit ${head})
    execute_process(COMMAND ${git} status --porcelain WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE changes)
    if(changes)
      set(dirty true)
    endif()
  endif()
endif()
set(text "#include \"reports/evidence/build_facts.hpp\"

namespace seiche::build_facts {

const std::string_view commit = \"${commit}\";
const bool dirty = ${dirty};

}  // namespace seiche::build_facts
")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
