// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/bvh/box_tree.h"
#include "robust/filtered/detail/numbers/lanes.h"

/// The walk through a tree to the faces that something may touch.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Fetches the bytes of objects from memory, for when the walk comes to them.
template <class Object>
TOUCHSTONE_INLINE void prefetch(const Object* objects, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto* bytes = reinterpret_cast<const char*>(objects);
  for (std::size_t at = 0; at < count * sizeof(Object); at += line) __builtin_prefetch(bytes + at);
}

/// A leaf of a tree: its number, and its places in tree.order().
struct Leaf {
  std::uint32_t number, first, count;
};

/// Returns the leaf that is a child of a node.
TOUCHSTONE_INLINE Leaf leaf_of(const BoxTree::Node& node, unsigned lane) {
  const std::uint32_t number = node.first_leaf + lane;
  return {number, number * BoxTree::kMostInLeaf, node.count[lane]};
}

/// Returns the number of the node that is a child of a node.
TOUCHSTONE_INLINE std::uint32_t node_of(const BoxTree::Node& node, unsigned lane) {
  return node.first_node + (lane - node.leaf_count);
}

/// Leaves that a walk has found and not visited yet.
template <std::size_t kMost>
class FoundLeaves {
 public:
  [[nodiscard]] std::span<const Leaf> all() const { return {leaves_, size_}; }
  [[nodiscard]] std::size_t size() const { return size_; }
  TOUCHSTONE_INLINE void add(const Leaf& leaf) { leaves_[size_++] = leaf; }
  void clear() { size_ = 0; }

 private:
  Leaf leaves_[kMost];
  std::size_t size_ = 0;
};

/// Calls visit(leaves) for all leaves that `culling` may touch, each time that kEnough of them or more are found, and
/// at the end. Stops if it returns true, and returns whether it did. Calls prefetch_leaf(leaf) some time before it
/// visits the leaf.
///
/// `culling` is a CullingBall or a CullingMotion. A search for any leaf needs one; where all count, the processor
/// overlaps the work of several.
template <std::size_t kEnough, class Culling, class Visit, class PrefetchLeaf>
bool walk(const BoxTree& tree, const Culling& culling, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return false;
  const BoxTree::Node* const nodes = tree.nodes().data();
  std::uint32_t stack[BoxTree::kStackSize];
  FoundLeaves<kEnough - 1 + BoxTree::kWidth> leaves;
  std::size_t open = 0;
  for (std::uint32_t number = 0;;) {
    const BoxTree::Node& node = nodes[number];
    const unsigned candidates = culling.may_touch(node), leaf_lanes = candidates & ((1U << node.leaf_count) - 1);
    for (unsigned rest = leaf_lanes; rest != 0; rest &= rest - 1) {
      const Leaf leaf = leaf_of(node, static_cast<unsigned>(__builtin_ctz(rest)));
      prefetch_leaf(leaf);
      leaves.add(leaf);
    }
    for (unsigned rest = candidates ^ leaf_lanes; rest != 0; rest &= rest - 1) {
      number = node_of(node, static_cast<unsigned>(__builtin_ctz(rest)));
      prefetch(nodes + number, 1);
      stack[open++] = number;
    }
    if (open == 0 || leaves.size() >= kEnough) {
      if (visit(leaves.all())) return true;
      leaves.clear();
      if (open == 0) return false;
    }
    number = stack[--open];
  }
}

/// Calls visit(leaves) for the leaf whose key is least, and then for those others that `culling` still may touch.
template <class Culling, class Visit, class PrefetchLeaf>
TOUCHSTONE_INLINE void visit_nearest_first(const BoxTree::Node& node, unsigned lanes,
                                           const double (&keys)[BoxTree::kWidth], const Culling& culling,
                                           const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  auto first = static_cast<unsigned>(__builtin_ctz(lanes));
  prefetch_leaf(leaf_of(node, first));
  for (unsigned rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(rest));
    prefetch_leaf(leaf_of(node, lane));
    first = keys[lane] < keys[first] ? lane : first;
  }
  FoundLeaves<BoxTree::kWidth> leaves;
  leaves.add(leaf_of(node, first));
  visit(leaves.all());
  leaves.clear();
  for (unsigned rest = lanes ^ 1U << first; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(rest));
    if (culling.may_touch(keys[lane])) leaves.add(leaf_of(node, lane));
  }
  if (leaves.size() != 0) visit(leaves.all());
}

/// The same as `walk` for a search that shrinks `culling` as it visits leaves: enters the node first whose key is
/// least.
///
/// `may_touch(node, keys)` writes the keys of boxes; `may_touch(key)` returns whether `culling` still may touch such a
/// box.
template <class Culling, class Visit, class PrefetchLeaf>
void walk_in_order(const BoxTree& tree, const Culling& culling, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return;
  const BoxTree::Node* const nodes = tree.nodes().data();
  std::uint32_t stack[BoxTree::kStackSize];
  double key[BoxTree::kStackSize];
  std::size_t open = 0;
  for (std::uint32_t number = 0;;) {
    const BoxTree::Node& node = nodes[number];
    double lane_key[BoxTree::kWidth];
    const unsigned candidates = culling.may_touch(node, lane_key);
    const unsigned leaf_lanes = candidates & ((1U << node.leaf_count) - 1);
    for (unsigned rest = candidates ^ leaf_lanes; rest != 0; rest &= rest - 1)
      prefetch(nodes + node_of(node, static_cast<unsigned>(__builtin_ctz(rest))), 1);
    if (leaf_lanes != 0) visit_nearest_first(node, leaf_lanes, lane_key, culling, visit, prefetch_leaf);
    const std::size_t bottom = open;
    for (unsigned rest = candidates ^ leaf_lanes; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(rest));
      const double here = lane_key[lane];
      std::size_t at = open++;
      for (; at > bottom && key[at - 1] < here; --at) key[at] = key[at - 1], stack[at] = stack[at - 1];
      key[at] = here, stack[at] = node_of(node, lane);
    }
    do {
      if (open == 0) return;
    } while (!culling.may_touch(key[--open]));
    number = stack[open];
  }
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
