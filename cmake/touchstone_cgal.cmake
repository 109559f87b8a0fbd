# SPDX-License-Identifier: Apache-2.0
# touchstone_cgal: how every target of the project that includes CGAL's headers is compiled and linked.
#
# CGAL is header-only. Its intervals need -frounding-math where the compiler has it.
set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)  # CGAL then finds Boost by its own configuration, as newer CMakes ask
find_package(GMP REQUIRED)
find_package(MPFR REQUIRED)
find_package(CGAL 5.5 REQUIRED)
add_library(touchstone_cgal INTERFACE)
target_compile_definitions(touchstone_cgal INTERFACE CGAL_USE_GMP CGAL_USE_MPFR)
target_compile_options(touchstone_cgal INTERFACE $<$<CXX_COMPILER_ID:GNU>:-frounding-math>)
target_include_directories(touchstone_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIRS})
target_link_libraries(touchstone_cgal INTERFACE MPFR::MPFR GMP::GMP)
