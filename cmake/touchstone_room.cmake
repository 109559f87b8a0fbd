# SPDX-License-Identifier: GPL-3.0-or-later
# helper_program(TARGET): a program that only the program touchstone starts, which experiments/program/input.h finds.
function(helper_program target)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/libexec/touchstone)
  if(TOUCHSTONE_INSTALL)
    install(TARGETS ${target} OPTIONAL DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/touchstone COMPONENT program)
  endif()
endfunction()

# touchstone_room(NAME [CGAL] [STANDS_ON ROOM...] [SOURCES FILE...] [OPTIMISED FILE...])
#
# A room of experiments/: one folder, one library touchstone_NAME of the files that are listed. Its files may include
# headers of the rooms that it stands on, and no others; tests/system/rooms.py holds the includes to this. CGAL: its
# files may include CGAL's headers. Release builds compile SOURCES at -O1, which takes a third less time, and OPTIMISED
# files at -O3, because they are timed or because a study waits for them.
function(touchstone_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "CGAL" "" "STANDS_ON;OPTIMISED;SOURCES")
  add_library(touchstone_${name} STATIC ${room_SOURCES})
  compile_together(touchstone_${name})
  set(libraries touchstone_options Eigen3::Eigen)
  if(room_CGAL)
    list(PREPEND libraries touchstone_cgal)
    target_link_libraries(touchstone_${name} PRIVATE touchstone_cgal)
  endif()
  target_include_directories(touchstone_${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(touchstone_${name} PUBLIC touchstone_robust touchstone_options)
  foreach(lower ${room_STANDS_ON})
    target_link_libraries(touchstone_${name} PUBLIC touchstone_${lower})
  endforeach()

  set(headers <algorithm> <array> <cmath> <filesystem> <functional> <optional> <string> <vector> <Eigen/Core>
              <Eigen/Geometry>)
  set(options "")
  if(room_SOURCES)
    set(options $<$<CONFIG:Release>:-O1>)
    target_compile_options(touchstone_${name} PRIVATE ${options})
  endif()
  precompile_headers(touchstone_${name} ${headers} OPTIONS ${options} LIBRARIES ${libraries})
  if(room_SOURCES AND room_OPTIMISED)
    # Objects of their own, because precompiled headers serve one level of optimisation.
    add_library(touchstone_${name}_optimised OBJECT ${room_OPTIMISED})
    compile_together(touchstone_${name}_optimised)
    target_link_libraries(touchstone_${name}_optimised PRIVATE $<TARGET_PROPERTY:touchstone_${name},LINK_LIBRARIES>)
    set(options $<$<CONFIG:Debug>:-O2>)  # at -O1, sanitizers make a cell's simulation a hundred times slower
    target_compile_options(touchstone_${name}_optimised PRIVATE ${options})
    precompile_headers(touchstone_${name}_optimised ${headers} OPTIONS ${options} LIBRARIES ${libraries})
    target_sources(touchstone_${name} PRIVATE $<TARGET_OBJECTS:touchstone_${name}_optimised>)
  else()
    target_sources(touchstone_${name} PRIVATE ${room_OPTIMISED})
  endif()

  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  list(JOIN room_STANDS_ON " " lower)
  set_property(GLOBAL APPEND_STRING PROPERTY TOUCHSTONE_ROOMS "${name} ${folder}: ${lower}\n")
endfunction()
