# SPDX-License-Identifier: Apache-2.0
# Installs the libraries, how CMake and pkg-config find them, and the pages that go with them.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Touchstone)
install(TARGETS touchstone_geometry touchstone_robust EXPORT TouchstoneTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT TouchstoneTargets NAMESPACE touchstone:: DESTINATION ${package})
if(TOUCHSTONE_C)
  install(EXPORT TouchstoneCTargets NAMESPACE touchstone:: DESTINATION ${package})
endif()
configure_package_config_file(cmake/TouchstoneConfig.cmake.in TouchstoneConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TouchstoneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TouchstoneConfig.cmake ${PROJECT_BINARY_DIR}/TouchstoneConfigVersion.cmake
        DESTINATION ${package})
if(TOUCHSTONE_EXACT)
  install(FILES cmake/FindGMP.cmake cmake/FindMPFR.cmake DESTINATION ${package})
endif()
set(touchstone_static_libraries "")
if(NOT BUILD_SHARED_LIBS)
  if(TOUCHSTONE_TBB)
    string(APPEND touchstone_static_libraries " -ltbb")
  endif()
  if(TOUCHSTONE_EXACT)
    string(APPEND touchstone_static_libraries " -lmpfr -lgmp")
  endif()
endif()
# Relative, so that `cmake --install --prefix` may move it.
file(RELATIVE_PATH touchstone_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/touchstone.pc.in touchstone.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/touchstone.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(TOUCHSTONE_C)
  configure_file(cmake/touchstone-c.pc.in touchstone-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/touchstone-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# In the folders of the source tree, so that their links to each other lead there.
install(FILES LICENSE LICENSE-APACHE LICENSE-GPL DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES geometry/contact/CONTRACT.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/geometry/contact)
install(FILES docs/tutorial.md docs/contract.svg docs/formats.md docs/rejections.md docs/platforms.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
# A package or an archive of one component alone has its own.
foreach(component library program python)
  install(FILES LICENSE LICENSE-APACHE LICENSE-GPL geometry/contact/CONTRACT.md
          DESTINATION ${CMAKE_INSTALL_DOCDIR}/${component} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
