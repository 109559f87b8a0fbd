// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"
#include "robust/scene/detail/distance_bound.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/held_vertex.h"
#include "robust/scene/detail/own_frame.h"
#include "robust/scene/detail/tree_walk.h"
#include "robust/scene/detail/triangle_leaves.h"

/// The triangles of a set, where they stand or in their own frame, and a ball that asks about them.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Returns whether the ball certainly misses the triangle's box along some axis. Culls most triangles of a leaf.
///
/// Compares the differences from the vertices one by one: if a difference is at most r in magnitude, so is its rounded
/// value. Requires round to nearest, without flush-to-zero.
TOUCHSTONE_INLINE bool misses_box(const Ball& ball, const SharedTriangle& triangle) {
  const filtered::detail::Pack center = filtered::detail::load_three(ball.center.data());
  // A radius of -0 becomes +0: -0 - 0 and -0 + -0 have the sign of a miss.
  const filtered::detail::Pack radius = filtered::detail::all_lanes(ball.radius + 0.0);
  const filtered::detail::Pack a = center - filtered::detail::load_three(triangle.a.data());
  const filtered::detail::Pack b = center - filtered::detail::load_three(triangle.b.data());
  const filtered::detail::Pack c = center - filtered::detail::load_three(triangle.c.data());
  const filtered::detail::Pack below = maximum(a, maximum(b, c)) + radius, above = radius - minimum(a, minimum(b, c));
  return (negative_lanes(below | above) & 0b111) != 0;
}

/// Returns false if the ball certainly misses the triangle, by doubles.
TOUCHSTONE_INLINE bool may_touch_ball(const Ball& ball, const VertexFinder& finder, const SharedTriangle& triangle) {
  if (misses_box(ball, triangle)) return false;
  if (finder.finds(triangle)) return true;
  filtered::detail::TriangleSigns signs;
  const Triangle copy = triangle.copy();
  return triangle_filter(filtered::detail::view_of(ball, copy), signs) != filtered::detail::FilterResult::No;
}

/// Triangles that stand where they are.
class StandingTriangles {
 public:
  StandingTriangles(const TriangleSet& set, const Ball& ball)
      : leaves_(*set.placed),
        triangles_(set.placed->triangles),
        reach_(set.reach_of_placed()),
        ball_(ball),
        finder_(ball) {}

  /// Returns a ball that touches the boxes of all triangles that the ball touches.
  [[nodiscard]] const Ball& culling() const { return ball_; }
  void set_radius(double radius) {
    ball_.radius = radius;
    finder_ = VertexFinder(ball_);
  }

  void prefetch_leaf(const Leaf& leaf) const { leaves_.prefetch_leaf(leaf); }
  /// Returns whether the ball touches a triangle of these leaves of one node.
  [[nodiscard]] TOUCHSTONE_INLINE bool any_touched(std::span<const Leaf> leaves) const {
    return any_of_leaves(
        leaves, [&](const Leaf& leaf) { return leaves_.contact(ball_, ball_.radius, leaf); },
        [&](std::uint32_t place) { return touches(place); });
  }
  /// Calls f(place) for the triangles of a leaf that the ball touches.
  template <class F>
  TOUCHSTONE_INLINE void for_touched(const Leaf& leaf, const F& f) const {
    const filtered::detail::GroupAnswers known = leaves_.contact(ball_, ball_.radius, leaf);
    for_lanes(known.touched, leaf, f);
    for_lanes(known.unsure, leaf, [&](std::uint32_t place) {
      if (touches(place)) f(place);
    });
  }
  /// Returns what floats know of the distances of a leaf's triangles from the centre of `culling`.
  [[nodiscard]] TOUCHSTONE_INLINE LeafDistances distances(const Leaf& leaf) const {
    return leaves_.distances(ball_, leaf);
  }
  /// Returns a radius at which the ball touches what `culling` touches with the given radius.
  [[nodiscard]] static double radius_of(double radius) { return radius; }

  [[nodiscard]] Triangle triangle(std::uint32_t place) const { return triangles_[place].copy(); }
  /// Returns whether the ball may touch the triangle at a place.
  [[nodiscard]] TOUCHSTONE_INLINE bool may_touch(std::uint32_t place) const {
    return may_touch_ball(ball_, finder_, triangles_[place]);
  }
  /// Returns a radius at which the ball touches all triangles; infinite if none is known.
  [[nodiscard]] double reaches_all() const { return sum_of_lengths(distance_from_origin(ball_.center), reach_); }
  /// Returns at least the distance of the centre from the triangle; infinite if that is not known.
  [[nodiscard]] double distance_at_most(std::uint32_t place) const {
    return detail::distance_at_most(ball_.center, triangles_[place].copy());
  }
  /// Returns whether the ball touches the triangle at a place.
  [[nodiscard]] TOUCHSTONE_INLINE bool touches(std::uint32_t place) const {
    if (misses_box(ball_, triangles_[place])) return false;
    if (finder_.finds(triangles_[place])) return true;
    const Triangle triangle = triangles_[place].copy();
    filtered::NoCounts counts;
    return filtered::detail::contact(filtered::detail::view_of(ball_, triangle), counts);
  }

