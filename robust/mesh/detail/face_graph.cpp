// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/detail/face_graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace touchstone::mesh::detail {

FaceGraph::FaceGraph(const Mesh& welded, const std::vector<bool>& in_use) {
  begin_.push_back(0);
  for (std::uint32_t face = 0; face < welded.faces.size(); ++face) {
    if (in_use[face])
      for (const std::uint32_t vertex : welded.faces[face]) {
        face_.push_back(face);
        origin_.push_back(vertex);
      }
    begin_.push_back(static_cast<HalfEdge>(face_.size()));
  }
  join(std::vector<std::uint32_t>(face_.size(), 0));
}

void FaceGraph::split(const std::vector<std::vector<std::uint32_t>>& on_edge) {
  if (std::ranges::all_of(on_edge, [](const auto& vertices) { return vertices.empty(); })) return;
  const FaceGraph whole = std::move(*this);
  *this = FaceGraph();
  begin_.push_back(0);
  std::vector<std::uint32_t> apart;
  for (std::uint32_t face = 0; face + 1 < whole.begin_.size(); ++face) {
    const auto [first, last] = whole.sides(face);
    for (HalfEdge h = first; h < last; ++h) {
      const auto [kind, half_edges] = whole.edge_of(h);
      origin_.push_back(whole.origin(h));
      const auto& vertices = on_edge[whole.edge_[h]];
      if (whole.origin(h) == whole.origin(half_edges[0]))
        origin_.insert(origin_.end(), vertices.begin(), vertices.end());
      else
        origin_.insert(origin_.end(), vertices.rbegin(), vertices.rend());
      apart.resize(origin_.size(), kind == EdgeKind::Shared ? whole.edge_[h] + 1 : 0);
    }
    face_.resize(origin_.size(), face);
    begin_.push_back(static_cast<HalfEdge>(face_.size()));
  }
  join(apart);
}

void FaceGraph::join(const std::vector<std::uint32_t>& apart) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> ends_of;
  ends_of.reserve(face_.size());
  for (HalfEdge h = 0; h < face_.size(); ++h) {
    const auto [low, high] = std::minmax(origin_[h], origin_[next(h)]);
    ends_of.emplace_back(low, high, apart[h]);
  }
  by_edge_.resize(face_.size());
  std::iota(by_edge_.begin(), by_edge_.end(), 0U);
  std::sort(by_edge_.begin(), by_edge_.end(),
            [&](HalfEdge a, HalfEdge b) { return std::tie(ends_of[a], a) < std::tie(ends_of[b], b); });

  edge_.resize(face_.size());
  for (std::uint32_t begin = 0, end = 0; begin < by_edge_.size(); begin = end) {
    for (end = begin; end < by_edge_.size() && ends_of[by_edge_[end]] == ends_of[by_edge_[begin]]; ++end)
      edge_[by_edge_[end]] = static_cast<std::uint32_t>(kind_.size());
    first_.push_back(begin);
    const bool same_direction = end - begin == 2 && origin_[by_edge_[begin]] == origin_[by_edge_[begin + 1]];
    kind_.push_back(end - begin == 1  ? EdgeKind::Border
                    : end - begin > 2 ? EdgeKind::NonManifold
                    : same_direction  ? EdgeKind::Inconsistent
                                      : EdgeKind::Shared);
  }
  first_.push_back(static_cast<std::uint32_t>(by_edge_.size()));
}

}  // namespace touchstone::mesh::detail
