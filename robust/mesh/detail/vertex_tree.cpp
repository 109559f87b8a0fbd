// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/detail/vertex_tree.h"

#include <algorithm>
#include <utility>

#include "geometry/bvh/box.h"
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

}  // namespace

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

}  // namespace touchstone::mesh::detail
