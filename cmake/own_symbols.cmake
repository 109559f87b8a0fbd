# SPDX-License-Identifier: Apache-2.0
# own_symbols(TARGET): a program sees no symbol of the library but touchstone's.
#
# A static library keeps the symbols of other libraries' headers local (keep_foreign_symbols_local.cmake). A shared one,
# with BUILD_SHARED_LIBS, exports what is in namespace touchstone and nothing else. Its name holds the minor version,
# since interfaces may change with it.
include(${CMAKE_CURRENT_LIST_DIR}/keep_foreign_symbols_local.cmake)

function(own_symbols target)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL SHARED_LIBRARY)
    keep_foreign_symbols_local(${target})
    return()
  endif()
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    DEFINE_SYMBOL "")  # no header needs it, and files compile as they do for the static library
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  if(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/own_symbols.map)
    target_link_options(${target} PRIVATE LINKER:--version-script=${exports} LINKER:--no-undefined
                        LINKER:-Bsymbolic-functions)
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${exports})
  endif()
endfunction()
