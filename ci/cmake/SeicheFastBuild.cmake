# What makes a build faster where it is installed: ccache keeps objects, mold or lld links.
find_program(SEICHE_CCACHE ccache)
if(SEICHE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers ask for the sloppiness; the depend mode takes what a file reads from the compiler's list.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${SEICHE_CCACHE})
endif()
foreach(linker IN ITEMS mold lld)
  find_program(SEICHE_LINKER_${linker} NAMES ld.${linker} ${linker})
  if(SEICHE_LINKER_${linker})
    add_link_options(-fuse-ld=${linker})
    break()
  endif()
endforeach()
