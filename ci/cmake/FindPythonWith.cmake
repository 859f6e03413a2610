# find_python_with(module...): sets Python3_EXECUTABLE to the first interpreter that has all the modules, unless the user
# set it. The system's interpreter comes first: it has what the distribution's python3-* packages install, which another
# python3 on the PATH need not have.
function(has_python_modules result interpreter)
  list(JOIN ARGN "', '" names)
  execute_process(
    COMMAND ${interpreter} -c "import importlib.util as u, sys; sys.exit(any(u.find_spec(n) is None for n in ['${names}']))"
    RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
  if(missing)
    set(${result} FALSE PARENT_SCOPE)
  else()
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

function(find_python_with)
  find_program(python_on_path NAMES python3 python NO_CACHE)
  foreach(candidate IN ITEMS "${Python3_EXECUTABLE}" /usr/bin/python3 "${python_on_path}")
    if(candidate AND EXISTS "${candidate}")
      has_python_modules(fits "${candidate}" ${ARGN})
      if(fits)
        set(Python3_EXECUTABLE "${candidate}" CACHE FILEPATH "Python interpreter with the modules that the report needs" FORCE)
        return()
      endif()
    endif()
  endforeach()
  list(TRANSFORM ARGN PREPEND python3- OUTPUT_VARIABLE packages)
  list(JOIN packages " " packages)
  message(FATAL_ERROR "No Python with the modules ${ARGN}. On Debian: ci/setup, or apt-get install ${packages}. "
                      "Elsewhere: configure with -DPython3_EXECUTABLE=... naming one that has them.")
endfunction()
