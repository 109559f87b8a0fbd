# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DCOMPILER=... -DSOURCE=... -DFLAG=... -DSENTENCE=... -P refuses.cmake
# Compiling with this flag must fail with a sentence that says why; without it, it must succeed.
function(compile flags)
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${flags} -I${SOURCE} -x c++ ${SOURCE}/geometry/floating_point.h
                  RESULT_VARIABLE result ERROR_VARIABLE errors OUTPUT_QUIET)
  set(result "${result}" PARENT_SCOPE)
  set(errors "${errors}" PARENT_SCOPE)
endfunction()

compile("")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "refused without any flag: ${errors}")
endif()
compile("${FLAG}")
if(result EQUAL 0 OR NOT errors MATCHES "${SENTENCE}")
  message(FATAL_ERROR "${FLAG} was not refused with a sentence about ${SENTENCE}: ${errors}")
endif()
