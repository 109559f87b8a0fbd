// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/chain_tree.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace touchstone::filtered {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a node keeps of a child.
struct Chain {
  double min_x = infinity, max_x = -infinity, min_y = infinity, max_y = -infinity;
  double first_y = 0, last_y = 0;
  std::uint32_t first_vertex = 0, last_vertex = 0;
  std::int32_t child = 0;
};

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
  const std::size_t last = leaf.count - 1;
  Chain chain{.first_y = leaf.start_y[0],
              .last_y = leaf.end_y[last],
              .first_vertex = leaf.first_edge,
              .last_vertex = static_cast<std::uint32_t>(next_vertex),
              .child = ~static_cast<std::int32_t>(index)};
  for (std::size_t lane = 0; lane <= last; ++lane) {
    chain.min_x = std::min({chain.min_x, leaf.start_x[lane], leaf.end_x[lane]});
    chain.max_x = std::max({chain.max_x, leaf.start_x[lane], leaf.end_x[lane]});
    chain.min_y = std::min({chain.min_y, leaf.start_y[lane], leaf.end_y[lane]});
    chain.max_y = std::max({chain.max_y, leaf.start_y[lane], leaf.end_y[lane]});
  }
  return chain;
}

ChainTree::Node node(std::span<const Chain> children) {
  ChainTree::Node node{};
  for (std::size_t i = 0; i < ChainTree::kWidth; ++i) {
    const Chain chain = i < children.size() ? children[i] : Chain{};
    node.min_x[i] = chain.min_x, node.max_x[i] = chain.max_x;
    node.min_y[i] = chain.min_y, node.max_y[i] = chain.max_y;
    node.first_y[i] = chain.first_y, node.last_y[i] = chain.last_y;
    node.first_vertex[i] = chain.first_vertex, node.last_vertex[i] = chain.last_vertex;
    node.child[i] = chain.child;
  }
  return node;
}

Chain chain_of(std::span<const Chain> children, std::size_t index) {
  Chain chain = children.front();
  chain.last_y = children.back().last_y;
  chain.last_vertex = children.back().last_vertex;
  chain.child = static_cast<std::int32_t>(index);
  for (const Chain& child : children) {
    chain.min_x = std::min(chain.min_x, child.min_x);
    chain.max_x = std::max(chain.max_x, child.max_x);
    chain.min_y = std::min(chain.min_y, child.min_y);
    chain.max_y = std::max(chain.max_y, child.max_y);
  }
  return chain;
}

/// Level by level, four chains to one, until one is left.
Chain joined(std::vector<Chain> level, std::vector<ChainTree::Node>& nodes) {
  while (level.size() > 1) {
    std::vector<Chain> above;
    for (std::size_t i = 0; i < level.size(); i += ChainTree::kWidth) {
      const std::span children(&level[i], std::min(ChainTree::kWidth, level.size() - i));
      nodes.push_back(node(children));
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
    Chain loop = joined(std::move(chains), nodes_);
    // A closed chain has no ends: whatever is said of them, they are one point.
    loop.last_y = loop.first_y;
    loop.last_vertex = loop.first_vertex;
    loops.push_back(loop);
    begin = end;
  }
  // Above the loops a node's first and last children may be different loops; nothing is crossed between them.
  while (loops.size() > 1) {
    std::vector<Chain> above;
    for (std::size_t i = 0; i < loops.size(); i += kWidth) {
      const std::span children(&loops[i], std::min(kWidth, loops.size() - i));
      nodes_.push_back(node(children));
      Chain group = chain_of(children, nodes_.size() - 1);
      group.last_y = group.first_y;
      group.last_vertex = group.first_vertex;
      above.push_back(group);
    }
    loops = std::move(above);
  }
  root_ = loops.front().child;
  if (root_ >= 0) return;
  nodes_.push_back(node(std::span(loops)));
  root_ = static_cast<std::int32_t>(nodes_.size() - 1);
}

}  // namespace touchstone::filtered
