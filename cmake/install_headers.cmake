# SPDX-License-Identifier: Apache-2.0
# install_headers(FILE...): installs headers of the current folder under include/touchstone/, by their path from the root.
#
# The public headers come to lie beside them, so that `#include "geometry/shapes/ball.h"` there is found next to
# the file that says it. All other installed headers include each other by relative paths. So `include` is the only
# folder on a user's search path, and a folder `geometry` of the user's own hides nothing.
function(install_headers)
  if(NOT TOUCHSTONE_INSTALL)
    return()
  endif()
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  foreach(file ${ARGN})
    cmake_path(GET file PARENT_PATH subfolder)
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/touchstone/${folder}/${subfolder})
  endforeach()
endfunction()
