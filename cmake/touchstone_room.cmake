# SPDX-License-Identifier: GPL-3.0-or-later
# touchstone_room(NAME [CGAL] [STANDS_ON ROOM...] [SOURCES FILE...] [OPTIMISED FILE...])
#
# A room of experiments/: one folder, one library touchstone_NAME of the files that are listed. Its files may include
# headers of the rooms that it stands on, and no others; tests/system/rooms.py holds the includes to this. CGAL: its
# files may include CGAL's headers. Release builds compile SOURCES at -O1, which takes a third less time, and OPTIMISED
# files at -O3, because they are timed or because a study waits for them.
function(touchstone_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "CGAL" "" "STANDS_ON;OPTIMISED;SOURCES")
  add_library(touchstone_${name} STATIC ${room_SOURCES} ${room_OPTIMISED})
  set(libraries touchstone_options Eigen3::Eigen)
  if(room_CGAL)
    list(PREPEND libraries touchstone_cgal)
    target_link_libraries(touchstone_${name} PRIVATE touchstone_cgal)
  endif()
  target_include_directories(touchstone_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(touchstone_${name} PUBLIC touchstone_robust touchstone_options)
  foreach(lower ${room_STANDS_ON})
    target_link_libraries(touchstone_${name} PUBLIC touchstone_${lower})
  endforeach()

  set(options "")
  if(room_SOURCES)
    set(options $<$<CONFIG:Release>:-O1>)
    target_compile_options(touchstone_${name} PRIVATE ${options})
    set_source_files_properties(${room_OPTIMISED} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>
                                SKIP_PRECOMPILE_HEADERS ON)
  endif()
  precompile_headers(touchstone_${name} <algorithm> <array> <cmath> <filesystem> <functional> <optional> <string> <vector>
                     <Eigen/Core> <Eigen/Geometry> OPTIONS ${options} LIBRARIES ${libraries})

  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  list(JOIN room_STANDS_ON " " lower)
  set_property(GLOBAL APPEND_STRING PROPERTY TOUCHSTONE_ROOMS "${name} ${folder}: ${lower}\n")
endfunction()
