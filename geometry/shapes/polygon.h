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

/// The vertices of a closed loop in order; the last is joined to the first.
using Loop = std::vector<Eigen::Vector3d>;

/// One outer loop and any number of hole loops in space, each of at least three vertices, of either orientation,
/// convex or not.
///
/// Vertices are numbered in order, the outer loop's first, then the holes'; edge i runs from vertex i to `next(i)`.
/// The region meant is the closed planar one that the loops bound (even-odd) once every vertex is moved, along the
/// axis of the normal's largest component, onto the supporting plane of the outer loop. A Polygon only promises what
/// single comparisons decide; that its loops have a normal and do not meet is decided by `exact::validate`.
///
/// Coordinates are kept as one array an axis. Equality is that of the loops, vertex by vertex (0 = -0).
class Polygon {
 public:
  /// Throws Rejected with `not-finite`, `too-few-vertices` or `repeated-vertex` (the first that applies), naming the
  /// loop and the vertex. Cost: linear.
  explicit Polygon(const Loop& outer, const std::vector<Loop>& holes = {});

  /// Of all loops together: as many as there are edges.
  [[nodiscard]] std::size_t vertex_count() const { return coordinates_[0].size(); }
  /// One more than there are holes.
  [[nodiscard]] std::size_t loop_count() const { return loop_ends_.size(); }

  /// Vertex i, of whichever loop. Requires i < vertex_count(), as all that takes a vertex does.
  [[nodiscard]] Eigen::Vector3d vertex(std::size_t i) const {
    assert(i < vertex_count());
    return {coordinates_[0][i], coordinates_[1][i], coordinates_[2][i]};
  }
  /// The coordinates of all vertices along one axis (0, 1 or 2).
  [[nodiscard]] std::span<const double> coordinates(int axis) const {
    assert(axis >= 0 && axis < 3);
    return coordinates_[static_cast<std::size_t>(axis)];
  }

  /// @{
  /// First vertex of a loop, and one past its last; loop 0 is the outer one. Requires loop < loop_count().
  [[nodiscard]] std::size_t loop_begin(std::size_t loop) const { return loop == 0 ? 0 : loop_end(loop - 1); }
  [[nodiscard]] std::size_t loop_end(std::size_t loop) const {
    assert(loop < loop_count());
    return loop_ends_[loop];
  }
  /// @}
  /// The loop that holds vertex i, and edge i. Cost: logarithmic in the number of loops.
  [[nodiscard]] std::size_t loop_of(std::size_t i) const;

  /// @{
  /// The neighbours of vertex i in its loop.
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

/// `the outer loop`, `hole 0`, `hole 1`, ...: how messages name a loop.
[[nodiscard]] std::string loop_name(std::size_t loop);

}  // namespace touchstone
