# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DBUILD=... -DSOURCE=... -DSCRATCH=... -DCOMPILER=... -DFLAGS=... -P run.cmake
# Installs the build into a scratch prefix, builds the consumer against it and compares what the sample prints with
# what the README says that it prints.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(READ ${SOURCE}/README.md readme)
string(REGEX MATCH "```cpp\n([^`]*)```" found "${readme}")
if(NOT found)
  message(FATAL_ERROR "README.md has no C++ sample")
endif()
file(WRITE ${SCRATCH}/sample.cpp "${CMAKE_MATCH_1}")
string(REGEX MATCH "prints `([^`]*)`" found "${readme}")
set(promised "${CMAKE_MATCH_1}")

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${SCRATCH}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
    -DSAMPLE=${SCRATCH}/sample.cpp)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/sample)
string(STRIP "${output}" output)
if(NOT promised OR NOT output STREQUAL promised)
  message(FATAL_ERROR "the sample prints `${output}`; README.md promises `${promised}`")
endif()

# Every public header stands alone in the installed tree.
file(GLOB_RECURSE headers RELATIVE ${SCRATCH}/prefix/include/touchstone ${SCRATCH}/prefix/include/touchstone/*.h)
if(NOT headers)
  message(FATAL_ERROR "no header was installed")
endif()
