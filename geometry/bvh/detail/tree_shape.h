// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bvh/box_tree.h"
#include "geometry/bvh/detail/float_box.h"

namespace touchstone::bvh {

/// The nodes of a tree, of which the first is the root, without their boxes, and its leaves by number.
struct TreeShape {
  std::vector<BoxTree::Node> nodes = std::vector<BoxTree::Node>(1);
  std::vector<Range> leaves;
};

/// Sorts the items into leaves, and returns these and the nodes above them; neither if there are no items. Requires
/// round to nearest, without flush-to-zero. Uses all cores.
///
/// A binary tree comes first, by the binned surface area heuristic [wald2007]. It is then collapsed to the wide nodes
/// that a walk is expected to pay least for [ylitie2017].
[[nodiscard]] TreeShape shape_of(std::vector<Item>& items);

}  // namespace touchstone::bvh
