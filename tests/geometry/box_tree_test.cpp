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

#include "tests/robust/support/draw_point.h"
#include "tests/robust/support/environment.h"

namespace touchstone::geometry_tests {
namespace {

using contact_tests::draw_point;
using workloads::Random;

/// Boxes of sizes and places that lie many powers of two apart, about any magnitude.
std::vector<Box> draw_boxes(std::uint64_t index, std::size_t count) {
  Random random(2026, index, 60);
  const auto magnitude = static_cast<int>(random.integer(-1070, 1015));
  const int spread = static_cast<int>(random.integer(0, 3)) * 20;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::ldexp(1.0, std::min(1015, magnitude + static_cast<int>(random.integer(-spread, spread))));
    const Eigen::Vector3d a = draw_point(random, size), b = a + draw_point(random, size) / 8;
    boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
  return boxes;
}

/// The place of a side of a box along an axis. It is a float, and so is what it is computed from.
double place(const BoxTree::Node& node, std::uint16_t steps, std::size_t axis) {
  const float side = node.origin[axis] + static_cast<float>(steps) * node.step();
  EXPECT_EQ(static_cast<double>(side),
            static_cast<double>(node.origin[axis]) + steps * static_cast<double>(node.step()));  // exact in doubles
  return side;
}

/// Is a box within a lane of a node? Lengths times the tree's scale are exact here, but where they are subnormal.
bool holds(const BoxTree& tree, const BoxTree::Node& node, std::size_t lane, const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double low = box.low[axis] * tree.scale()[0] * tree.scale()[1];
    const double high = box.high[axis] * tree.scale()[0] * tree.scale()[1];
    if (!(place(node, node.low[k][lane], k) <= low && high <= place(node, node.high[k][lane], k))) return false;
  }
  return true;
}

/// The numbers in a leaf. Its other places have none.
std::multiset<std::uint32_t> numbers_in(const BoxTree& tree, std::uint32_t leaf, std::size_t count) {
  std::multiset<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < BoxTree::kMostInLeaf; ++i) {
    const std::uint32_t number = tree.order()[leaf * BoxTree::kMostInLeaf + i];
    EXPECT_EQ(number == BoxTree::kNone, i >= count) << "leaf " << leaf << ", place " << i;
    if (i < count) numbers.insert(number);
  }
  return numbers;
}

/// Each leaf and each node but the root is a child of one node.
void expect_children_once(const BoxTree& tree) {
  std::multiset<std::uint32_t> leaves, nodes;
  for (const BoxTree::Node& node : tree.nodes()) {
    EXPECT_LE(node.child_count, BoxTree::kWidth);
    for (std::uint32_t lane = 0; lane < node.child_count; ++lane)
      if (lane < node.leaf_count)
        leaves.insert(node.first_leaf + lane);
      else
        nodes.insert(node.first_node + lane - node.leaf_count);
  }
  EXPECT_EQ(leaves.size(), tree.leaf_count());
  EXPECT_EQ(std::set<std::uint32_t>(leaves.begin(), leaves.end()).size(), tree.leaf_count());
  const std::size_t below_root = tree.nodes().empty() ? 0 : tree.nodes().size() - 1;
  EXPECT_EQ(nodes.size(), below_root);
  EXPECT_EQ(std::set<std::uint32_t>(nodes.begin(), nodes.end()).size(), below_root);
}

/// Checks the boxes of a node's lanes, adds the numbers below it, and lets `depth` grow to the deepest.
void check(const BoxTree& tree, const std::vector<Box>& boxes, std::size_t index, std::size_t level, std::size_t& depth,
           std::multiset<std::uint32_t>& found) {
  depth = std::max(depth, level);
  const BoxTree::Node& node = tree.nodes()[index];
  for (std::uint32_t lane = 0; lane < node.child_count; ++lane) {
    std::multiset<std::uint32_t> below;
    if (lane < node.leaf_count) {
      EXPECT_GT(node.count[lane], 0);
      below = numbers_in(tree, node.first_leaf + lane, node.count[lane]);
    } else {
      EXPECT_EQ(node.count[lane], 0);
      check(tree, boxes, node.first_node + lane - node.leaf_count, level + 1, depth, below);
    }
    for (const std::uint32_t number : below) EXPECT_TRUE(holds(tree, node, lane, boxes[number])) << "box " << number;
    found.insert(below.begin(), below.end());
  }
}

