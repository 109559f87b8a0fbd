# SPDX-License-Identifier: GPL-3.0-or-later
# What tests do themselves need not be fast; what they test is compiled as it is released.
add_compile_options($<$<CONFIG:Release>:-O1>)

# RC_PARAMS scales the properties; a failure prints the seed that replays it.
math(EXPR property_samples "${TOUCHSTONE_SAMPLES} * 10")
set(properties_environment "RC_PARAMS=max_success=${property_samples}")

# touchstone_tests(NAME [OPTIMISED] [LABELS label...] [ROOMS room...] SOURCES file...)
#
# The program tests/NAME_tests of one folder of tests, which links the rooms that it tests; without any, the libraries
# alone. CTest runs it whole, as NAME.tests with the label NAME beside the others, because tests share what the first of
# them makes, such as the solids of a cell; what fails is named in the output. Release builds compile it at -O0, which
# takes a fifth less time than -O1, or, if OPTIMISED, at -O1, because its tests run long.
function(touchstone_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 tests "OPTIMISED" "" "LABELS;ROOMS;SOURCES")
  add_executable(${name}_tests ${tests_SOURCES})
  compile_together(${name}_tests)
  target_compile_definitions(${name}_tests PRIVATE TOUCHSTONE_SAMPLES=${TOUCHSTONE_SAMPLES}
                             TOUCHSTONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  list(TRANSFORM tests_ROOMS PREPEND touchstone_)
  target_link_libraries(${name}_tests PRIVATE ${tests_ROOMS} touchstone_robust touchstone_options GTest::gtest_main
                        rapidcheck)
  set(options "")
  if(NOT tests_OPTIMISED)
    set(options $<$<CONFIG:Release>:-O0>)
    target_compile_options(${name}_tests PRIVATE ${options})
  endif()
  precompile_headers(${name}_tests <algorithm> <cmath> <filesystem> <functional> <optional> <string> <vector> <Eigen/Core>
                     <Eigen/Geometry> <gtest/gtest.h> <rapidcheck/gtest.h>
                     OPTIONS ${options} LIBRARIES touchstone_options Eigen3::Eigen GTest::gtest_main rapidcheck)
  set_target_properties(${name}_tests PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_test(NAME ${name}.tests COMMAND ${name}_tests --gtest_brief=1)
  set_tests_properties(${name}.tests PROPERTIES ENVIRONMENT "${properties_environment}" LABELS "${name};${tests_LABELS}")
endfunction()

# touchstone_script(NAME SCRIPT argument...): a test that Python runs, of a script in the folder of tests.
function(touchstone_script name script)
  add_test(NAME ${name} COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/${script} ${ARGN})
endfunction()
