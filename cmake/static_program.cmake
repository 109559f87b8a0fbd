# SPDX-License-Identifier: GPL-3.0-or-later
# The program needs nothing of the machine that it runs on. A library without a static form is not found, so the program
# has none of what is optional.
if(TOUCHSTONE_TBB OR TOUCHSTONE_PYTHON OR BUILD_SHARED_LIBS)
  message(FATAL_ERROR "TOUCHSTONE_STATIC=ON needs TOUCHSTONE_TBB=OFF, TOUCHSTONE_PYTHON=OFF and BUILD_SHARED_LIBS=OFF")
endif()
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
add_link_options(-static)

if(NOT TOUCHSTONE_INSTALL)
  return()
endif()
# It holds code of libraries, so their licences and notices go with it.
set(licences ${CMAKE_INSTALL_DOCDIR}/program)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/static_program_licenses.txt DESTINATION ${licences} RENAME LICENSES COMPONENT program)
install(FILES /usr/share/common-licenses/LGPL-2.1 /usr/share/common-licenses/LGPL-3 DESTINATION ${licences} COMPONENT program)
foreach(package libboost1.74-dev libc6-dev libcgal-dev libcli11-dev libeigen3-dev libfmt-dev libgmp-dev libmpfr-dev
        librandom123-dev libstdc++-12-dev nlohmann-json3-dev)
  install(FILES /usr/share/doc/${package}/copyright DESTINATION ${licences}/libraries RENAME ${package} COMPONENT program)
endforeach()
