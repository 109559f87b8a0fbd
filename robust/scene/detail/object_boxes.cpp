// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/object_boxes.h"

#include <algorithm>
#include <cmath>

#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/posing.h"

namespace touchstone::scene::detail {
namespace {

/// How likely it is that a question comes to a box. The square of this would be nearer to its surface, but it
/// underflows and overflows, and is not better.
double size(const Box& box) { return (box.high - box.low).sum(); }

}  // namespace

// A sum that is rounded to nearest is within one double of the exact one.
Box box_around(const Ball& ball) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::nextafter(ball.center[axis] - ball.radius, -HUGE_VAL);
    box.high[axis] = std::nextafter(ball.center[axis] + ball.radius, HUGE_VAL);
  }
  return box;
}

// Limits and margins are those with which CullingBall tests in doubles.
BoxesInReach::BoxesInReach(const Ball& ball) : around_(box_around(ball)), center_(ball.center) {
  const double reach = ball.radius + culling::kTiny;
  if (center_.lpNorm<Eigen::Infinity>() < 0x1p500 && reach < 0x1p500)
    squared_ = culling::squared_reach(reach, culling::kWide);
}

double BoxesInReach::squared_distance(const Box& box) const {
  const auto gap = [&](int axis) {
    return culling::gap(box.low[axis], box.high[axis], center_[axis], center_[axis], 0.0);
  };
  return culling::squared_distance(gap(0), gap(1), gap(2));
}

Box posed(const Pose& pose, const Box& box) {
  if (box.empty()) return box;
  Box result;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d low, high;
    for (int i = 0; i < 3; ++i) {
      const bool falls = pose.rotation(axis, i) < 0;
      low[i] = falls ? box.high[i] : box.low[i];
      high[i] = falls ? box.low[i] : box.high[i];
    }
    result.low[axis] = scene::posed(pose, low)[axis];
    result.high[axis] = scene::posed(pose, high)[axis];
  }
  return result;
}

double ObjectBoxes::squared_distance(const Box& box, const Eigen::Vector3d& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

void ObjectBoxes::set(std::uint32_t number, const Box& box) {
  if (number >= slots_.size()) slots_.resize(number + std::size_t{1}, kNone);
  const std::uint32_t slot = slots_[number];
  const Box before = slot == kNone ? Box() : box_in(slot);
  if (slot != kNone) remove(slot);
  if (box.empty()) return;
  try {
    insert(number, box, best_slot(box));
  } catch (...) {  // memory is exhausted
    if (!before.empty()) insert(number, before, 2 * kAbove);
    throw;
  }
}

void ObjectBoxes::put(std::uint32_t child, const Box& box, std::uint32_t slot) {
  nodes_[slot / 2].child[slot % 2] = child;
  nodes_[slot / 2].box[slot % 2] = box;
  if (is_leaf(child))
    slots_[child - kLeaf] = slot;
  else
    nodes_[child].slot = slot;
}

std::uint32_t ObjectBoxes::new_node() {
  if (free_ == kNone) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].slot;
  return node;
}

void ObjectBoxes::insert(std::uint32_t number, const Box& box, std::uint32_t slot) {
  if (child_in(slot) == kNone) {
    put(number + kLeaf, box, slot);
    return;
  }
  const std::uint32_t sibling = child_in(slot), node = new_node();
  const Box beside = box_in(slot);
  put(node, beside.joined(box), slot);
  put(sibling, beside, 2 * node);
  put(number + kLeaf, box, 2 * node + 1);
  update_from(node);
}

void ObjectBoxes::remove(std::uint32_t slot) {
  slots_[child_in(slot) - kLeaf] = kNone;
  const std::uint32_t node = slot / 2;
  if (node == kAbove) {
    nodes_[kAbove].child[0] = kNone;
    return;
  }
  const std::uint32_t sibling = slot ^ 1U;
  put(child_in(sibling), box_in(sibling), nodes_[node].slot);
  update_from(nodes_[node].slot / 2);
  nodes_[node].slot = free_;
  free_ = node;
}

