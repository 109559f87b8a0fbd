// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/tree_walk.h"

/// The leaves of a set's tree: up to eight triangles, which floats decide together.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Calls f(place) for each of these triangles of a leaf, one per bit.
template <class F>
TOUCHSTONE_INLINE void for_lanes(unsigned lanes, const Leaf& leaf, const F& f) {
  for (; lanes != 0; lanes &= lanes - 1) f(leaf.first + static_cast<std::uint32_t>(__builtin_ctz(lanes)));
}

/// Returns whether f(place) holds for one of them.
template <class F>
TOUCHSTONE_INLINE bool any_lane(unsigned lanes, const Leaf& leaf, const F& f) {
  for (; lanes != 0; lanes &= lanes - 1)
    if (f(leaf.first + static_cast<std::uint32_t>(__builtin_ctz(lanes)))) return true;
  return false;
}

/// Returns one bit for each triangle of a leaf.
TOUCHSTONE_INLINE unsigned all_triangles(const Leaf& leaf) { return (1U << leaf.count) - 1; }

/// Returns whether one of at most kWidth leaves has a triangle that contact(leaf) knows to be touched, or one that it
/// leaves open and for which f(place) holds.
template <class Contact, class F>
TOUCHSTONE_INLINE bool any_of_leaves(std::span<const Leaf> leaves, const Contact& contact, const F& f) {
  unsigned open[BoxTree::kWidth];
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const filtered::detail::GroupAnswers known = contact(leaves[i]);
    if (known.touched != 0) return true;
    open[i] = known.unsure;
  }
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (any_lane(open[i], leaves[i], f)) return true;
  return false;
}

/// Returns a radius with which a ball touches a triangle, a little more than its distance; infinite if none is known.
/// Takes LaneDistances::most and ::size, and the factor that turns lengths into the units of the group.
TOUCHSTONE_INLINE double touching_radius(float most, double size, double scale) {
  constexpr double wide = 1 + 0x1p-20, steps = filtered::detail::TriangleGroup::kSteps;
  const double distance = static_cast<double>(most) / steps;
  const double radius = (distance + filtered::detail::lane::distance_error(size, distance)) * wide / scale;
  const filtered::detail::lane::Limits<double> limits(radius * scale, size, steps);
  return most < static_cast<float>(limits.inner) ? radius : std::numeric_limits<double>::infinity();
}

/// The distances of a leaf's triangles, as floats know them.
class LeafDistances {
 public:
  /// Knows nothing.
  explicit LeafDistances(const Leaf& leaf) : leaf_(leaf), size_(0), scale_(0) {}
  /// Requires distances in the units of a group with this scale.
  TOUCHSTONE_INLINE LeafDistances(const Leaf& leaf, const filtered::detail::LaneDistances& lanes, double scale)
      : leaf_(leaf), size_(lanes.size), scale_(scale) {
    store(most_, lanes.most);
    store(support_, lanes.support);
  }

  [[nodiscard]] const Leaf& leaf() const { return leaf_; }
  [[nodiscard]] bool known() const { return scale_ != 0; }
  /// Returns the triangles that a ball with this radius may touch, one per bit.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned within(double radius) const {
    return all_triangles(leaf_) & ~(known() ? lanes().missed(radius * scale_) : 0);
  }
  /// Returns a radius with which a ball touches one of the triangles; infinite if none is known.
  [[nodiscard]] TOUCHSTONE_INLINE double radius() const {
    if (!known()) [[unlikely]]
      return std::numeric_limits<double>::infinity();
    return touching_radius(least_of_first(lanes().most, leaf_.count), size_, scale_);
  }

 private:
  [[nodiscard]] TOUCHSTONE_INLINE filtered::detail::LaneDistances lanes() const {
    return {filtered::detail::load_eight(most_), filtered::detail::load_eight(support_), size_};
  }

  // No packs, whose alignment many allocators do not know.
  Leaf leaf_;
  float most_[filtered::detail::kFloatLanes], support_[filtered::detail::kFloatLanes];
  double size_, scale_;
};

