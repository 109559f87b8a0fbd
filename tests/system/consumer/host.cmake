# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DSOURCE=... -DSCRATCH=... -DCOMPILER=... -DFLAGS=... -P host.cmake
# Another project has Touchstone as a part of itself, by the lines of the tutorial. The README's sample prints there what the
# README says. The host's asserts stay on, and its installation holds its own program alone.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(READ ${SOURCE}/docs/tutorial.md tutorial)
string(REGEX MATCH "```cmake\n(include\\(FetchContent\\)[^`]*)```" found "${tutorial}")
set(lines "${CMAKE_MATCH_1}")
file(READ ${SOURCE}/README.md readme)
string(REGEX MATCH "```cpp\n([^`]*)```" found "${readme}")
file(WRITE ${SCRATCH}/host/sample.cpp "#ifdef NDEBUG\n#error \"the host's asserts are off\"\n#endif\n${CMAKE_MATCH_1}")
string(REGEX MATCH "prints `([^`]*)`" found "${readme}")
set(promised "${CMAKE_MATCH_1}")
file(WRITE ${SCRATCH}/host/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(Host LANGUAGES CXX)
add_executable(yours sample.cpp)
install(TARGETS yours)
${lines}
if(CMAKE_BUILD_TYPE)
  message(FATAL_ERROR \"the host's build type has become \${CMAKE_BUILD_TYPE}\")
endif()
")
file(CREATE_LINK ${SOURCE} ${SCRATCH}/host/touchstone SYMBOLIC)

# Less to compile: no CGAL, and what ccache remembers.
run(${CMAKE_COMMAND} -G Ninja -S ${SCRATCH}/host -B ${SCRATCH}/build -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -DTOUCHSTONE_FASTER_BUILDS=ON -DTOUCHSTONE_EXACT=OFF -DTOUCHSTONE_TBB=OFF)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/yours)
string(STRIP "${output}" output)
if(NOT promised OR NOT output STREQUAL promised)
  message(FATAL_ERROR "the sample prints `${output}`; README.md promises `${promised}`")
endif()
run(${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${SCRATCH}/prefix)
file(GLOB_RECURSE installed RELATIVE ${SCRATCH}/prefix ${SCRATCH}/prefix/*)
if(NOT installed STREQUAL "bin/yours")
  message(FATAL_ERROR "the host's installation holds ${installed}")
endif()
