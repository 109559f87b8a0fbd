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

/// Calls visit(place) for each place in tree.order() whose leaf `culling` may touch. Stops if it returns true, and
/// returns whether it did. If `in_order`, the first of the boxes found so far is entered first, and visit may shrink
/// `culling`. Calls prefetch_leaf(first, count) some time before it visits these places.
///
/// `culling` is a CullingBall or a CullingMotion. `may_touch(node, keys)` returns the bits of the boxes that it may
/// touch and writes numbers by which they are ordered; `may_touch(key)` returns whether it still may touch such a box.
template <bool in_order, class Culling, class Visit, class PrefetchLeaf>
bool walk(const BoxTree& tree, const Culling& culling, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return false;
  /// A node, or `count` places from `first`.
  struct Open {
    std::uint32_t first, count;
    double key;  ///< only if `in_order`
  };
  Open stack[BoxTree::kStackSize];
  std::size_t open = 0;
  stack[open++] = {0, 0, 0};
  while (open > 0) {
    const Open top = stack[--open];
    if constexpr (in_order)
      if (!culling.may_touch(top.key)) continue;
    if (top.count != 0) {
      for (std::uint32_t place = top.first; place < top.first + top.count; ++place)
        if (visit(place)) return true;
      continue;
    }
    const BoxTree::Node& node = tree.nodes()[top.first];
    filtered::Pack keys;
    unsigned candidates = culling.may_touch(node, keys);
    double key[filtered::kLanes];
    if constexpr (in_order) store(key, keys);
    const std::size_t bottom = open;
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(candidates));
      const Open next{node.child[lane], node.count[lane], in_order ? key[lane] : 0};
      if (next.count == 0)
        prefetch(&tree.nodes()[next.first], 1);
      else
        prefetch_leaf(next.first, next.count);
      std::size_t at = open++;
      if constexpr (in_order)
        for (; at > bottom && stack[at - 1].key < next.key; --at) stack[at] = stack[at - 1];
      stack[at] = next;
    }
  }
  return false;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