std::uint32_t ObjectBoxes::best_slot(const Box& box) const {
  struct Candidate {
    double above;  ///< by how much all boxes above it grow
    std::uint32_t slot;
    bool operator<(const Candidate& other) const { return above > other.above; }  // the least is the top of a heap
  };
  std::vector<Candidate> candidates{{0, 2 * kAbove}};
  const double own = size(box);
  std::uint32_t best = 2 * kAbove;
  if (child_in(best) == kNone) return best;
  double least = std::numeric_limits<double>::infinity();
  while (!candidates.empty() && candidates.front().above + own < least) {
    std::pop_heap(candidates.begin(), candidates.end());
    const auto [above, slot] = candidates.back();
    candidates.pop_back();
    const double joined = size(box_in(slot).joined(box)), below = above + joined - size(box_in(slot));
    if (above + joined < least) least = above + joined, best = slot;
    const std::uint32_t child = child_in(slot);
    if (is_leaf(child) || !(below + own < least)) continue;
    for (const std::uint32_t next : {2 * child, 2 * child + 1}) {
      candidates.push_back({below, next});
      std::push_heap(candidates.begin(), candidates.end());
    }
  }
  return best;
}

void ObjectBoxes::update_from(std::uint32_t node) {
  while (node != kAbove) {
    while (std::abs(height(nodes_[node].child[0]) - height(nodes_[node].child[1])) > 1) turn(node);
    Node& here = nodes_[node];
    here.height = 1 + std::max(height(here.child[0]), height(here.child[1]));
    nodes_[here.slot / 2].box[here.slot % 2] = here.box[0].joined(here.box[1]);
    node = here.slot / 2;
  }
}

// The higher child goes up, into the node's slot. The node takes the place of its lower child, which goes down into the
// slot that is left.
void ObjectBoxes::turn(std::uint32_t node) {
  const std::uint32_t side = height(nodes_[node].child[0]) > height(nodes_[node].child[1]) ? 0 : 1;
  const std::uint32_t left = 2 * node + side, up = child_in(left), slot = nodes_[node].slot;
  const std::uint32_t lower = height(nodes_[up].child[0]) < height(nodes_[up].child[1]) ? 2 * up : 2 * up + 1;
  const std::uint32_t down = child_in(lower);
  const Box whole = box_in(slot), below = box_in(lower);
  put(up, whole, slot);
  put(node, whole, lower);
  put(down, below, left);
}

ObjectBoxes::Numbers ObjectBoxes::in_reach(const BoxesInReach& boxes) const {
  Numbers numbers;
  boost::container::small_vector<std::uint32_t, 64> stack;
  const auto visit = [&](std::uint32_t child) {
    if (is_leaf(child))
      numbers.push_back(child - kLeaf);
    else
      stack.push_back(child);
  };
  const Node& above = nodes_[kAbove];
  if (above.child[0] != kNone && boxes.has(above.box[0])) visit(above.child[0]);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    for (int i = 0; i < 2; ++i)
      if (boxes.has(node.box[i])) visit(node.child[i]);
  }
  std::ranges::sort(numbers);
  return numbers;
}

boost::container::small_vector<ObjectBoxes::OnWay, 32> ObjectBoxes::on_way(const Motion& motion) const {
  const CullingMotion culling(motion);
  boost::container::small_vector<OnWay, 32> found;
  boost::container::small_vector<std::uint32_t, 64> stack{kAbove};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    double times[filtered::detail::kLanes];
    const unsigned touched = culling.may_touch(node.box, times);
    for (unsigned i = 0; i < 2; ++i) {
      const std::uint32_t child = node.child[i];
      if ((touched >> i & 1) == 0 || child == kNone) continue;
      if (is_leaf(child))
        found.push_back({child - kLeaf, times[i]});
      else
        stack.push_back(child);
    }
  }
  std::ranges::sort(found, {}, [](const OnWay& box) { return std::pair(box.earliest, box.number); });
  return found;
}

}  // namespace touchstone::scene::detail
