# SPDX-License-Identifier: GPL-3.0-or-later
# Contact engines of other projects: methods, and candidates of the study bench_scenes. What is compiled does not depend on
# which are installed, except by the generated header experiments/program/built_with.h, which says it: the engine NAME has
# TOUCHSTONE_HAS_NAME there, 0 or 1, and a target engine::NAME if it is found. Methods have the order of these lines.
set(engines_found "")
set(engine_macros "")

# find_engine(NAME HEADER [FOLDER folder] LIBRARIES library...)
function(find_engine name header)
  cmake_parse_arguments(PARSE_ARGV 2 engine "" "FOLDER" "LIBRARIES")
  set(found 1)
  find_path(TOUCHSTONE_${name}_HEADERS ${header} PATH_SUFFIXES ${engine_FOLDER})
  set(libraries "")
  foreach(library ${engine_LIBRARIES})
    find_library(TOUCHSTONE_${name}_${library} ${library})
    list(APPEND libraries ${TOUCHSTONE_${name}_${library}})
    if(NOT TOUCHSTONE_${name}_${library})
      set(found 0)
    endif()
  endforeach()
  if(NOT TOUCHSTONE_${name}_HEADERS OR NOT TOUCHSTONE_ENGINES OR TOUCHSTONE_STATIC)  # Debian has few of them in static form
    set(found 0)
  endif()
  if(found)
    add_library(engine::${name} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(engine::${name} INTERFACE ${libraries})
    target_include_directories(engine::${name} SYSTEM INTERFACE ${TOUCHSTONE_${name}_HEADERS})
    set(engines_found ${engines_found} ${name} PARENT_SCOPE)
  endif()
  string(TOUPPER ${name} macro)
  set(engine_macros "${engine_macros}#define TOUCHSTONE_HAS_${macro} ${found}\n" PARENT_SCOPE)
endfunction()

find_engine(fcl fcl/fcl.h LIBRARIES fcl ccd)
find_engine(libccd ccd/ccd.h LIBRARIES ccd)
find_engine(bullet btBulletCollisionCommon.h FOLDER bullet LIBRARIES BulletCollision-float64 LinearMath-float64)
if(TARGET engine::bullet)
  target_compile_definitions(engine::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
endif()
# Bullet's float build defines the same names, so it needs a program of its own.
find_engine(bullet_float btBulletCollisionCommon.h FOLDER bullet LIBRARIES BulletCollision LinearMath)
find_engine(ode ode/ode.h LIBRARIES ode)
find_library(TOUCHSTONE_EMBREE NAMES embree4 embree3)  # Debian 12 has version 3
string(REGEX MATCH "embree[34]" embree "${TOUCHSTONE_EMBREE}")
find_engine(embree rtcore.h FOLDER ${embree} LIBRARIES ${embree})