void expect_sound(const BoxTree& tree, const std::vector<Box>& boxes) {
  std::multiset<std::uint32_t> found;
  std::size_t depth = 0;
  if (!boxes.empty()) check(tree, boxes, 0, 0, depth, found);
  expect_children_once(tree);
  EXPECT_EQ(tree.size(), boxes.size());
  EXPECT_EQ(found.size(), boxes.size());
  EXPECT_EQ(std::set<std::uint32_t>(found.begin(), found.end()).size(), boxes.size());
  EXPECT_LE((BoxTree::kWidth - 1) * depth + 1, BoxTree::kStackSize);
}

TEST(BoxTree, HoldsEveryBoxOnceInAllNodesAboveIt) {
  for (std::uint64_t index = 0; index < 60; ++index) {
    const auto boxes = draw_boxes(index, index < 20 ? index : 1 << (index % 11));
    expect_sound(BoxTree(boxes), boxes);
  }
}

// A box is at most two steps of 1 / 2^15 of its node too large, or of a float's rounding.
TEST(BoxTree, RoundsBoxesLittle) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    Random random(2026, index, 62);
    const Eigen::Vector3d far = std::ldexp(1.0, static_cast<int>(random.integer(-20, 20))) * Eigen::Vector3d(1, -1, 1);
    std::vector<Box> boxes;
    for (int i = 0; i < 8; ++i) {  // all in one leaf
      const Eigen::Vector3d low = far + Eigen::Vector3d(random.unit(), random.unit(), random.unit());
      boxes.push_back({low, low + Eigen::Vector3d(random.unit(), random.unit(), random.unit())});
    }
    const BoxTree tree(boxes);
    Box around;
    for (const Box& box : boxes) around = around.joined(box);
    const BoxTree::Node& root = tree.nodes().front();
    const double unit = tree.scale()[0] * tree.scale()[1];
    const double allowed =
        2 * std::max((around.high - around.low).maxCoeff() * 0x1p-15, far.maxCoeff() * 0x1p-22) + 0x1p-22;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      EXPECT_GE(place(root, root.low[k][0], k) / unit, around.low[axis] - allowed);
      EXPECT_LE(place(root, root.high[k][0], k) / unit, around.high[axis] + allowed);
    }
  }
}

TEST(BoxTree, FillsItsNodes) {
  const BoxTree tree(draw_boxes(5, 60'000));
  double children = 0;
  for (const BoxTree::Node& node : tree.nodes()) children += node.child_count;
  EXPECT_GT(children, 5 * static_cast<double>(tree.nodes().size()));
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

/// The tree of these boxes, and after they have moved, is the same whatever state the caller and all cores are in.
void expect_same_everywhere(const std::vector<Box>& boxes, const std::vector<Box>& moved) {
  const BoxTree expected(boxes);
  BoxTree expected_moved = expected;
  expected_moved.refit(moved);
  for (const contact_tests::State& state : contact_tests::kStates) {
    const auto where = testing::Message() << boxes.size() << " boxes, " << state;
    std::optional<BoxTree> tree;
    std::thread([&] {
      const contact_tests::Environment changed(state);
      // The settings at a thread's first call of this kind are those of all cores in its later ones.
      tbb::parallel_for(0, 2, [](int) {});
      tree.emplace(boxes);
    }).join();
    expect_same(*tree, expected, where.GetString());
    {
      const contact_tests::Environment changed(state);
      tree->refit(moved);
    }
    expect_same(*tree, expected_moved, where.GetString());
  }
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
    expect_same_everywhere(boxes, moved);
  }
}

// Strips in a plane, which are best cut along their subnormal sides. They come in order, so that cores join boxes that
// differ.
TEST(BoxTree, IsTheSameWhereSubnormalSidesDecide) {
  constexpr std::size_t count = 60'000;
  Random random(2026, 0, 63);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 0x1p-170 * static_cast<double>(i) / static_cast<double>(count);
    const Eigen::Vector3d low{0.5 * random.unit(), y, 0};
    boxes.push_back({low, low + Eigen::Vector3d(0.5, 0x1p-180, 0)});
  }
  expect_same_everywhere(boxes, boxes);
}

TEST(BoxTree, IsTheSameForManyBoxesHoweverOftenItIsBuilt) {
  const auto boxes = draw_boxes(5, 60'000);
  const BoxTree first(boxes), second(boxes);
  EXPECT_EQ(first.order(), second.order());
  EXPECT_EQ(first.nodes().size(), second.nodes().size());
  expect_sound(first, boxes);
}

}  // namespace
}  // namespace touchstone::geometry_tests
