# SPDX-License-Identifier: Apache-2.0
# Compiles the files of a room together, uses a faster linker and a compiler cache where they are installed, and lets g++
# take more memory before it collects what it no longer needs. None of these changes what is built.

# compile_together(TARGET): headers cost more than code, so that eight files at once take a third of the time. Names in
# the files' unnamed namespaces must differ. The presets dev and tidy compile each file alone, so that one that forgets an
# `#include` fails there.
option(TOUCHSTONE_TOGETHER "Compile the files of rooms and tests eight at once" ${PROJECT_IS_TOP_LEVEL})
function(compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TOUCHSTONE_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

option(TOUCHSTONE_FASTER_BUILDS "Use mold or lld, and ccache, where they are installed" ${PROJECT_IS_TOP_LEVEL})
if(NOT TOUCHSTONE_FASTER_BUILDS)
  return()
endif()

# In kB. g++ begins at 128 MB, which precompiled headers fill: 8 % of the time goes into collecting, which saves
# 50 MB.
add_compile_options("$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>")

find_program(TOUCHSTONE_MOLD mold)
find_program(TOUCHSTONE_LLD ld.lld)
if(CMAKE_CROSSCOMPILING)
  # g++ for another architecture does not find these.
elseif(TOUCHSTONE_MOLD)
  add_link_options(-fuse-ld=mold)
elseif(TOUCHSTONE_LLD)
  add_link_options(-fuse-ld=lld)
endif()

find_program(TOUCHSTONE_CCACHE ccache)
if(TOUCHSTONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without CCACHE_SLOPPINESS, ccache compiles every file that uses precompiled headers again.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_IGNOREOPTIONS=--param=ggc-* ${TOUCHSTONE_CCACHE})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()
