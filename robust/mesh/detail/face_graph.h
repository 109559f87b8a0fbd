// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/shapes/mesh.h"

namespace touchstone::mesh::detail {

/// A side of a face, directed along the face's loop. Numbered face by face.
using HalfEdge = std::uint32_t;

/// The adjacency of the faces of a welded mesh.
class FaceGraph {
 public:
  enum class EdgeKind {
    Border,        ///< one half-edge
    NonManifold,   ///< more than two half-edges
    Inconsistent,  ///< two half-edges in the same direction
    Shared,        ///< two half-edges in opposite directions
  };
  struct Edge {
    EdgeKind kind;
    std::span<const HalfEdge> half_edges;  ///< ascending
  };

  /// Builds the graph. Faces that are not in use get no half-edges. Requires that no face in use repeats a vertex.
  /// Cost: O(n log n).
  FaceGraph(const Mesh& welded, const std::vector<bool>& in_use);

  /// Splits edges: on_edge[e] are vertices between the ends of edge e, in order from the origin of its first half-edge.
  /// Faces that share an edge share its parts, whatever other edges have the same ends as these. Half-edges and edges
  /// get other numbers. Cost: O(n log n), nothing if there are no such vertices.
  void split(const std::vector<std::vector<std::uint32_t>>& on_edge);

  [[nodiscard]] std::uint32_t face(HalfEdge h) const { return face_[h]; }
  [[nodiscard]] std::uint32_t origin(HalfEdge h) const { return origin_[h]; }
  [[nodiscard]] HalfEdge next(HalfEdge h) const { return h + 1 == begin_[face_[h] + 1] ? begin_[face_[h]] : h + 1; }
  /// Returns the half-edges [first, last) of a face.
  [[nodiscard]] std::pair<HalfEdge, HalfEdge> sides(std::uint32_t face) const {
    return {begin_[face], begin_[face + 1]};
  }

  [[nodiscard]] std::size_t edge_count() const { return kind_.size(); }
  [[nodiscard]] Edge edge(std::size_t number) const {
    return {kind_[number], std::span(by_edge_).subspan(first_[number], first_[number + 1] - first_[number])};
  }
  [[nodiscard]] Edge edge_of(HalfEdge h) const { return edge(edge_[h]); }
  /// Returns the other half-edge of a shared edge. Requires EdgeKind::Shared.
  [[nodiscard]] HalfEdge twin(HalfEdge h) const {
    const auto both = edge_of(h).half_edges;
    return both[0] == h ? both[1] : both[0];
  }

 private:
  FaceGraph() = default;

  /// Makes an edge of all half-edges with the same ends and the same number in `apart`.
  void join(const std::vector<std::uint32_t>& apart);

  std::vector<HalfEdge> begin_;               // by face
  std::vector<std::uint32_t> face_, origin_;  // by half-edge
  std::vector<std::uint32_t> edge_;           // by half-edge
  std::vector<EdgeKind> kind_;                // by edge
  std::vector<std::uint32_t> first_;          // by edge, in by_edge_
  std::vector<HalfEdge> by_edge_;
};

}  // namespace touchstone::mesh::detail
