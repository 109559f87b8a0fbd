# SPDX-License-Identifier: GPL-3.0-or-later
# touchstone_room(NAME [STANDS_ON ROOM...] [OPTIMISED] SOURCES FILE...)
#
# A room of experiments/: one folder, one library touchstone_NAME of the files that are listed. Its files may include
# headers of the rooms that it stands on, and no others; tests/system/rooms.py holds the includes to this. A room of which
# nothing is timed is compiled quickly, at -O1; OPTIMISED ones at the level of the build type.
function(touchstone_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "OPTIMISED" "" "STANDS_ON;SOURCES")
  add_library(touchstone_${name} STATIC ${room_SOURCES})
  target_include_directories(touchstone_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(touchstone_${name} PUBLIC touchstone_robust touchstone_options)
  foreach(lower ${room_STANDS_ON})
    target_link_libraries(touchstone_${name} PUBLIC touchstone_${lower})
  endforeach()
  if(NOT room_OPTIMISED)
    target_compile_options(touchstone_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  list(JOIN room_STANDS_ON " " lower)
  set_property(GLOBAL APPEND_STRING PROPERTY TOUCHSTONE_ROOMS "${name} ${folder}: ${lower}\n")
endfunction()
