// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/container/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh/box_tree.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/tree_walk.h"

/// The walk of many balls through a tree together: a node is fetched once for all balls that come to it, and none of
/// them waits for another.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The numbers of some balls of a crowd, ascending.
using BallNumbers = std::span<const std::uint32_t>;

/// A value for each ball, by number. Values that are made with kUnset are not set.
template <class T>
using PerBall = boost::container::vector<T>;
inline constexpr auto kUnset = boost::container::default_init;

/// The children of a node in the order in which a walk comes to them.
class ChildOrder {
 public:
  /// Takes some children, one per bit, as they are stored.
  explicit TOUCHSTONE_INLINE ChildOrder(unsigned lanes) {
    for (; lanes != 0; lanes &= lanes - 1) lane_[size_++] = static_cast<std::uint8_t>(__builtin_ctz(lanes));
  }
  /// Takes them by their keys, the least first.
  TOUCHSTONE_INLINE ChildOrder(unsigned lanes, const FloatPack& keys) {
    float key[BoxTree::kWidth];
    store(key, keys);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint8_t>(__builtin_ctz(lanes));
      std::size_t at = size_++;
      for (; at > 0 && key[lane] < key[lane_[at - 1]]; --at) lane_[at] = lane_[at - 1];
      lane_[at] = lane;
    }
  }

  [[nodiscard]] std::span<const std::uint8_t> lanes() const { return {lane_, size_}; }

 private:
  std::uint8_t lane_[BoxTree::kWidth];
  std::size_t size_ = 0;
};

/// Calls visit(leaf, balls) for each leaf that some of the balls come to. choose(boxes, ball) returns the children of a
/// node that a ball enters, one per bit; order(boxes, ball, lanes) returns the ChildOrder of these children, for the
/// first of the balls that enter the node: the others are near it. Calls prefetch_leaf(leaf) some time before it visits
/// the leaf. Requires different numbers.
template <class Choose, class Order, class Visit, class PrefetchLeaf>
void walk_together(const BoxTree& tree, BallNumbers balls, const Choose& choose, const Order& order, const Visit& visit,
                   const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty() || balls.empty()) return;
  struct Open {
    std::uint32_t node;
    std::size_t first, last;  ///< of its balls in `lists`
  };
  PerBall<std::uint32_t> lists(balls.begin(), balls.end()), here(balls.size(), kUnset), of_leaf(balls.size(), kUnset);
  PerBall<std::uint8_t> entered(balls.size(), kUnset);
  std::size_t count = balls.size();
  /// Writes the balls that enter a child, and returns how many. No branch depends on a ball.
  const auto write_balls_of = [&](unsigned child, std::uint32_t* to) {
    std::size_t written = 0;
    for (std::size_t i = 0; i < count; ++i) {
      to[written] = here[i];
      written += entered[i] >> child & 1U;
    }
    return written;
  };
  const BoxTree::Node* const nodes = tree.nodes().data();
  for (std::vector<Open> open{{0, 0, count}}; !open.empty();) {
    const Open now = open.back();
    open.pop_back();
    const BoxTree::Node& node = nodes[now.node];
    const NodeBoxes boxes(node);
    count = now.last - now.first;
    unsigned lanes = 0;
    for (std::size_t i = 0; i < count; ++i) {
      here[i] = lists[now.first + i];
      const unsigned chosen = choose(boxes, here[i]);
      entered[i] = static_cast<std::uint8_t>(chosen);
      lanes |= chosen;
    }
    if (lanes == 0) continue;
    const ChildOrder children = order(boxes, here[0], lanes);
    const auto is_leaf = [&node](unsigned lane) { return lane < node.leaf_count; };
    std::size_t node_count = 0;
    for (const unsigned lane : children.lanes()) {
      if (is_leaf(lane))
        prefetch_leaf(leaf_of(node, lane));
      else
        prefetch(nodes + node_of(node, lane), 1), ++node_count;
    }
    for (const unsigned lane : children.lanes())
      if (is_leaf(lane)) visit(leaf_of(node, lane), BallNumbers(of_leaf.data(), write_balls_of(lane, of_leaf.data())));
    // The lists of the children take the place of the node's. Each may write one number beyond its last.
    std::size_t last = now.first;
    const std::size_t most = last + count * node_count + 1;
    if (lists.size() < most) lists.resize(2 * most, kUnset);
    for (auto lane = children.lanes().rbegin(); lane != children.lanes().rend(); ++lane) {
      if (is_leaf(*lane)) continue;
      const std::size_t first = last;
      last += write_balls_of(*lane, lists.data() + first);
      open.push_back({node_of(node, *lane), first, last});
    }
  }
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
