// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/bvh/box.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::every_state_tests {

/// The arguments of one call of a public function. Their numbers are those to which the state of the floating-point
/// unit matters: subnormal numbers, zeros of either sign, thirds, the largest; in `any_...` also infinities and NaNs.
struct Input {
  std::uint64_t index;

  /// @{
  /// Legal: `find_fault` and `exact::validate` accept them.
  Ball ball;
  Polygon polygon;
  Triangle triangle;
  Eigen::Vector3d point;
  Pose pose;
  Mesh mesh;
  /// @}

  /// @{
  /// Legal or not: a number of some may be infinite, NaN, negative or repeated.
  Ball any_ball;
  Loop any_outer;
  std::vector<Loop> any_holes;
  Triangle any_triangle;
  Pose any_pose;
  double any_tolerance;
  /// @}

  std::vector<Box> boxes;  ///< finite, not empty

  /// A mesh file, of each format in turn, with numbers that are not doubles.
  struct File {
    std::string extension, bytes;
  } mesh_file;
};

/// Input number `index`: a function of it.
[[nodiscard]] Input draw_input(std::uint64_t index);

}  // namespace touchstone::every_state_tests
