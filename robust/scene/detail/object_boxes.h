// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/bvh/box.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/pose.h"

/// The boxes of a scene's objects, which tell what objects a question is about.
namespace touchstone::scene::detail {

/// Returns a box that contains the ball. Its sides may be infinite. Requires round to nearest, without flush-to-zero.
[[nodiscard]] Box box_around(const Ball& ball);

/// Tells which boxes a ball may touch, and perhaps others. Requires round to nearest, without flush-to-zero.
class BoxesInReach {
 public:
  explicit BoxesInReach(const Ball& ball);

  [[nodiscard]] bool has(const Box& box) const { return meet(box, around_) && !(squared_distance(box) > squared_); }

 private:
  [[nodiscard]] double squared_distance(const Box& box) const;

  Box around_;
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  double squared_ = std::numeric_limits<double>::infinity();  ///< the limit for the squares of distances
};

/// Returns a box that contains every point of this one under the pose, each coordinate rounded once to the nearest
/// double. An empty box stays empty.
///
/// A coordinate of R p + t is largest at one of the corners, and rounding is monotone. So no margin is needed.
[[nodiscard]] Box posed(const Pose& pose, const Box& box);

/// Boxes by number, in a binary tree. A node has the boxes of its two children. Each is exactly that of all below it,
/// so that no rounding hides one. The heights of two children differ by at most one, as in trees of Adelson-Velsky and
/// Landis.
class ObjectBoxes {
 public:
  using Numbers = boost::container::small_vector<std::uint32_t, 32>;
  /// A box that a moving ball may touch.
  struct OnWay {
    std::uint32_t number;
    double earliest;  ///< a time that is not later than the one at which the ball touches the box first
  };

  /// Sets the box of a number below 2^31; removes it if the box is empty. Cost: logarithmic, unless many boxes overlap.
  void set(std::uint32_t number, const Box& box);

  /// Returns how many nodes are between the root and the farthest box.
  [[nodiscard]] int height() const { return height(nodes_[kAbove].child[0]); }
  /// Returns the numbers of these boxes, ascending. Cost: logarithmic for each, unless many boxes overlap.
  [[nodiscard]] Numbers in_reach(const BoxesInReach& boxes) const;
  /// Returns all boxes that the moving ball may touch, and perhaps others, in the order of their times. Cost: likewise.
  /// Requires round to nearest, without flush-to-zero.
  [[nodiscard]] boost::container::small_vector<OnWay, 32> on_way(const Motion& motion) const;
  /// Returns a number whose box is nearest to the point, as far as rounded distances tell, of those that `wanted`
  /// wants; nothing if it wants none.
  template <class Wanted>
  [[nodiscard]] std::optional<std::uint32_t> nearest(const Eigen::Vector3d& point, const Wanted& wanted) const {
    std::optional<std::uint32_t> best;
    double least = std::numeric_limits<double>::infinity();
    struct Ahead {
      std::uint32_t child;
      double distance;
    };
    boost::container::small_vector<Ahead, 64> stack;
    if (nodes_[kAbove].child[0] != kNone) stack.push_back({nodes_[kAbove].child[0], 0});
    while (!stack.empty()) {
      const auto [child, distance] = stack.back();
      stack.pop_back();
      if (best && !(distance < least)) continue;
      if (is_leaf(child)) {
        if (wanted(child - kLeaf)) best = child - kLeaf, least = distance;
        continue;
      }
      const Node& node = nodes_[child];
      const Ahead ahead[] = {{node.child[0], squared_distance(node.box[0], point)},
                             {node.child[1], squared_distance(node.box[1], point)}};
      const int nearer = ahead[1].distance < ahead[0].distance ? 1 : 0;
      stack.push_back(ahead[1 - nearer]);
      stack.push_back(ahead[nearer]);
    }
    return best;
  }

 private:
  /// A child is a node, or from kLeaf on a number. Its slot, in the node above, is twice that node, or one more.
  static constexpr std::uint32_t kLeaf = 1U << 31, kNone = kLeaf - 1;
  static constexpr std::uint32_t kAbove = 0;  ///< the node whose first child is the root

  struct Node {
    Box box[2];
    std::uint32_t child[2]{kNone, kNone};
    std::uint32_t slot = kNone;  ///< of this node; of a free one the next free node
    int height = 0;
  };

  static bool is_leaf(std::uint32_t child) { return child >= kLeaf; }
  /// The square of a distance; rounded, or infinite.
  static double squared_distance(const Box& box, const Eigen::Vector3d& point);

  [[nodiscard]] int height(std::uint32_t child) const {
    return is_leaf(child) || child == kNone ? 0 : nodes_[child].height;
  }
  [[nodiscard]] std::uint32_t child_in(std::uint32_t slot) const { return nodes_[slot / 2].child[slot % 2]; }
  [[nodiscard]] const Box& box_in(std::uint32_t slot) const { return nodes_[slot / 2].box[slot % 2]; }
  void put(std::uint32_t child, const Box& box, std::uint32_t slot);
  [[nodiscard]] std::uint32_t new_node();
  /// Puts a box beside that in a slot. Cannot fail after a box has been removed.
  void insert(std::uint32_t number, const Box& box, std::uint32_t slot);
  void remove(std::uint32_t slot);
  /// Returns the slot in which a node for its child and this box makes the boxes of all nodes least in total.
  [[nodiscard]] std::uint32_t best_slot(const Box& box) const;
  /// Updates the heights and boxes of a node and of all above it, and balances them.
  void update_from(std::uint32_t node);
  /// Turns a node whose children differ in height by two or more, so that it goes down a step.
  void turn(std::uint32_t node);

  std::vector<Node> nodes_{Node()};
  std::vector<std::uint32_t> slots_;  ///< by number; kNone where there is no box
  std::uint32_t free_ = kNone;
};

}  // namespace touchstone::scene::detail
