// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh/box_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "geometry/bvh/detail/tree_shape.h"
#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"

namespace touchstone {
namespace {

using bvh::Bounds;
using bvh::Item;
using bvh::kInfinity;
using bvh::Range;
using bvh::TreeShape;
using Node = BoxTree::Node;

float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x ? std::nextafter(nearest, -kInfinity) : nearest;
}
float rounded_up(double x) { return -rounded_down(-x); }

/// Returns powers of two that scale the largest coordinate to between 2^39 and 2^40, so that a surface times a count is
/// within the floats.
BoxTree::Scale scale_of(std::span<const Box> boxes) {
  double largest = std::numeric_limits<double>::denorm_min();
  for (const Box& box : boxes)
    largest = std::max({largest, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
  assert(std::isfinite(largest));
  const int exponent = 39 - std::ilogb(largest), half = exponent / 2;
  return {std::ldexp(1.0, half), std::ldexp(1.0, exponent - half)};
}

Bounds bounds(const Box& box, const BoxTree::Scale& scale) {
  Bounds result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    result.low[k] = rounded_down(box.low[axis] * scale[0] * scale[1]);
    result.high[k] = rounded_up(box.high[axis] * scale[0] * scale[1]);
  }
  return result;
}

/// Returns the exponent of the smallest step by which the sides of a box are less than 2^23.
int least_exponent(const Bounds& box) {
  float largest = 0;
  for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  constexpr int kBits = 23, kSmallest = std::numeric_limits<float>::min_exponent - 1;
  return largest == 0 ? kSmallest : std::max(kSmallest, std::ilogb(largest) + 1 - kBits);
}

/// Sets the boxes of a node's children, which are not empty.
void set_boxes(Node& node, std::span<const Bounds> children) {
  constexpr int kMostSteps = std::numeric_limits<std::uint16_t>::max();
  constexpr int kBias = std::numeric_limits<float>::max_exponent - 1;
  Bounds around;
  for (const Bounds& child : children) around.join(child);
  int exponent = least_exponent(around);
  const auto first_step = [&](float low) { return std::floor(std::ldexp(static_cast<double>(low), -exponent)); };
  const auto last_step = [&](float high) { return std::ceil(std::ldexp(static_cast<double>(high), -exponent)); };
  for (int axis = 0; axis < 3; ++axis)
    while (last_step(around.high[axis]) - first_step(around.low[axis]) > kMostSteps) ++exponent;
  node.exponent = static_cast<std::uint8_t>(exponent + kBias);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = first_step(around.low[axis]);
    node.origin[axis] = static_cast<float>(std::ldexp(origin, exponent));
    for (std::size_t lane = 0; lane < children.size(); ++lane) {
      node.low[axis][lane] = static_cast<std::uint16_t>(first_step(children[lane].low[axis]) - origin);
      node.high[axis][lane] = static_cast<std::uint16_t>(last_step(children[lane].high[axis]) - origin);
    }
  }
}

/// Sets the boxes of all nodes to those that contain their leaves. Returns half the sum of their surfaces.
double fit(std::vector<Node>& nodes, std::span<const Bounds> leaves) {
  std::vector<Bounds> around(nodes.size());
  double surface = 0;
  for (std::size_t i = nodes.size(); i-- > 0;) {  // children come after their parents
    Node& node = nodes[i];
    Bounds children[BoxTree::kWidth];
    for (std::size_t lane = 0; lane < node.child_count; ++lane) {
      children[lane] =
          lane < node.leaf_count ? leaves[node.first_leaf + lane] : around[node.first_node + (lane - node.leaf_count)];
      around[i].join(children[lane]);
      surface += static_cast<double>(children[lane].surface());
    }
    set_boxes(node, std::span(children).first(node.child_count));
  }
  return surface;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) : size_(boxes.size()) {
  const FloatingPointState nearest;
  assert(boxes.size() <= kMostBoxes);
  scale_ = scale_of(boxes);
  std::vector<Item> items(boxes.size());
  each_in_parallel(boxes.size(), 4096,
                   [&](std::size_t i) { items[i] = Item(bounds(boxes[i], scale_), static_cast<std::uint32_t>(i)); });
  TreeShape tree = shape_of(items);
  nodes_ = std::move(tree.nodes);
  leaf_count_ = static_cast<std::uint32_t>(tree.leaves.size());
  order_.assign(std::size_t{kMostInLeaf} * leaf_count_, kNone);
  std::vector<Bounds> leaves(leaf_count_);
  each_in_parallel(leaf_count_, 4096, [&](std::size_t i) {
    const Range& leaf = tree.leaves[i];
    leaves[i] = leaf.bounds;
    for (std::uint32_t j = 0; j < leaf.size(); ++j) order_[i * kMostInLeaf + j] = items[leaf.begin + j].number();
  });
  surface_ = fit(nodes_, leaves);
  built_surface_ = surface_, built_scale_ = scale_;
}

void BoxTree::refit(std::span<const Box> boxes) {
  const FloatingPointState nearest;
  assert(boxes.size() == size_);
  scale_ = scale_of(boxes);
  std::vector<Bounds> leaves(leaf_count_);
  each_in_parallel(leaf_count_, 4096, [&](std::size_t i) {
    for (std::uint32_t j = 0; j < kMostInLeaf; ++j)
      if (const std::uint32_t number = order_[i * kMostInLeaf + j]; number != kNone)
        leaves[i].join(bounds(boxes[number], scale_));
  });
  surface_ = fit(nodes_, leaves);
}

double BoxTree::growth() const {
  const FloatingPointState nearest;
  const double length = (built_scale_[0] / scale_[0]) * (built_scale_[1] / scale_[1]);
  return pinned(surface_ == 0 ? 1 : surface_ * length * length / built_surface_);
}

}  // namespace touchstone
