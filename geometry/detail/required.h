// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

/// What functions of the library require of an argument without looking at it: a debug build asserts it, one with
/// NDEBUG does nothing. What is looked at always is in the contract, "Wrong arguments".
namespace touchstone {

/// The ball, which `find_fault` accepts.
inline const Ball& required(const Ball& ball) {
  assert(!find_fault(ball));
  return ball;
}

/// The triangle, whose vertices are finite. That they are not collinear is required, too, but takes more than a look.
inline const Triangle& required(const Triangle& triangle) {
  assert(triangle.a.allFinite() && triangle.b.allFinite() && triangle.c.allFinite());
  return triangle;
}

/// The centre, whose coordinates are finite.
inline const Eigen::Vector3d& required(const Eigen::Vector3d& center) {
  assert(center.allFinite());
  return center;
}

/// Throws std::invalid_argument for spans that go together and differ in length, naming both.
inline void expect_equal_lengths(const char* first, std::size_t first_size, const char* second,
                                 std::size_t second_size) {
  if (first_size == second_size) return;
  throw std::invalid_argument(std::to_string(first_size) + ' ' + first + " do not go with " +
                              std::to_string(second_size) + ' ' + second);
}

}  // namespace touchstone
