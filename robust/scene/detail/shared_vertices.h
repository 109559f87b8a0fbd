// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/triangle.h"

namespace touchstone::scene::detail {

/// A triangle whose vertices are stored elsewhere.
struct SharedTriangle {
  const Eigen::Vector3d &a, &b, &c;

  [[nodiscard]] Triangle copy() const { return {a, b, c}; }
};

/// Triangles that are stored as the numbers of their vertices, by place in a tree. In a mesh most triangles share
/// vertices with their neighbours.
///
/// Parts of kPart triangles have their own vertices: so numbers fit into 16 bits, and all cores can share the work.
/// Vertices are the same only if their bits are, so that no triangle changes. Memory: 19 to 21 bytes per triangle of
/// a large closed mesh; 79 where no two triangles share a vertex.
class TrianglesOfSharedVertices {
 public:
  /// Takes the triangles by number, and the number at each place. Cost: linear, about 30 ns per triangle and core.
  TrianglesOfSharedVertices(std::span<const Triangle> by_number, std::span<const std::uint32_t> order);

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] __attribute__((always_inline)) SharedTriangle operator[](std::size_t place) const {
    const Corners& corners = corners_[place];
    const Eigen::Vector3d* of_part = vertices_.data() + first_vertex_[place / kPart];
    return {of_part[corners[0]], of_part[corners[1]], of_part[corners[2]]};
  }
  /// Returns the bytes of all triangles.
  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::size_t kPart = std::size_t{1} << 13;

  using Corners = std::array<std::uint16_t, 3>;

  std::vector<Corners> corners_;           ///< by place; counted from the part's first vertex
  std::vector<Eigen::Vector3d> vertices_;  ///< part by part
  std::vector<std::size_t> first_vertex_;  ///< by part
};

}  // namespace touchstone::scene::detail
