# SPDX-License-Identifier: Apache-2.0
# The toolchain of the preset wasm: Debian's emscripten, with WebAssembly's own exceptions.
#
# Boost and Eigen are headers of the machine that compiles. Boost's come from a folder of their own, because beside them in
# /usr/include lies the C library of that machine.
if(NOT EMSCRIPTEN_ROOT_PATH)
  set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten)
endif()
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/libcxx13.h")

set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Eigen of the machine that compiles")
set(Boost_INCLUDE_DIR ${CMAKE_BINARY_DIR}/boost CACHE PATH "A folder with a link to Boost of the machine that compiles")
if(NOT EXISTS ${Boost_INCLUDE_DIR}/boost)
  file(MAKE_DIRECTORY ${Boost_INCLUDE_DIR})
  file(CREATE_LINK /usr/include/boost ${Boost_INCLUDE_DIR}/boost SYMBOLIC)
endif()
