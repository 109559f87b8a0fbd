# SPDX-License-Identifier: Apache-2.0
# Defines MPFR::MPFR.
include(FindPackageHandleStandardArgs)
find_path(MPFR_INCLUDE_DIR mpfr.h)
find_library(MPFR_LIBRARY mpfr)
find_package_handle_standard_args(MPFR REQUIRED_VARS MPFR_INCLUDE_DIR MPFR_LIBRARY)
if(MPFR_FOUND)
  if(NOT TARGET MPFR::MPFR)
    add_library(MPFR::MPFR INTERFACE IMPORTED)
    target_include_directories(MPFR::MPFR INTERFACE ${MPFR_INCLUDE_DIR})
    target_link_libraries(MPFR::MPFR INTERFACE ${MPFR_LIBRARY})
  endif()
endif()