/// The triangles of a leaf that a moving ball may touch.
class LeafOnWay {
 public:
  /// Takes all, in no particular order.
  explicit LeafOnWay(const Leaf& leaf) : leaf_(leaf), lanes_(all_triangles(leaf)) {}
  TOUCHSTONE_INLINE LeafOnWay(const Leaf& leaf, const filtered::detail::LanesOnWay& known)
      : leaf_(leaf), lanes_(all_triangles(leaf) & ~known.missed) {
    store(entry_, known.entry);
  }

  /// Returns one bit for each that is left.
  [[nodiscard]] unsigned lanes() const { return lanes_; }
  /// Leaves out those that are not among others of the leaf.
  void keep(const LeafOnWay& others) { lanes_ &= others.lanes_; }
  /// Takes the one that is probably touched first, and returns its place. Requires that one is left.
  [[nodiscard]] TOUCHSTONE_INLINE std::uint32_t take_first() {
    auto first = static_cast<std::uint32_t>(__builtin_ctz(lanes_));
    for (unsigned rest = lanes_ & (lanes_ - 1); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(rest));
      first = entry_[lane] < entry_[first] ? lane : first;
    }
    lanes_ ^= 1U << first;
    return leaf_.first + first;
  }

 private:
  Leaf leaf_;
  unsigned lanes_;
  float entry_[filtered::detail::kFloatLanes] = {};
};

class TriangleLeaves {
 public:
  explicit TriangleLeaves(const PlacedTriangles& placed) : TriangleLeaves(placed.groups.data()) {}
  /// Takes the groups, by the numbers of the leaves.
  explicit TriangleLeaves(const filtered::detail::TriangleGroup* groups) : groups_(groups) {}

  void prefetch_leaf(const Leaf& leaf) const { prefetch(groups_ + leaf.number, 1); }

  /// Returns the triangles that a ball with the radius `inner` certainly touches, and those that floats leave open; the
  /// concentric `ball`, which is not smaller, certainly misses the others.
  [[nodiscard]] TOUCHSTONE_INLINE filtered::detail::GroupAnswers contact(const Ball& ball, double inner,
                                                                         const Leaf& leaf) const {
    if (!filtered::detail::in_reach_of_groups(ball)) [[unlikely]]
      return {0, all_triangles(leaf)};
    return filtered::detail::lanes_contact(ball, inner, group(leaf), all_triangles(leaf));
  }

  /// Returns the triangles that a moving ball may touch. It certainly misses the others.
  [[nodiscard]] TOUCHSTONE_INLINE LeafOnWay on_way(const Motion& motion, const Leaf& leaf) const {
    const Ball end{motion.to, motion.ball.radius};
    double from[4], to[4];
    if (!filtered::detail::in_reach_of_groups(motion.ball) || !filtered::detail::in_reach_of_groups(end) ||
        !filtered::detail::see(motion.ball, group(leaf), from) || !filtered::detail::see(end, group(leaf), to))
        [[unlikely]]
      return LeafOnWay(leaf);
    return {leaf, filtered::detail::LaneTriangles(group(leaf)).on_way(from, to, from[3])};
  }

  /// Returns what floats know of the distances from a ball's centre: nothing if the ball is beyond the group's reach.
  [[nodiscard]] TOUCHSTONE_INLINE LeafDistances distances(const Ball& ball, const Leaf& leaf) const {
    double seen[4];
    if (!filtered::detail::in_reach_of_groups(ball) || !filtered::detail::see(ball, group(leaf), seen)) [[unlikely]]
      return LeafDistances(leaf);
    return {leaf, filtered::detail::LaneTriangles(group(leaf)).distances(seen), group(leaf).scale};
  }
  [[nodiscard]] const filtered::detail::TriangleGroup& group(const Leaf& leaf) const { return groups_[leaf.number]; }

 private:
  const filtered::detail::TriangleGroup* groups_;
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
