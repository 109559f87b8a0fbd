# SPDX-License-Identifier: Apache-2.0
# Defines QD::QD.
include(FindPackageHandleStandardArgs)
find_path(QD_INCLUDE_DIR qd/dd_real.h)
find_library(QD_LIBRARY qd)
find_package_handle_standard_args(QD REQUIRED_VARS QD_INCLUDE_DIR QD_LIBRARY)
if(QD_FOUND)
  if(NOT TARGET QD::QD)
    add_library(QD::QD INTERFACE IMPORTED)
    target_include_directories(QD::QD INTERFACE ${QD_INCLUDE_DIR})
    target_link_libraries(QD::QD INTERFACE ${QD_LIBRARY})
  endif()
endif()
