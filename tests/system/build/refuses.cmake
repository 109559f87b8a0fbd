# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DCOMPILER=... -DSOURCE=... -DFLAG=... -DSENTENCE=... [-DHEADER=... -DINCLUDE=FOLDER...] -P refuses.cmake
# Compiling HEADER (geometry/floating_point.h) with this flag must fail with a sentence that says why, and is the only error
# of an older C++; without the flag, it must succeed.
if(NOT HEADER)
  set(HEADER ${SOURCE}/geometry/floating_point.h)
endif()
list(TRANSFORM INCLUDE PREPEND -isystem)
function(compile flags)
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${flags} -I${SOURCE} ${INCLUDE} -x c++ ${HEADER}
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
string(REGEX MATCHALL "error:" all "${errors}")
list(LENGTH all count)
if(FLAG MATCHES "-std=" AND NOT count EQUAL 1)
  message(FATAL_ERROR "${FLAG} was refused with ${count} errors: ${errors}")
endif()
