# Read by ctest when it lists the tests: the long tiers are listed only when a label asks for them (ctest -L full) or
# SEICHE_TIERS names them ("quick;full"), so that a plain `ctest` stays within minutes.
set(seiche_tiers "$ENV{SEICHE_TIERS}")
if(NOT seiche_tiers)
  set(seiche_tiers quick)
  if(EXISTS /proc/self/cmdline)
    file(STRINGS /proc/self/cmdline seiche_words)
    foreach(tier full paper)
      if(";${seiche_words};" MATCHES ";[^;/]*${tier}[^;/]*;")
        list(APPEND seiche_tiers ${tier})
      endif()
    endforeach()
  endif()
endif()
