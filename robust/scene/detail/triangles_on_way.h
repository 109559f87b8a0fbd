// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "robust/filtered/detail/motion/triangle_motion.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/detail/first_contact_search.h"
#include "robust/scene/detail/tree_walk.h"

/// The triangles of a set, where they stand or in their own frame, and a moving ball that asks about them.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Returns whether the moving ball certainly misses the triangle, by the signs of doubles.
TOUCHSTONE_INLINE bool certainly_misses(const Motion& motion, const Triangle& triangle) {
  filtered::detail::CapsuleSigns signs;
  return capsule_filter(filtered::detail::view_of(motion, triangle), signs) == filtered::detail::FilterResult::No;
}

/// Passes the triangle to a search if the ball touches it before the search's end. Signs exclude most contacts that
/// times leave open: they hold for larger numbers, and for degenerate triangles.
inline void meet(const Triangle& triangle, std::uint32_t number, FirstContactSearch& search) {
  const filtered::detail::MotionTriangleView view = filtered::detail::view_of(search.motion(), triangle);
  const filtered::detail::MotionFilterResult known = filtered::detail::motion_filter(view);
  if (known.contact == filtered::detail::FilterResult::No) return;
  if (known.latest <= 2) {  // finite
    if (known.earliest <= search.end()) search.meet(triangle, number, known.feature, known.earliest, known.latest);
  } else if (known.at_start == filtered::detail::FilterResult::Yes) {
    search.start(triangle, number);
  } else if (!certainly_misses(search.motion(), triangle)) {
    filtered::NoCounts counts;
    search.meet(triangle, number, filtered::detail::later_first_contact(view, known, counts));
  }
}

/// Triangles that stand where they are.
class StandingTrianglesOnWay {
 public:
  StandingTrianglesOnWay(const TriangleSet& set, const Motion& motion)
      : leaves_(*set.placed),
        triangles_(set.placed->triangles),
        motion_(motion),
        swept_(motion),
        at_start_(set, motion.ball) {}

  void prefetch_leaf(const Leaf& leaf) const { leaves_.prefetch_leaf(leaf); }
  /// Returns the triangles of a leaf that the ball may touch before the motion ends.
  [[nodiscard]] TOUCHSTONE_INLINE LeafOnWay on_way(const Leaf& leaf) const {
    return leaves_.on_way(swept_.motion(), leaf);
  }
  /// Returns whether the ball touches a triangle of a leaf.
  [[nodiscard]] TOUCHSTONE_INLINE bool any_touched(std::span<const Leaf> leaves) const {
    return std::ranges::any_of(leaves, [&](const Leaf& leaf) {
      return any_lane(on_way(leaf).lanes(), leaf, [&](std::uint32_t place) { return touches(place); });
    });
  }
  /// Calls f(place) for the triangles of a leaf that the ball touches.
  template <class F>
  TOUCHSTONE_INLINE void for_touched(const Leaf& leaf, const F& f) const {
    for_lanes(on_way(leaf).lanes(), leaf, [&](std::uint32_t place) {
      if (touches(place)) f(place);
    });
  }
  /// Returns a motion that touches the boxes of all triangles that the ball touches, not later than the ball does.
  [[nodiscard]] const Motion& culling() const { return motion_; }
  /// Shortens the motion: it ends at this time.
  void end_at(double time) { swept_.end_at(time); }

