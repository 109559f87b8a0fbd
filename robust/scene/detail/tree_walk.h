// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/bvh/box_tree.h"
#include "robust/filtered/detail/numbers/pack.h"

/// The walk through a tree to the faces that something may touch.
namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

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

TOUCHSTONE_INLINE Leaf leaf_of(const BoxTree::Node& node, unsigned lane) {
  return {node.leaf(lane), node.child[lane], node.count[lane]};
}

/// Calls visit(leaf) for each leaf that `culling` may touch. Stops if it returns true, and returns whether it did.
/// Calls prefetch_leaf(leaf) some time before it visits the leaf.
///
/// `culling` is a CullingBall or a CullingMotion. `may_touch(node, keys)` returns the bits of the boxes that it may
/// touch.
template <class Culling, class Visit, class PrefetchLeaf>
bool walk(const BoxTree& tree, const Culling& culling, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return false;
  const BoxTree::Node* const nodes = tree.nodes().data();
  std::uint32_t stack[BoxTree::kStackSize];
  std::size_t open = 0;
  for (std::uint32_t number = 0;;) {
    const BoxTree::Node& node = nodes[number];
    filtered::Pack keys;
    const unsigned candidates = culling.may_touch(node, keys), leaves = candidates & node.leaves;
    for (unsigned rest = leaves; rest != 0; rest &= rest - 1)
      prefetch_leaf(leaf_of(node, static_cast<unsigned>(__builtin_ctz(rest))));
    const unsigned below = candidates ^ leaves;
    for (unsigned rest = below; rest != 0; rest &= rest - 1) {
      number = node.child[__builtin_ctz(rest)];
      prefetch(nodes + number, 1);
      stack[open++] = number;
    }
    for (unsigned rest = leaves; rest != 0; rest &= rest - 1)
      if (visit(leaf_of(node, static_cast<unsigned>(__builtin_ctz(rest))))) return true;
    if (open == 0) return false;
    if (below == 0) number = stack[open - 1];
    --open;
  }
}

/// The same, but enters the first of the boxes found so far first; visit may shrink `culling`.
///
/// `may_touch(node, keys)` also writes numbers by which boxes are ordered; `may_touch(key)` returns whether `culling`
/// still may touch such a box.
template <class Culling, class Visit, class PrefetchLeaf>
void walk_in_order(const BoxTree& tree, const Culling& culling, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return;
  const BoxTree::Node* const nodes = tree.nodes().data();
  /// Boxes that are open, the first on top: the number of a node times kLanes, plus the lane; and the key.
  std::uint64_t box[BoxTree::kStackSize];
  double key[BoxTree::kStackSize];
  std::size_t open = 0;
  for (std::uint64_t number = 0;;) {
    const BoxTree::Node& node = nodes[number];
    filtered::Pack keys;
    unsigned candidates = culling.may_touch(node, keys);
    double lane_key[filtered::kLanes];
    store(lane_key, keys);
    const std::size_t bottom = open;
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(candidates));
      if ((node.leaves >> lane & 1) == 0)
        prefetch(nodes + node.child[lane], 1);
      else
        prefetch_leaf(leaf_of(node, lane));
      std::size_t at = open++;
      const double here = lane_key[lane];
      for (; at > bottom && key[at - 1] < here; --at) key[at] = key[at - 1], box[at] = box[at - 1];
      key[at] = here, box[at] = number * filtered::kLanes + lane;
    }
    for (;;) {
      if (open == 0) return;
      --open;
      if (!culling.may_touch(key[open])) continue;
      const BoxTree::Node& parent = nodes[box[open] / filtered::kLanes];
      const auto lane = static_cast<unsigned>(box[open] % filtered::kLanes);
      if ((parent.leaves >> lane & 1) == 0) {
        number = parent.child[lane];
        break;
      }
      visit(leaf_of(parent, lane));
    }
  }
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
