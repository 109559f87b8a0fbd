# SPDX-License-Identifier: GPL-3.0-or-later
# Usage: cmake -DBUILD=... -DSOURCE=... -DSCRATCH=... -DCOMPILER=... -DFLAGS=... [-DFORBIDDEN=PACKAGE...]
#              -P run.cmake
# Installs the build into a scratch prefix, builds the consumer against it and compares what the sample prints with
# what the README says that it prints. Every installed header must compile alone, licences are installed once, and no
# folder `geometry` or `robust` of the consumer's own may hide one of Touchstone's.
# FORBIDDEN: packages that CMake may not look for.
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
set(include ${SCRATCH}/prefix/include/touchstone)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/*.h)
file(GLOB front_door RELATIVE ${include} ${include}/*.h)
file(GLOB written RELATIVE ${BUILD}/include/touchstone ${BUILD}/include/touchstone/*.h)
if(NOT front_door OR NOT front_door STREQUAL written)
  message(FATAL_ERROR "installed are ${front_door}; written were ${written}")
endif()
file(GLOB_RECURSE pages RELATIVE ${SCRATCH}/prefix/share/doc/Touchstone ${SCRATCH}/prefix/share/doc/Touchstone/*E-APACHE
     ${SCRATCH}/prefix/share/doc/Touchstone/*CONTRACT.md ${SCRATCH}/prefix/share/doc/Touchstone/*tutorial.md)
if(NOT pages STREQUAL "LICENSE-APACHE;docs/tutorial.md;geometry/contact/CONTRACT.md")
  message(FATAL_ERROR "of the licence, the tutorial and the contract, these are installed: ${pages}")
endif()
set(internal ${headers})
list(FILTER internal INCLUDE REGEX "/(detail|bvh)/")
if(internal)
  message(FATAL_ERROR "internal headers were installed: ${internal}")
endif()
foreach(header ${headers})
  if(header MATCHES "/")
    file(WRITE ${SCRATCH}/own/${header} "#error \"the consumer's own ${header} was taken for Touchstone's\"\n")
  endif()
endforeach()

if(FORBIDDEN MATCHES "CGAL")
  list(FILTER headers EXCLUDE REGEX "cgal\\.h$")  # it is for those who have CGAL
endif()
set(common -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -DSAMPLE=${SCRATCH}/sample.cpp)
foreach(package ${FORBIDDEN})
  list(APPEND common -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/system/consumer -B ${SCRATCH}/build ${common} -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
    -DOWN_HEADERS=${SCRATCH}/own "-DHEADERS=${headers}")
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/sample)
string(STRIP "${output}" output)
if(NOT promised OR NOT output STREQUAL promised)
  message(FATAL_ERROR "the sample prints `${output}`; README.md promises `${promised}`")
endif()
