// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bvh/box_tree.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "experiments/workloads/random.h"
#include "tests/robust/support/environment.h"

namespace touchstone::scene_tests {
namespace {

using workloads::Random;

/// Boxes of sizes and places that lie many powers of two apart, about any magnitude.
std::vector<Box> draw_boxes(std::uint64_t index, std::size_t count) {
  Random random(2026, index, 60);
  const auto magnitude = static_cast<int>(random.integer(-1070, 1015));
  const int spread = static_cast<int>(random.integer(0, 3)) * 20;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::ldexp(1.0, std::min(1015, magnitude + static_cast<int>(random.integer(-spread, spread))));
    const auto point = [&] {
      return Eigen::Vector3d{size * (2 * random.unit() - 1), size * (2 * random.unit() - 1),
                             size * (2 * random.unit() - 1)};
    };
    const Eigen::Vector3d a = point(), b = a + point() / 8;
    boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
  return boxes;
}

/// Is a box within a lane of a node? Lengths times the tree's scale are exact here, but where they are subnormal.
bool holds(const BoxTree& tree, const BoxTree::Node& node, std::size_t lane, const Box& box) {
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k] * tree.scale()[0] * tree.scale()[1];
    const double high = box.high[k] * tree.scale()[0] * tree.scale()[1];
    if (!(static_cast<double>(node.low[k][lane]) <= low && high <= static_cast<double>(node.high[k][lane])))
      return false;
  }
  return true;
}

/// The leaves of all nodes, in order, have the numbers from 0 on.
void expect_numbered_leaves(const BoxTree& tree) {
  std::uint32_t leaves = 0;
  for (const BoxTree::Node& node : tree.nodes())
    for (unsigned lane = 0; lane < BoxTree::kWidth; ++lane) {
      EXPECT_EQ((node.leaves >> lane & 1) != 0, node.count[lane] != 0);
      if (node.count[lane] == 0) continue;
      EXPECT_EQ(node.leaf(lane), leaves++);
    }
  EXPECT_EQ(tree.leaf_count(), leaves);
}

/// Checks the boxes of a node's lanes, adds the numbers below it, and lets `depth` grow to the deepest.
void check(const BoxTree& tree, const std::vector<Box>& boxes, std::size_t index, std::size_t level, std::size_t& depth,
           std::multiset<std::uint32_t>& found) {
  depth = std::max(depth, level);
  const BoxTree::Node& node = tree.nodes()[index];
  for (std::size_t lane = 0; lane < BoxTree::kWidth; ++lane) {
    if (node.low[0][lane] > node.high[0][lane]) continue;
    std::multiset<std::uint32_t> below;
    if (node.count[lane] == 0)
      check(tree, boxes, node.child[lane], level + 1, depth, below);
    else
      for (std::uint32_t i = 0; i < node.count[lane]; ++i) below.insert(tree.order()[node.child[lane] + i]);
    EXPECT_LE(node.count[lane], BoxTree::kMostInLeaf);
    for (const std::uint32_t number : below) EXPECT_TRUE(holds(tree, node, lane, boxes[number])) << "box " << number;
    found.insert(below.begin(), below.end());
  }
}

void expect_sound(const BoxTree& tree, const std::vector<Box>& boxes) {
  std::multiset<std::uint32_t> found;
  std::size_t depth = 0;
  if (!boxes.empty()) check(tree, boxes, 0, 0, depth, found);
  expect_numbered_leaves(tree);
  EXPECT_EQ(found.size(), boxes.size());
  EXPECT_EQ(std::set<std::uint32_t>(found.begin(), found.end()).size(), boxes.size());
  EXPECT_LE(3 * depth + 1, BoxTree::kStackSize);
}

TEST(BoxTree, HoldsEveryBoxOnceInAllNodesAboveIt) {
  for (std::uint64_t index = 0; index < 60; ++index) {
    const auto boxes = draw_boxes(index, index < 20 ? index : 1 << (index % 11));
    expect_sound(BoxTree(boxes), boxes);
  }
}

TEST(BoxTree, HoldsThemAfterTheyHaveMoved) {
  for (std::uint64_t index = 0; index < 40; ++index) {
    const std::size_t count = index < 10 ? index : 300;
    BoxTree tree(draw_boxes(index, count));
    const auto moved = draw_boxes(1000 + index, count);
    tree.refit(moved);
    expect_sound(tree, moved);
  }
}

