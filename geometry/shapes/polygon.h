// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "../floating_point.h"
#include "rejection.h"

namespace touchstone {

/// The vertices of a closed loop, in order. An edge joins the last to the first.
using Loop = std::vector<Eigen::Vector3d>;

/// A polygon in space: one outer loop and any number of holes. Loops have at least three vertices, may be oriented
/// either way and need not be convex.
///
/// Vertices are numbered through all loops, first those of the outer loop, then those of the holes. Edge i runs from
/// vertex i to vertex `next(i)`. The polygon stands for a closed planar region: every vertex is moved onto the
/// supporting plane of the outer loop, along the axis of the normal's largest component, and the moved loops bound the
/// region by the even-odd rule. The constructor checks only what single comparisons decide; `exact::validate` decides
/// whether the loops have a normal, and neither cross nor overlap.
///
/// Stores one array of coordinates per axis. Two polygons are equal if their loops are, vertex by vertex (0 = -0).
class Polygon {
 public:
  /// Builds the polygon from its loops. Throws Rejected with `not-finite`, `too-few-vertices` or `repeated-vertex` (the
  /// first that applies); the message names the loop and the vertex. Cost: linear.
  explicit Polygon(const Loop& outer, const std::vector<Loop>& holes = {});

  /// Returns the number of vertices of all loops, which is also the number of edges.
  [[nodiscard]] std::size_t vertex_count() const { return coordinates_[0].size(); }
  /// Returns the number of loops: 1 plus the number of holes.
  [[nodiscard]] std::size_t loop_count() const { return loop_ends_.size(); }

  /// Returns vertex i. Requires i < vertex_count(), as do all functions that take a vertex.
  [[nodiscard]] Eigen::Vector3d vertex(std::size_t i) const {
    assert(i < vertex_count());
    return {coordinates_[0][i], coordinates_[1][i], coordinates_[2][i]};
  }
  /// Returns the coordinates of all vertices along one axis (0, 1 or 2).
  [[nodiscard]] std::span<const double> coordinates(int axis) const {
    assert(axis >= 0 && axis < 3);
    return coordinates_[static_cast<std::size_t>(axis)];
  }

  /// @{
  /// Returns the first vertex of a loop, and one past its last. Loop 0 is the outer loop. Requires loop < loop_count().
  [[nodiscard]] std::size_t loop_begin(std::size_t loop) const { return loop == 0 ? 0 : loop_end(loop - 1); }
  [[nodiscard]] std::size_t loop_end(std::size_t loop) const {
    assert(loop < loop_count());
    return loop_ends_[loop];
  }
  /// @}
  /// Returns the loop to which vertex i and edge i belong. Cost: logarithmic in the number of loops.
  [[nodiscard]] std::size_t loop_of(std::size_t i) const;

  /// @{
  /// Returns a neighbour of vertex i in its loop.
  [[nodiscard]] std::size_t next(std::size_t i) const {
    assert(i < vertex_count());
    return next_[i];
  }
  [[nodiscard]] std::size_t previous(std::size_t i) const {
    assert(i < vertex_count());
    return previous_[i];
  }
  /// @}

  [[nodiscard]] bool operator==(const Polygon& other) const;

 private:
  std::array<std::vector<double>, 3> coordinates_;
  std::vector<std::size_t> loop_ends_;
  std::vector<std::size_t> next_, previous_;
};

/// Returns how messages name a loop: `the outer loop`, `hole 0`, `hole 1`, ...
[[nodiscard]] std::string loop_name(std::size_t loop);

}  // namespace touchstone
