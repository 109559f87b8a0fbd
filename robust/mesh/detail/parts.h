// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "robust/mesh/detail/face_graph.h"

namespace touchstone::mesh::detail {

/// Groups of faces, no two of which may be in the same part. Each group is connected.
using Conflict = std::vector<std::vector<std::uint32_t>>;

/// A partition of faces into parts that are connected by shared edges.
class Parts {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Parts(const FaceGraph& graph, std::size_t face_count) : graph_(&graph), part_of_(face_count, kNone) {}

  [[nodiscard]] bool taken(std::uint32_t face) const { return part_of_[face] != kNone; }
  [[nodiscard]] std::uint32_t part_of(std::uint32_t face) const { return part_of_[face]; }
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
  const FaceGraph* graph_;
  std::vector<std::uint32_t> part_of_;             // by face
  std::vector<std::vector<std::uint32_t>> faces_;  // by part
};

template <class Admits>
std::uint32_t Parts::grow(std::uint32_t seed, const Admits& admits) {
  const std::uint32_t part = count();
  std::vector<std::uint32_t> faces{seed};
  part_of_[seed] = part;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto [first, last] = graph_->sides(faces[k]);
    for (HalfEdge h = first; h < last; ++h) {
      if (graph_->edge_of(h).kind != FaceGraph::EdgeKind::Shared) continue;
      const std::uint32_t neighbour = graph_->face(graph_->twin(h));
      if (taken(neighbour) || !admits(neighbour)) continue;
      part_of_[neighbour] = part;
      faces.push_back(neighbour);
    }
  }
  faces_.push_back(std::move(faces));
  return part;
}

}  // namespace touchstone::mesh::detail
