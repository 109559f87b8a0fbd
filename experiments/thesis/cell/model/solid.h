// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "experiments/cases/workloads/unit.h"
#include "geometry/shapes/pose.h"

// Shapes as they are written down, in the unit of their cell; what they are as faces is in solid_faces.h.
namespace touchstone::cell {

/// The closed cuboid between two corners. Requires lower < upper in each coordinate.
struct Box {
  Eigen::Vector3d lower, upper;
};

/// A cylinder with `sides` sides: the closed prism, along a coordinate axis, over a convex polygon inscribed in a
/// circle. Its corners are exact rational points of the circle. The first lies on the positive side of the next axis
/// (cyclically), the others at most 2^-20 of a turn from the corners of a regular polygon.
///
/// Requires ends that differ in the coordinate `axis` alone, a positive radius and 3 to 1000 sides.
struct Cylinder {
  int axis;  ///< 0, 1 or 2
  Eigen::Vector3d from, to;
  double radius;
  int sides;
};

/// The surface in a mesh file, with its coplanar triangles merged into polygons.
struct MeshFile {
  std::filesystem::path file;
  workloads::Unit unit;       ///< of the file's numbers
  workloads::Unit cell_unit;  ///< of the result
};

/// A polyhedron whose vertices lie on a sphere: circles of latitude with `sides` vertices each (at least 3), and the
/// two poles along z. Meridians have the least multiple of four that is not below `sides`, so that poles and equator
/// are exact.
struct Sphere {
  Eigen::Vector3d at;
  double radius;
  int sides;
};

struct Solid;

/// A regularised union, the first part without the others, or an intersection. Meshes cannot be parts.
struct Boolean {
  enum class Operation { Union, Difference, Intersection };
  Operation operation;
  std::vector<Solid> parts;  ///< at least one
};

/// A shape under a pose, which is an exact affine map for any matrix.
struct Solid {
  std::variant<Box, Cylinder, Sphere, MeshFile, Boolean> shape;
  Pose pose = {};
};

/// A named solid; links and machines consist of these.
struct Part {
  std::string name;
  Solid solid;
};

}  // namespace touchstone::cell
