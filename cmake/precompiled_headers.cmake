# SPDX-License-Identifier: Apache-2.0
# precompile_headers(TARGET HEADER... [FOR OPTIONS option... LIBRARIES library...])
#
# Parses headers that most files of a target include once, instead of once a file: Eigen, for example, takes a second.
# Targets of the same headers, options and libraries share one result. It saves nothing to add the JSON library or the
# one of command-line options: g++ 12 then takes longer to load the result than the other files take. A file must
# include what it uses all the same: the preset dev builds without precompiled headers.
function(precompile_headers target)
  cmake_parse_arguments(PARSE_ARGV 1 headers "" "" "OPTIONS;LIBRARIES")
  string(SHA1 key "${headers_UNPARSED_ARGUMENTS} ${headers_OPTIONS} ${headers_LIBRARIES}")
  string(SUBSTRING ${key} 0 8 key)
  set(shared touchstone_headers_${key})
  if(NOT TARGET ${shared})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled/${key}.cpp CONTENT "// For its precompiled headers.\n")
    add_library(${shared} OBJECT ${PROJECT_BINARY_DIR}/precompiled/${key}.cpp)
    target_compile_options(${shared} PRIVATE ${headers_OPTIONS})
    target_link_libraries(${shared} PRIVATE ${headers_LIBRARIES})
    target_include_directories(${shared} PRIVATE ${PROJECT_SOURCE_DIR})
    target_precompile_headers(${shared} PRIVATE ${headers_UNPARSED_ARGUMENTS})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${shared})
endfunction()
