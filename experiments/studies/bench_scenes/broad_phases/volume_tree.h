// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "experiments/studies/bench_scenes/broad_phases/broad_phase.h"

namespace touchstone::bench_scenes {

/// A binary tree of bounding volumes, halved at the median along the longest side. A volume has a constructor of
/// triangles and their numbers, a type `Query` that is built of a ball, and a member `meets(query)`, which is true if
/// the ball touches one of these triangles.
template <class Volume>
class VolumeTree {
 public:
  explicit VolumeTree(std::span<const Triangle> triangles) : numbers_(triangles.size()) {
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    if (!triangles.empty()) build(triangles, 0, static_cast<std::uint32_t>(triangles.size()));
  }

  template <class Test>
  void find(const Ball& ball, const Test& test) const {
    if (!nodes_.empty()) find(typename Volume::Query(ball), test, 0);
  }

 private:
  static constexpr std::uint32_t kMostInLeaf = 2;
  struct Node {
    Volume volume;
    std::uint32_t begin, end, right;  // the left child is the next node; right is 0 for a leaf
  };

  std::uint32_t build(std::span<const Triangle> triangles, std::uint32_t begin, std::uint32_t end) {
    const std::span<std::uint32_t> own(numbers_.data() + begin, end - begin);
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({Volume(triangles, own), begin, end, 0});
    if (end - begin <= kMostInLeaf) return number;
    Box centers;
    const auto middle_of = [&](std::uint32_t i) -> Eigen::Vector3d {
      const Box its = box(triangles[i]);
      return its.low / 2 + its.high / 2;
    };
    for (const std::uint32_t i : own) centers = centers.joined({middle_of(i), middle_of(i)});
    Eigen::Index axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    const std::uint32_t half = (end - begin) / 2;
    std::ranges::nth_element(own, own.begin() + half, {}, [&](std::uint32_t i) { return middle_of(i)[axis]; });
    build(triangles, begin, begin + half);
    nodes_[number].right = build(triangles, begin + half, end);
    return number;
  }

  template <class Test>
  bool find(const typename Volume::Query& query, const Test& test, std::uint32_t number) const {
    const Node& node = nodes_[number];
    if (!node.volume.meets(query)) return false;
    if (node.right != 0) return find(query, test, number + 1) || find(query, test, node.right);
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (test(numbers_[i])) return true;
    return false;
  }

  std::vector<std::uint32_t> numbers_;
  std::vector<Node> nodes_;
};

}  // namespace touchstone::bench_scenes
