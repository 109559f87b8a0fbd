// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// A virtual object: an invisible face, box, sphere or capsule that takes no room, and notices what comes into it.
struct Zone {
  struct Face {
    std::vector<Eigen::Vector3d> corners;  ///< of a convex polygon, in order; a fan of triangles
  };
  struct Cuboid {
    Eigen::Vector3d lower, upper;
  };
  /// All points within a radius of a segment, which is a point for a sphere.
  struct Capsule {
    Eigen::Vector3d from, to;
    double radius;
  };

  std::string name;
  std::variant<Face, Cuboid, Capsule> shape;
  Pose pose = {};      ///< in the cell
  bool stops = false;  ///< whether the robot stops when something comes into it
};

}  // namespace touchstone::cell
