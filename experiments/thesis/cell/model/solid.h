// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "experiments/cases/workloads/unit.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"

// Shapes as they are written down, in the unit of their cell; SolidFaces are what they are as faces.
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
  /// Factors of the coordinates, not 0. If their product is negative, the solid is mirrored, and its faces are turned
  /// round, so that they still face outside.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
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

/// Returns an axis-parallel box around the solid: around the first part of a difference or an intersection, around all
/// parts of a union; up to rounding errors. Reads the mesh of a MeshFile, and throws BrokenMesh.
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Solid& solid);

/// Thrown for a solid with a face that the contract rejects; the message names the solid and the face.
class BadSolid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A face of a solid: a polygon that exact::validate accepts, its outer loop counter-clockwise seen from outside.
struct Face {
  Polygon polygon;
  double off_plane;  ///< as in the contract: how far rounding has moved its vertices off one plane
};

/// The maximal faces of a solid: coplanar neighbours are one face, which may have holes.
struct SolidFaces {
  std::vector<Face> faces;
  /// The exact volume before rounding vertices, as the nearest double; none for a mesh.
  std::optional<double> volume;
  std::size_t merged_from = 0;  ///< the number of triangles and polygons of the mesh file; 0 for other solids

  [[nodiscard]] std::size_t vertices() const;  ///< summed over the faces
  [[nodiscard]] std::size_t holes() const;
  [[nodiscard]] double off_plane() const;  ///< the largest over the faces
};

/// Returns twice the area of a polygon's outer loop, as a vector that points where it is counter-clockwise from. In
/// doubles.
[[nodiscard]] Eigen::Vector3d doubled_area(const Polygon& polygon);

/// Points without duplicates, numbered in order of first use.
class NumberedPoints {
 public:
  [[nodiscard]] std::uint32_t number(const Eigen::Vector3d& point) {
    const auto [found, is_new] =
        numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.push_back(point);
    return found->second;
  }

  std::vector<Eigen::Vector3d> points;

 private:
  std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

/// Returns the faces that bound the solid. Evaluates boxes, cylinders and their Booleans exactly, rounds every vertex
/// once, to the nearest double in each coordinate, and validates every face again. Neighbouring faces share vertices
/// and edges. The result is a function of the solid alone.
///
/// `name` begins the messages. Throws BadSolid for a face that is rejected once its vertices are rounded, a solid with
/// an empty interior, a mesh within a Boolean, or a face of a mesh that the contract rejects; BrokenMesh for a file
/// that cannot be read. Cost: about 10 ms per primitive of a Boolean; that of mesh::merge_faces for a mesh.
[[nodiscard]] SolidFaces faces_of(const Solid& solid, const std::string& name);

}  // namespace touchstone::cell
