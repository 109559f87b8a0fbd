// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/chain_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace touchstone::filtered {
namespace {

struct Point {
  double x, y;
};

/// Center, axis and halves, as a node keeps them.
struct Box {
  double center_x = 0, center_y = 0, axis_x = 1, axis_y = 0, half_along = -0x1p500, half_across = -0x1p500;
  [[nodiscard]] double area() const { return half_along * half_across; }
};

/// A number of consecutive edges, or of whole loops, and what a node keeps of it.
struct Chain {
  std::size_t begin = 0, end = 0;  // edges
  double first_y = 0, last_y = 0;
  std::uint32_t first_vertex = 0, last_vertex = 0;
  std::int32_t child = 0;

  [[nodiscard]] bool is_closed() const { return first_vertex == last_vertex; }
};

/// The ends of a chain's edges: edges of one loop share theirs, those of several loops do not.
template <class F>
void for_each_point(std::span<const ChainTree::Edge> edges, const Chain& chain, const F& f) {
  for (std::size_t i = chain.begin; i < chain.end; ++i) {
    f(Point{edges[i].start_x, edges[i].start_y});
    f(Point{edges[i].end_x, edges[i].end_y});
  }
}

Box box_along(std::span<const ChainTree::Edge> edges, const Chain& chain, Point axis) {
  double least_along = 0x1p500, most_along = -0x1p500, least_across = 0x1p500, most_across = -0x1p500;
  for_each_point(edges, chain, [&](const Point& p) {
    const double along = p.x * axis.x + p.y * axis.y, across = p.y * axis.x - p.x * axis.y;
    least_along = std::min(least_along, along), most_along = std::max(most_along, along);
    least_across = std::min(least_across, across), most_across = std::max(most_across, across);
  });
  const double along = (least_along + most_along) / 2, across = (least_across + most_across) / 2;
  // Coordinates are at most 1 in magnitude: products and sums of a few are off by a few units of 2^-53.
  constexpr double rounding = 0x1p-48;
  return {along * axis.x - across * axis.y,          along * axis.y + across * axis.x,           axis.x, axis.y,
          (most_along - least_along) / 2 + rounding, (most_across - least_across) / 2 + rounding};
}

Point farthest(std::span<const ChainTree::Edge> edges, const Chain& chain, Point from) {
  Point result = from;
  double most = 0;
  for_each_point(edges, chain, [&](const Point& p) {
    const double squared = (p.x - from.x) * (p.x - from.x) + (p.y - from.y) * (p.y - from.y);
    if (squared > most) most = squared, result = p;
  });
  return result;
}

/// The smaller of two boxes: upright, and along two points that are far from each other.
Box box(std::span<const ChainTree::Edge> edges, const Chain& chain) {
  const Box upright = box_along(edges, chain, {1, 0});
  const Point a = farthest(edges, chain, {edges[chain.begin].start_x, edges[chain.begin].start_y});
  const Point b = farthest(edges, chain, a);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length < 0x1p-40) return upright;
  const Box turned = box_along(edges, chain, {(b.x - a.x) / length, (b.y - a.y) / length});
  return turned.area() < upright.area() ? turned : upright;
}

ChainTree::Leaf leaf(std::span<const ChainTree::Edge> edges, std::size_t begin, std::size_t end) {
  ChainTree::Leaf leaf{};
  leaf.first_edge = static_cast<std::uint32_t>(begin);
  leaf.count = static_cast<std::uint32_t>(end - begin);
  for (std::size_t lane = 0; lane < ChainTree::kWidth; ++lane) {
    ChainTree::Edge edge = edges[std::min(begin + lane, end - 1)];
    if (begin + lane >= end) edge = {edge.end_x, edge.end_y, edge.end_x, edge.end_y, 1, 0, 0};
    leaf.start_x[lane] = edge.start_x, leaf.start_y[lane] = edge.start_y;
    leaf.end_x[lane] = edge.end_x, leaf.end_y[lane] = edge.end_y;
    leaf.direction_x[lane] = edge.direction_x, leaf.direction_y[lane] = edge.direction_y;
    leaf.length[lane] = edge.length;
  }
  return leaf;
}

Chain chain_of(const ChainTree::Leaf& leaf, std::size_t next_vertex, std::size_t index) {
  return {.begin = leaf.first_edge,
          .end = leaf.first_edge + leaf.count,
          .first_y = leaf.start_y[0],
          .last_y = leaf.end_y[leaf.count - 1],
          .first_vertex = leaf.first_edge,
          .last_vertex = static_cast<std::uint32_t>(next_vertex),
          .child = ~static_cast<std::int32_t>(index)};
}

Chain chain_of(std::span<const Chain> children, std::size_t index) {
  // Whole loops have no ends, and nothing leads from one to the next.
  const Chain &first = children.front(), &last = first.is_closed() ? first : children.back();
  return {.begin = first.begin,
          .end = children.back().end,
          .first_y = first.first_y,
          .last_y = last.last_y,
          .first_vertex = first.first_vertex,
          .last_vertex = last.last_vertex,
          .child = static_cast<std::int32_t>(index)};
}

ChainTree::Node node(std::span<const ChainTree::Edge> edges, std::span<const Chain> children) {
  ChainTree::Node node{};
  for (std::size_t i = 0; i < ChainTree::kWidth; ++i) {
    const bool here = i < children.size();
    const Chain chain = here ? children[i] : Chain{};
    const Box b = here ? box(edges, chain) : Box{};
    node.center_x[i] = b.center_x, node.center_y[i] = b.center_y;
    node.axis_x[i] = b.axis_x, node.axis_y[i] = b.axis_y;
    node.half_along[i] = b.half_along, node.half_across[i] = b.half_across;
    node.first_y[i] = chain.first_y, node.last_y[i] = chain.last_y;
    node.first_vertex[i] = chain.first_vertex, node.last_vertex[i] = chain.last_vertex;
    node.child[i] = chain.child;
  }
  return node;
}

/// Level by level, four chains to one, until one is left.
Chain joined(std::span<const ChainTree::Edge> edges, std::vector<Chain> level, std::vector<ChainTree::Node>& nodes) {
  while (level.size() > 1) {
    std::vector<Chain> above;
    for (std::size_t i = 0; i < level.size(); i += ChainTree::kWidth) {
      const std::span children(&level[i], std::min(ChainTree::kWidth, level.size() - i));
      nodes.push_back(node(edges, children));
      above.push_back(chain_of(children, nodes.size() - 1));
    }
    level = std::move(above);
  }
  return level.front();
}

}  // namespace

ChainTree::ChainTree(std::span<const Edge> edges, std::span<const std::size_t> loop_ends) {
  assert(edges.size() < std::size_t{1} << 31);
  std::vector<Chain> loops;
  std::size_t begin = 0;
  for (const std::size_t end : loop_ends) {
    std::vector<Chain> chains;
    for (std::size_t i = begin; i < end; i += kWidth) {
      const std::size_t stop = std::min(i + kWidth, end);
      leaves_.push_back(leaf(edges, i, stop));
      chains.push_back(chain_of(leaves_.back(), stop == end ? begin : stop, leaves_.size() - 1));
    }
    loops.push_back(joined(edges, std::move(chains), nodes_));
    begin = end;
  }
  const Chain all = joined(edges, std::move(loops), nodes_);
  root_ = all.child;
  if (root_ >= 0) return;
  nodes_.push_back(node(edges, std::span(&all, 1)));
  root_ = static_cast<std::int32_t>(nodes_.size() - 1);
}

}  // namespace touchstone::filtered
