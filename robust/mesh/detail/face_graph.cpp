// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/detail/face_graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/bvh/box_tree.h"
#include "geometry/detail/parts_in_parallel.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/detail/tree_walk.h"

namespace touchstone::mesh::detail {
namespace {

using Eigen::Vector3d;

std::vector<std::uint32_t> finite_of(std::span<const Vector3d> points) {
  std::vector<std::uint32_t> finite;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite()) finite.push_back(i);
  return finite;
}

std::vector<Box> boxes_of(std::span<const Vector3d> points, const std::vector<std::uint32_t>& numbers) {
  std::vector<Box> boxes;
  boxes.reserve(numbers.size());
  for (const std::uint32_t number : numbers) boxes.push_back({points[number], points[number]});
  return boxes;
}

bool is_on_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  if ((point.array() < a.cwiseMin(b).array()).any() || (point.array() > a.cwiseMax(b).array()).any()) return false;
  for (int x = 0; x < 3; ++x)
    if (const int y = (x + 1) % 3; exact::detail::orientation(a[x], a[y], b[x], b[y], point[x], point[y]) != 0)
      return false;
  return true;
}

bool precedes(const Vector3d& a, const Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Finds the vertices of a welded mesh on a line segment. Requires round to nearest, without flush-to-zero.
class VertexTree {
 public:
  /// Requires points that are all different. They are not copied. Leaves out those that are not finite. Cost: that of
  /// BoxTree.
  explicit VertexTree(std::span<const Vector3d> points);

  /// Returns the numbers of the points strictly between points a and b, which must be finite, on the way from a to b.
  /// Exact. Cost: O(log n) nodes of a tree and about 10 ns per point near the segment, unless the points are spread
  /// along it.
  [[nodiscard]] std::vector<std::uint32_t> between(std::uint32_t a, std::uint32_t b) const;

 private:
  VertexTree(std::span<const Vector3d> points, std::vector<std::uint32_t> finite);

  std::span<const Vector3d> points_;
  std::vector<std::uint32_t> finite_;
  BoxTree tree_;  ///< over the finite points
};

VertexTree::VertexTree(std::span<const Vector3d> points) : VertexTree(points, finite_of(points)) {}

VertexTree::VertexTree(std::span<const Vector3d> points, std::vector<std::uint32_t> finite)
    : points_(points), finite_(std::move(finite)), tree_(boxes_of(points, finite_)) {}

std::vector<std::uint32_t> VertexTree::between(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> found;
  const scene::detail::CullingMotion culling(Motion({points_[a], 0}, points_[b]), tree_);
  const auto visit = [&](std::span<const scene::detail::Leaf> leaves) {
    for (const scene::detail::Leaf& leaf : leaves)
      for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place) {
        const std::uint32_t number = finite_[tree_.order()[place]];
        if (number != a && number != b && is_on_segment(points_[number], points_[a], points_[b]))
          found.push_back(number);
      }
    return false;
  };
  scene::detail::walk<1>(tree_, culling, visit, [](const scene::detail::Leaf&) {});
  // Points of a line are in order along it.
  const bool forward = precedes(points_[a], points_[b]);
  std::ranges::sort(found, [&](std::uint32_t i, std::uint32_t j) {
    return forward ? precedes(points_[i], points_[j]) : precedes(points_[j], points_[i]);
  });
  return found;
}

}  // namespace

FaceGraph::FaceGraph(const Mesh& welded, const std::vector<bool>& in_use, const std::atomic<bool>& stop) {
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

  constexpr std::size_t kAtOnce = 256;
  const VertexTree vertices(welded.vertices);
  std::vector<std::vector<std::uint32_t>> on_edge(edge_count());
  each_in_parallel(on_edge.size(), kAtOnce, [&](std::size_t number) {
    if (stop) return;
    const HalfEdge h = edge(number).half_edges[0];
    on_edge[number] = vertices.between(origin(h), origin(next(h)));
  });
  split(on_edge);
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
    for_free_neighbours(queue[k], [&](std::uint32_t neighbour) {
      part_of_[neighbour] = number;
      queue.push_back(neighbour);
    });
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
