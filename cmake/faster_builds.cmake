# SPDX-License-Identifier: Apache-2.0
# Uses a faster linker and a compiler cache where they are installed. Neither changes what is built.
option(TOUCHSTONE_FASTER_BUILDS "Use mold or lld, and ccache, where they are installed" ${PROJECT_IS_TOP_LEVEL})
if(NOT TOUCHSTONE_FASTER_BUILDS)
  return()
endif()

find_program(TOUCHSTONE_MOLD mold)
find_program(TOUCHSTONE_LLD ld.lld)
if(TOUCHSTONE_MOLD)
  add_link_options(-fuse-ld=mold)
elseif(TOUCHSTONE_LLD)
  add_link_options(-fuse-ld=lld)
endif()

find_program(TOUCHSTONE_CCACHE ccache)
if(TOUCHSTONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this ccache compiles every file that uses precompiled headers again.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${TOUCHSTONE_CCACHE})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()
