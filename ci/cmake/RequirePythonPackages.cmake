# Stops with the Debian package names when the Python that CMake found lacks a module.
function(require_python_packages)
  foreach(module IN LISTS ARGN)
    execute_process(COMMAND ${Python3_EXECUTABLE} -c "import importlib.util, sys; sys.exit(importlib.util.find_spec('${module}') is None)"
                    RESULT_VARIABLE missing)
    if(missing)
      message(FATAL_ERROR "${Python3_EXECUTABLE} has no module ${module}: on Debian install python3-${module} "
                          "and configure with -DPython3_EXECUTABLE=/usr/bin/python3 (ci/setup does)")
    endif()
  endforeach()
endfunction()
