// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
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

  /// Builds the graph, whose edges are split at the vertices of the mesh on them. Faces that share an edge share its
  /// parts, whatever other edges have the same ends as these. Faces that are not in use get no half-edges. Edges that
  /// were not looked at before `stop` was set are not split. Requires that no face in use repeats a vertex, and round
  /// to nearest without flush-to-zero. Cost: O(n log n).
  FaceGraph(const Mesh& welded, const std::vector<bool>& in_use, const std::atomic<bool>& stop);

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

  /// Splits edges: on_edge[e] are vertices between the ends of edge e, in order from the origin of its first half-edge.
  /// Half-edges and edges get other numbers. Cost: O(n log n), nothing if there are no such vertices.
  void split(const std::vector<std::vector<std::uint32_t>>& on_edge);
  /// Makes an edge of all half-edges with the same ends and the same number in `apart`.
  void join(const std::vector<std::uint32_t>& apart);

  std::vector<HalfEdge> begin_;               // by face
  std::vector<std::uint32_t> face_, origin_;  // by half-edge
  std::vector<std::uint32_t> edge_;           // by half-edge
  std::vector<EdgeKind> kind_;                // by edge
  std::vector<std::uint32_t> first_;          // by edge, in by_edge_
  std::vector<HalfEdge> by_edge_;
};

/// Groups of faces, no two of which may be in the same part. Each group is connected.
using Conflict = std::vector<std::vector<std::uint32_t>>;

/// A partition of faces into parts that are connected by shared edges.
class Parts {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Parts(const FaceGraph& graph, std::size_t face_count) : graph_(&graph), part_of_(face_count, kNone) {}

  [[nodiscard]] bool taken(std::uint32_t face) const { return part_of_[face] != kNone; }
  /// Returns the faces of a part, in the order of a breadth-first search.
  [[nodiscard]] const std::vector<std::uint32_t>& faces(std::uint32_t part) const { return faces_[part]; }
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(faces_.size()); }

  /// Adds a part: a face, and all faces reachable from it over shared edges and faces that are not taken and for which
  /// admits(face) is true. Cost: linear.
  template <class Admits>
  std::uint32_t grow(std::uint32_t seed, const Admits& admits);

  /// Cuts a part: every face joins the group of the conflict that is the fewest edges away. The first group keeps the
  /// number of the part, the others are added at the end. Requires that every face that has sides is in some part.
  /// Cost: linear.
  void split(std::uint32_t part, const Conflict& conflict);

  /// Returns whether two faces of one part share this side.
  [[nodiscard]] bool inside(HalfEdge h) const {
    return graph_->edge_of(h).kind == FaceGraph::EdgeKind::Shared &&
           part_of_[graph_->face(h)] == part_of_[graph_->face(graph_->twin(h))];
  }

  /// Loops of half-edges, each of which starts where the one before it ends. A loop begins with its lowest half-edge;
  /// loops are ordered by it.
  using Loops = std::vector<std::vector<HalfEdge>>;
  [[nodiscard]] Loops boundary(std::uint32_t part) const;

  /// Returns the faces at an edge that several faces of the part have but do not share; the first such edge of the
  /// first such face.
  [[nodiscard]] std::optional<Conflict> torn_edge(std::uint32_t part) const;

 private:
  /// Calls f(neighbour) for the faces that share an edge with a face and are not taken.
  template <class F>
  void for_free_neighbours(std::uint32_t face, const F& f) const {
    const auto [first, last] = graph_->sides(face);
    for (HalfEdge h = first; h < last; ++h) {
      if (graph_->edge_of(h).kind != FaceGraph::EdgeKind::Shared) continue;
      if (const std::uint32_t neighbour = graph_->face(graph_->twin(h)); !taken(neighbour)) f(neighbour);
    }
  }

  const FaceGraph* graph_;
  std::vector<std::uint32_t> part_of_;             // by face
  std::vector<std::vector<std::uint32_t>> faces_;  // by part
};

template <class Admits>
std::uint32_t Parts::grow(std::uint32_t seed, const Admits& admits) {
  const std::uint32_t part = count();
  std::vector<std::uint32_t> faces{seed};
  part_of_[seed] = part;
  for (std::size_t k = 0; k < faces.size(); ++k)
    for_free_neighbours(faces[k], [&](std::uint32_t neighbour) {
      if (!admits(neighbour)) return;
      part_of_[neighbour] = part;
      faces.push_back(neighbour);
    });
  faces_.push_back(std::move(faces));
  return part;
}

}  // namespace touchstone::mesh::detail
