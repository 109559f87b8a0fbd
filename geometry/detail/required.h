// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

/// Checks of arguments.
///
/// The functions `required` assert preconditions in debug builds; with NDEBUG they do nothing. The contract, "Wrong
/// arguments", lists what is always checked.
namespace touchstone {

/// Returns the ball. Asserts that `find_fault` accepts it.
inline const Ball& required(const Ball& ball) {
  assert(!find_fault(ball));
  return ball;
}

/// Returns the motion. Asserts that `find_fault` accepts it.
inline const Motion& required(const Motion& motion) {
  assert(!find_fault(motion));
  return motion;
}

/// Returns the triangle. Asserts that its vertices are finite; in `fast`, that they are not collinear would be
/// expensive to check.
inline const Triangle& required(const Triangle& triangle) {
  assert(triangle.a.allFinite() && triangle.b.allFinite() && triangle.c.allFinite());
  return triangle;
}

/// Returns the centre. Asserts that its coordinates are finite.
inline const Eigen::Vector3d& required(const Eigen::Vector3d& center) {
  assert(center.allFinite());
  return center;
}

/// Returns the items of a batch. Asserts of each what the functions above assert of one.
template <class Item>
std::span<const Item> required(std::span<const Item> items) {
  for (const Item& item : items) (void)required(item);
  return items;
}

/// Throws std::invalid_argument, naming both, if two spans that belong together differ in length.
inline void expect_equal_lengths(const char* first, std::size_t first_size, const char* second,
                                 std::size_t second_size) {
  if (first_size == second_size) return;
  throw std::invalid_argument(std::to_string(first_size) + ' ' + first + " but " + std::to_string(second_size) + ' ' +
                              second);
}

}  // namespace touchstone