  [[nodiscard]] Triangle triangle(std::uint32_t place) const { return triangles_[place].copy(); }
  /// Returns whether the ball touches the triangle at a place.
  [[nodiscard]] TOUCHSTONE_INLINE bool touches(std::uint32_t place) const {
    if (swept_.misses(triangles_[place])) return false;
    const Triangle triangle = triangles_[place].copy();
    filtered::NoCounts counts;
    return filtered::detail::triangle_motion_contact(filtered::detail::view_of(motion_, triangle), counts);
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool touches_at_start(std::uint32_t place) const { return at_start_.touches(place); }
  /// Passes the triangle to the search if the ball touches it before the search's end.
  void meet(std::uint32_t place, std::uint32_t number, FirstContactSearch& search) const {
    if (!swept_.misses(triangles_[place])) detail::meet(triangle(place), number, search);
  }

 private:
  TriangleLeaves leaves_;
  const TrianglesOfSharedVertices& triangles_;
  const Motion& motion_;
  Swept swept_;
  StandingTriangles at_start_;
};

/// Triangles in their own frame. Most are decided there; the others are posed.
class TrianglesInOwnFrameOnWay {
 public:
  TrianglesInOwnFrameOnWay(const TriangleSet& set, const Motion& motion)
      : leaves_(*set.placed),
        triangles_(set.placed->triangles),
        frame_(*set.frame),
        motion_(motion),
        seen_(frame_.seen(motion)),
        swept_(seen_.outer),
        at_start_(set, motion.ball) {}

  void prefetch_leaf(const Leaf& leaf) const { leaves_.prefetch_leaf(leaf); }
  /// Returns the triangles of a leaf that the ball may touch before the motion ends.
  [[nodiscard]] TOUCHSTONE_INLINE LeafOnWay on_way(const Leaf& leaf) const {
    return leaves_.on_way(swept_.motion(), leaf);
  }
  /// Returns whether the ball touches a triangle of a leaf.
  [[nodiscard]] TOUCHSTONE_INLINE bool any_touched(std::span<const Leaf> leaves) const {
    return std::ranges::any_of(leaves, [&](const Leaf& leaf) {
      return any_lane(on_way(leaf).lanes(), leaf, [&](std::uint32_t place) { return touches(place); });
    });
  }
  /// Calls f(place) for the triangles of a leaf that the ball touches.
  template <class F>
  TOUCHSTONE_INLINE void for_touched(const Leaf& leaf, const F& f) const {
    for_lanes(on_way(leaf).lanes(), leaf, [&](std::uint32_t place) {
      if (touches(place)) f(place);
    });
  }
  [[nodiscard]] const Motion& culling() const { return seen_.outer; }
  void end_at(double time) { swept_.end_at(time); }

  [[nodiscard]] Triangle triangle(std::uint32_t place) const {
    return posed_vertices(frame_.pose(), triangles_[place].copy());
  }
  [[nodiscard]] bool touches(std::uint32_t place) const {
    if (swept_.misses(triangles_[place])) return false;
    const Triangle own = triangles_[place].copy();
    filtered::detail::CapsuleSigns signs;
    const Motion inner = seen_.inner_motion();
    switch (capsule_filter(filtered::detail::view_of(seen_.outer, own), signs)) {
      case filtered::detail::FilterResult::No: return false;
      case filtered::detail::FilterResult::Yes:
        if (seen_.inner >= 0 &&
            capsule_filter(filtered::detail::view_of(inner, own), signs) == filtered::detail::FilterResult::Yes)
          return true;
        [[fallthrough]];
      default: return touches_posed(place);
    }
  }
  [[nodiscard]] bool touches_at_start(std::uint32_t place) const { return at_start_.touches(place); }
  void meet(std::uint32_t place, std::uint32_t number, FirstContactSearch& search) const {
    if (!swept_.misses(triangles_[place])) detail::meet(triangle(place), number, search);
  }

 private:
  [[nodiscard]] __attribute__((noinline)) bool touches_posed(std::uint32_t place) const {
    const Triangle posed = triangle(place);
    filtered::NoCounts counts;
    return filtered::detail::triangle_motion_contact(filtered::detail::view_of(motion_, posed), counts);
  }

  TriangleLeaves leaves_;
  const TrianglesOfSharedVertices& triangles_;
  const OwnFrame& frame_;
  const Motion& motion_;
  const SeenMotion seen_;
  Swept swept_;
  TrianglesInOwnFrame at_start_;
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
