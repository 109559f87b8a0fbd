// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/studies/bench_scenes/measure.h"
#include "geometry/bvh/box.h"
#include "robust/filtered/detail/sets/triangle_groups.h"

namespace touchstone::bench_scenes {
namespace {

constexpr std::size_t kLine = 64;

BoxTree tree_of(const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box(triangle));
  return BoxTree(boxes);
}

bool meets_child(const Ball& ball, const BoxTree& tree, const BoxTree::Node& node, std::size_t child) {
  const auto scaled = [&tree](double length) { return length * tree.scale()[0] * tree.scale()[1]; };
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double center = scaled(ball.center[axis]), origin = node.origin[axis], step = node.step();
    const double low = origin + node.low[axis][child] * step, high = origin + node.high[axis][child] * step;
    const double gap = std::max({low - center, center - high, 0.0});
    squared += gap * gap;
  }
  const double radius = scaled(ball.radius);
  return squared <= radius * radius;
}

}  // namespace

MemoryModel::MemoryModel(const std::vector<Triangle>& triangles) : tree_(tree_of(triangles)) {
  std::vector<std::pair<std::size_t, int>> open{{0, 1}};
  while (!open.empty()) {
    const auto [number, level] = open.back();
    open.pop_back();
    levels_ = std::max(levels_, level);
    const BoxTree::Node& node = tree_.nodes()[number];
    for (std::size_t i = 0; i + node.leaf_count < node.child_count; ++i)
      open.emplace_back(node.first_node + i, level + 1);
  }
}

TouchedMemory MemoryModel::touched_by(std::span<const Ball> balls) const {
  std::size_t nodes = 0, leaves = 0;
  std::vector<std::size_t> open;
  for (const Ball& ball : balls) {
    open.assign(1, 0);
    while (!open.empty()) {
      const BoxTree::Node& node = tree_.nodes()[open.back()];
      open.pop_back();
      ++nodes;
      for (std::size_t child = 0; child < node.child_count; ++child) {
        if (!meets_child(ball, tree_, node, child)) continue;
        if (child < node.leaf_count)
          ++leaves;
        else
          open.push_back(node.first_node + (child - node.leaf_count));
      }
    }
  }
  const auto mean = [&balls](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(balls.size());
  };
  constexpr std::size_t kNode = sizeof(BoxTree::Node) / kLine, kLeaf = sizeof(filtered::detail::TriangleGroup) / kLine;
  return {mean(nodes), mean(leaves), mean(kNode * nodes + kLeaf * leaves), levels_};
}

}  // namespace touchstone::bench_scenes