TEST(BoxTree, KnowsHowMuchItsBoxesHaveGrown) {
  const auto boxes = draw_boxes(3, 300);
  BoxTree tree(boxes);
  EXPECT_EQ(tree.growth(), 1);
  const auto scaled = [&](double factor) {
    auto result = boxes;
    for (Box& box : result) box = {factor * box.low, factor * box.high};
    return result;
  };
  tree.refit(scaled(0x1p-10));
  EXPECT_EQ(tree.growth(), 0x1p-20);
  tree.refit(scaled(3));
  EXPECT_NEAR(tree.growth(), 9, 1e-5);
  // What was in one leaf is in two places.
  auto apart = boxes;
  Box around;
  for (const Box& box : boxes) around = around.joined(box);
  const Eigen::Vector3d far(8 * (around.high - around.low).maxCoeff(), 0, 0);
  for (std::size_t i = 0; i < apart.size(); i += 2) apart[i] = {apart[i].low + far, apart[i].high + far};
  tree.refit(apart);
  EXPECT_GT(tree.growth(), 2);
  EXPECT_EQ(BoxTree(apart).growth(), 1);
  EXPECT_EQ(BoxTree({}).growth(), 1);
}

// Without a limit every level would peel a few boxes off.
TEST(BoxTree, StaysShallowWhereBoxesShrinkGeometrically) {
  std::vector<Box> boxes;
  for (int exponent = -1000; exponent <= 1000; ++exponent)
    for (int copy = 0; copy < 8; ++copy) {
      const double size = std::ldexp(1.0 + copy, exponent);
      boxes.push_back({Eigen::Vector3d(size, size / 2, 0), Eigen::Vector3d(2 * size, size, size)});
    }
  expect_sound(BoxTree(boxes), boxes);
}

void expect_same(const BoxTree& tree, const BoxTree& expected, const std::string& where) {
  EXPECT_EQ(tree.order(), expected.order()) << where;
  ASSERT_EQ(tree.nodes().size(), expected.nodes().size()) << where;
  EXPECT_EQ(std::memcmp(tree.nodes().data(), expected.nodes().data(), tree.nodes().size() * sizeof(BoxTree::Node)), 0)
      << where;
  EXPECT_EQ(tree.growth(), expected.growth()) << where;
}

// Beside boxes of size 1, which stand about 2^40 in the tree, those of 2^-170 are subnormal floats, which a machine
// that flushes them takes for nothing.
TEST(BoxTree, IsTheSameInEveryFloatingPointEnvironment) {
  for (const std::size_t count : {20U, 30'000U}) {  // the second is built by all cores
    Random random(2026, count, 61);
    std::vector<Box> boxes, moved;
    for (std::size_t i = 0; i < count; ++i) {
      const double size = i % 3 == 0 ? 1 : 0x1p-170;
      const Eigen::Vector3d low{size * random.unit(), size * random.unit(), -size * random.unit()};
      boxes.push_back({low, low + Eigen::Vector3d::Constant(size / 64)});
      moved.push_back({-boxes.back().high, -boxes.back().low});
    }
    const BoxTree expected(boxes);
    BoxTree expected_moved = expected;
    expected_moved.refit(moved);
    for (const int mode : contact_tests::kModes)
      for (const unsigned flush : contact_tests::kFlushes) {
        const std::string where =
            std::to_string(count) + " boxes, mode " + std::to_string(mode) + ", flush " + std::to_string(flush);
        std::optional<BoxTree> tree;
        std::thread([&] {
          const contact_tests::Environment changed(mode, flush);
          // The settings at a thread's first call of this kind are those of all cores in its later ones.
          tbb::parallel_for(0, 2, [](int) {});
          tree.emplace(boxes);
        }).join();
        expect_same(*tree, expected, where);
        {
          const contact_tests::Environment changed(mode, flush);
          tree->refit(moved);
        }
        expect_same(*tree, expected_moved, where);
      }
  }
}

TEST(BoxTree, IsTheSameForManyBoxesHoweverOftenItIsBuilt) {
  const auto boxes = draw_boxes(5, 60'000);
  const BoxTree first(boxes), second(boxes);
  EXPECT_EQ(first.order(), second.order());
  EXPECT_EQ(first.nodes().size(), second.nodes().size());
  expect_sound(first, boxes);
}

}  // namespace
}  // namespace touchstone::scene_tests
