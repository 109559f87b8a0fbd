// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::scene_tests {

/// Closed triangles.
enum class SolidKind {
  Lattice,  ///< tetrahedra on a few points of a lattice, which cross, touch and share faces; some are turned
  Round,    ///< tetrahedra and octahedra of any doubles, one in the other or apart
  Voxels,   ///< the surface of cubes of a lattice, which meet in faces, edges and vertices
};

struct SolidSample {
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3d> points;
};

/// A solid, and points on its vertices, edges and faces, beside them by one double, level with them, and anywhere. A
/// function of the arguments. Coordinates are 2^-1074 to 2^1024 large.
[[nodiscard]] SolidSample draw_solid(SolidKind kind, std::uint64_t seed, std::uint64_t index);

/// Cubes of a lattice, each filled or empty.
class Voxels {
 public:
  /// Fills about half of size^3 cubes.
  Voxels(int size, std::uint64_t seed, std::uint64_t index);

  /// Returns the faces between filled and empty cubes, each cut along one of its diagonals. The corners of cubes are
  /// moved by integers, `shear` times their height, along x.
  [[nodiscard]] std::vector<Triangle> surface(int shear) const;
  /// Returns where the point at half of these integers lies, if nothing is sheared.
  [[nodiscard]] PointLocation locate(const std::array<int, 3>& halves) const;

 private:
  [[nodiscard]] bool filled(int x, int y, int z) const;

  int size_;
  std::vector<bool> filled_;
};

/// Where points lie, in integers: the signed crossings of a segment in a direction that meets no edge. Nothing of the
/// library is used.
class IntegerSolid {
 public:
  explicit IntegerSolid(const std::vector<Triangle>& triangles);

  [[nodiscard]] PointLocation locate(const Eigen::Vector3d& point) const;

 private:
  using Point = std::array<mpz_class, 3>;

  void in_units(int unit, std::vector<std::array<Point, 3>>& triangles) const;

  std::vector<Triangle> given_;
  int unit_ = 1024;                              ///< the exponent of their lowest bit
  std::vector<std::array<Point, 3>> triangles_;  ///< in units of this bit
};

}  // namespace touchstone::scene_tests
