# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DCOMPILER=... -DSOURCE=... -DSCRATCH=... "-DFLAGS=..." [-DSENTENCE=...] -P sound_arithmetic.cmake
# A program that is compiled with these flags must find its arithmetic sound; or, with SENTENCE, say that it is not.
file(MAKE_DIRECTORY ${SCRATCH})
file(WRITE ${SCRATCH}/main.cpp [[
#include <cstdio>
#include <stdexcept>
#include "robust/detail/sound_arithmetic.h"
#if defined(LIKE_VALGRIND)
extern "C" int fesetround(int) noexcept { return 0; }
#endif
int main() {
  try {
    touchstone::expect_sound_arithmetic();
    if (!touchstone::has_directed_rounding()) throw std::logic_error("the rounding mode has no effect");
  } catch (const std::logic_error& error) {
    std::puts(error.what());
    return 1;
  }
  return 0;
}
]])
execute_process(COMMAND ${COMPILER} -std=c++20 -O2 ${FLAGS} -I${SOURCE} ${SCRATCH}/main.cpp
                        ${SOURCE}/robust/detail/sound_arithmetic.cpp -o ${SCRATCH}/main COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SCRATCH}/main RESULT_VARIABLE result OUTPUT_VARIABLE said)
if(NOT DEFINED SENTENCE)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${FLAGS}: found unsound: ${said}")
  endif()
elseif(result EQUAL 0 OR NOT said MATCHES "${SENTENCE}")
  message(FATAL_ERROR "${FLAGS}: not found unsound with a sentence about ${SENTENCE}: ${said}")
endif()