 private:
  TriangleLeaves leaves_;
  const TrianglesOfSharedVertices& triangles_;
  double reach_;
  Ball ball_;
  VertexFinder finder_;
};

/// Triangles in their own frame. Most are decided there; the others are posed.
class TrianglesInOwnFrame {
 public:
  TrianglesInOwnFrame(const TriangleSet& set, const Ball& ball)
      : leaves_(*set.placed),
        triangles_(set.placed->triangles),
        frame_(*set.frame),
        reach_(set.reach_of_placed()),
        ball_(ball),
        seen_(frame_.seen(ball)),
        finder_(seen_.inner_ball()) {}

  [[nodiscard]] const Ball& culling() const { return seen_.outer; }
  void set_radius(double radius) {
    ball_.radius = radius;
    seen_ = frame_.seen(ball_);
    finder_ = VertexFinder(seen_.inner_ball());
  }

  void prefetch_leaf(const Leaf& leaf) const { leaves_.prefetch_leaf(leaf); }
  /// Returns whether the ball touches a triangle of these leaves of one node.
  [[nodiscard]] TOUCHSTONE_INLINE bool any_touched(std::span<const Leaf> leaves) const {
    return any_of_leaves(
        leaves, [&](const Leaf& leaf) { return leaves_.contact(seen_.outer, seen_.inner, leaf); },
        [&](std::uint32_t place) { return touches(place); });
  }
  /// Calls f(place) for the triangles of a leaf that the ball touches.
  template <class F>
  TOUCHSTONE_INLINE void for_touched(const Leaf& leaf, const F& f) const {
    const filtered::detail::GroupAnswers known = leaves_.contact(seen_.outer, seen_.inner, leaf);
    for_lanes(known.touched, leaf, f);
    for_lanes(known.unsure, leaf, [&](std::uint32_t place) {
      if (touches(place)) f(place);
    });
  }
  [[nodiscard]] TOUCHSTONE_INLINE LeafDistances distances(const Leaf& leaf) const {
    return leaves_.distances(seen_.outer, leaf);
  }
  [[nodiscard]] double radius_of(double radius) const { return frame_.radius_under_pose(ball_.center, radius); }

  [[nodiscard]] Triangle triangle(std::uint32_t place) const {
    return posed_vertices(frame_.pose(), triangles_[place].copy());
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool may_touch(std::uint32_t place) const {
    return may_touch_ball(seen_.outer, finder_, triangles_[place]);
  }
  [[nodiscard]] double reaches_all() const {
    return radius_of(sum_of_lengths(distance_from_origin(seen_.outer.center), reach_));
  }
  [[nodiscard]] double distance_at_most(std::uint32_t place) const {
    return frame_.radius_under_pose(ball_.center,
                                    detail::distance_at_most(seen_.outer.center, triangles_[place].copy()));
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool touches(std::uint32_t place) const {
    if (misses_box(seen_.outer, triangles_[place])) return false;
    if (finder_.finds(triangles_[place])) return true;
    const Triangle own = triangles_[place].copy();
    filtered::detail::TriangleSigns signs;
    const Ball inner = seen_.inner_ball();
    switch (triangle_filter(filtered::detail::view_of(seen_.outer, own), signs)) {
      case filtered::detail::FilterResult::No: return false;
      case filtered::detail::FilterResult::Yes:
        if (inner.radius >= 0 &&
            triangle_filter(filtered::detail::view_of(inner, own), signs) == filtered::detail::FilterResult::Yes)
          return true;
        [[fallthrough]];
      default: return touches_posed(place);
    }
  }

 private:
  [[nodiscard]] __attribute__((noinline)) bool touches_posed(std::uint32_t place) const {
    const Triangle posed = triangle(place);
    filtered::NoCounts counts;
    return filtered::detail::contact(filtered::detail::view_of(ball_, posed), counts);
  }

  TriangleLeaves leaves_;
  const TrianglesOfSharedVertices& triangles_;
  const OwnFrame& frame_;
  double reach_;
  Ball ball_;
  SeenBall seen_;
  VertexFinder finder_;  ///< with the inner radius
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
