# SPDX-License-Identifier: Apache-2.0
# keep_foreign_symbols_local(TARGET): no weak symbol of the static library is one of another library's headers.
#
# CGAL, Boost and others are templates and inline functions, which every object file has a weak copy of. Linkers keep one
# copy of each: in a program with another version of CGAL, that program's or ours. So in each object of the archive such
# symbols become local, and groups of sections, of which linkers keep one too, are dissolved. What is touchstone's or the
# standard library's stays, but for templates of the standard library over types of others.
#
# Not done where objects hold more than code (sanitizers, link-time optimisation, profiles), and not without ELF and GNU
# binutils: there a program must use the same versions of these headers. Elsewhere TOUCHSTONE_FOREIGN_SYMBOLS_LOCAL is a
# property of the target.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  # cmake -DARCHIVE=... -DOBJECTS=(file with a path a line) -DSCRATCH=... -DLD=... -DNM=... -DOBJCOPY=... -DAR=... -P
  function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "${ARGN}: ${errors}")
    endif()
    set(output "${output}" PARENT_SCOPE)
  endfunction()

  set(own "^_Z(T[VTISC]|GV|GR|Th[n0-9]*_|Tv[n0-9_]*_)?Z*(N[KVRO]*)?(S[tabsiod]|10touchstone)")
  set(foreign "^_Z(T[VTISC]|GV|GR|Th[n0-9]*_|Tv[n0-9_]*_)?Z*(N[KVRO]*)?S.*(4CGAL|5boost|5Eigen|3tbb|10__gmp_expr)")
  file(STRINGS ${OBJECTS} objects)
  set(number 0)
  set(members)
  foreach(object ${objects})
    cmake_path(GET object FILENAME name)
    set(member ${SCRATCH}/${number}/${name})
    math(EXPR number "${number} + 1")
    list(APPEND members ${member})
    if(EXISTS ${member} AND ${member} IS_NEWER_THAN ${object} AND ${member} IS_NEWER_THAN ${CMAKE_CURRENT_LIST_FILE})
      continue()
    endif()
    cmake_path(GET member PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    run(${LD} -r --force-group-allocation -o ${member}.grouped ${object})
    run(${NM} --defined-only --format=posix ${member}.grouped)
    string(REGEX MATCHALL "[^\n]+ [WVu] " weak "${output}")
    set(locals "")
    foreach(line ${weak})
      string(REGEX REPLACE " [WVu] $" "" symbol "${line}")
      if(NOT symbol MATCHES "${own}" OR symbol MATCHES "${foreign}")
        string(APPEND locals "${symbol}\n")
      endif()
    endforeach()
    if(locals)
      file(WRITE ${member}.locals "${locals}")
      run(${OBJCOPY} --localize-symbols=${member}.locals ${member}.grouped)
    endif()
    file(RENAME ${member}.grouped ${member})
  endforeach()
  file(REMOVE ${ARCHIVE})
  run(${AR} qcsD ${ARCHIVE} ${members})
  return()
endif()

set(keep_foreign_symbols_local_script ${CMAKE_CURRENT_LIST_FILE})
# Where this machine compiles for another, its own would not read the objects.
find_program(TOUCHSTONE_LD NAMES ${CMAKE_LIBRARY_ARCHITECTURE}-ld.bfd ld.bfd)
find_program(TOUCHSTONE_NM NAMES ${CMAKE_LIBRARY_ARCHITECTURE}-nm nm)
find_program(TOUCHSTONE_OBJCOPY NAMES ${CMAKE_LIBRARY_ARCHITECTURE}-objcopy objcopy)

function(keep_foreign_symbols_local target)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}" MATCHES "-fsanitize|-flto|-fprofile|--coverage"
     OR CMAKE_INTERPROCEDURAL_OPTIMIZATION OR NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    return()
  endif()
  if(NOT TOUCHSTONE_LD OR NOT TOUCHSTONE_NM OR NOT TOUCHSTONE_OBJCOPY)
    message(STATUS "${target}: symbols of other libraries' headers stay weak, as GNU ld, nm or objcopy was not found")
    return()
  endif()
  # objcopy leaves symbols that are unique in a process as they are.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  set_target_properties(${target} PROPERTIES TOUCHSTONE_FOREIGN_SYMBOLS_LOCAL ON)
  set(scratch ${CMAKE_CURRENT_BINARY_DIR}/${target}_members)
  # CMake counts precompiled headers among the objects.
  set(objects "$<FILTER:$<TARGET_OBJECTS:${target}>,EXCLUDE,[.][gp]ch$>")
  file(GENERATE OUTPUT ${scratch}/objects CONTENT "$<JOIN:${objects},\n>\n")
  add_custom_command(TARGET ${target} POST_BUILD VERBATIM
    COMMAND ${CMAKE_COMMAND} -DARCHIVE=$<TARGET_FILE:${target}> -DOBJECTS=${scratch}/objects -DSCRATCH=${scratch}
            -DLD=${TOUCHSTONE_LD} -DNM=${TOUCHSTONE_NM} -DOBJCOPY=${TOUCHSTONE_OBJCOPY} -DAR=${CMAKE_AR}
            -P ${keep_foreign_symbols_local_script})
endfunction()
