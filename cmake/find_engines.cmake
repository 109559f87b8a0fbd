# SPDX-License-Identifier: GPL-3.0-or-later
# Contact engines of other projects: methods, and candidates of the study bench_scenes. Each that is found becomes a target
# engine::NAME and an entry of `engines_found`, for which experiments/methods/engines/NAME.cpp is compiled; the program
# names those that it was built without. Methods have the order of these lines.
set(engines_found "")

# find_engine(NAME HEADER [FOLDER folder] LIBRARIES library...)
function(find_engine name header)
  cmake_parse_arguments(PARSE_ARGV 2 engine "" "FOLDER" "LIBRARIES")
  find_path(${name}_HEADERS ${header} PATH_SUFFIXES ${engine_FOLDER})
  set(libraries "")
  foreach(library ${engine_LIBRARIES})
    find_library(${name}_${library} ${library})
    if(NOT ${name}_${library})
      return()
    endif()
    list(APPEND libraries ${${name}_${library}})
  endforeach()
  if(${name}_HEADERS)
    add_library(engine::${name} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(engine::${name} INTERFACE ${libraries})
    target_include_directories(engine::${name} SYSTEM INTERFACE ${${name}_HEADERS})
    set(engines_found ${engines_found} ${name} PARENT_SCOPE)
  endif()
endfunction()

find_engine(fcl fcl/fcl.h LIBRARIES fcl ccd)
find_engine(libccd ccd/ccd.h LIBRARIES ccd)
find_engine(bullet btBulletCollisionCommon.h FOLDER bullet LIBRARIES BulletCollision-float64 LinearMath-float64)
if(TARGET engine::bullet)
  target_compile_definitions(engine::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
endif()
# Bullet's float build defines the same names, so it needs a program of its own.
find_engine(bullet-float btBulletCollisionCommon.h FOLDER bullet LIBRARIES BulletCollision LinearMath)
find_engine(ode ode/ode.h LIBRARIES ode)
find_engine(embree embree3/rtcore.h LIBRARIES embree3)
