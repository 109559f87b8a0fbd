// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/detail/parts.h"

#include <algorithm>
#include <utility>

namespace touchstone::mesh::detail {

void Parts::split(std::uint32_t part, const Conflict& conflict) {
  const std::vector<std::uint32_t> all = std::move(faces_[part]);
  std::vector<std::uint32_t> queue;
  queue.reserve(all.size());
  for (const std::uint32_t face : all) part_of_[face] = kNone;
  for (std::size_t group = 0; group < conflict.size(); ++group) {
    const std::uint32_t number = group == 0 ? part : count();
    if (group > 0) faces_.emplace_back();
    for (const std::uint32_t face : conflict[group]) {
      part_of_[face] = number;
      queue.push_back(face);
    }
  }
  faces_[part].clear();
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const std::uint32_t number = part_of_[queue[k]];
    faces_[number].push_back(queue[k]);
    const auto [first, last] = graph_->sides(queue[k]);
    for (HalfEdge h = first; h < last; ++h) {
      if (graph_->edge_of(h).kind != FaceGraph::EdgeKind::Shared) continue;
      const std::uint32_t neighbour = graph_->face(graph_->twin(h));
      if (taken(neighbour)) continue;
      part_of_[neighbour] = number;
      queue.push_back(neighbour);
    }
  }
}

Parts::Loops Parts::boundary(std::uint32_t part) const {
  std::vector<HalfEdge> sides;
  for (const std::uint32_t face : faces_[part]) {
    const auto [first, last] = graph_->sides(face);
    for (HalfEdge h = first; h < last; ++h)
      if (!inside(h)) sides.push_back(h);
  }
  std::sort(sides.begin(), sides.end());
  std::vector<bool> seen(sides.size());
  Loops loops;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (seen[k]) continue;
    auto& loop = loops.emplace_back();
    HalfEdge h = sides[k];
    do {
      seen[static_cast<std::size_t>(std::lower_bound(sides.begin(), sides.end(), h) - sides.begin())] = true;
      loop.push_back(h);
      // About the end of h, over the faces of one fan, to the side by which the boundary leaves it.
      for (h = graph_->next(h); inside(h);) h = graph_->next(graph_->twin(h));
    } while (h != sides[k]);
  }
  return loops;
}

std::optional<Conflict> Parts::torn_edge(std::uint32_t part) const {
  for (const std::uint32_t face : faces_[part]) {
    const auto [first, last] = graph_->sides(face);
    for (HalfEdge h = first; h < last; ++h) {
      const auto [kind, half_edges] = graph_->edge_of(h);
      if (kind == FaceGraph::EdgeKind::Shared || kind == FaceGraph::EdgeKind::Border) continue;
      Conflict conflict;
      for (const HalfEdge other : half_edges)
        if (part_of_[graph_->face(other)] == part) conflict.push_back({graph_->face(other)});
      if (conflict.size() > 1) return conflict;
    }
  }
  return std::nullopt;
}

}  // namespace touchstone::mesh::detail
