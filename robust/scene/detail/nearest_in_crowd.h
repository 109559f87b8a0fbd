// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/sets/eight_balls.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/each_ball.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/triangle_leaves.h"
#include "robust/scene/detail/walk_together.h"
#include "robust/scene/detail/walks.h"

/// Many centres that ask together for the nearest triangle of a set.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The search of the triangles that may be nearest to each centre. As in nearest_triangle, each ball shrinks so that it
/// always touches some face. Each first goes down to the leaf whose box is nearest; then all walk together to what they
/// still may touch.
///
/// Requires round to nearest, without flush-to-zero.
class NearestInCrowd {
 public:
  /// Keeps references. radii[i] is that of ball i, which is at least the distance of the nearest face so far; NaN for
  /// balls that are left out.
  NearestInCrowd(std::span<const Ball> balls, const TriangleSet& set, std::span<double> radii)
      : balls_(balls),
        set_(set),
        leaves_(*set.placed),
        radii_(radii),
        seen_(balls.size(), kUnset),
        centers_(balls.size(), kUnset),
        reaches_(balls.size(), kUnset),
        first_leaf_(balls.size(), kNoLeaf) {
    together_.reserve(balls.size());
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
      if (std::isnan(radii_[i])) continue;
      see(i);
      centers_[i] = {seen_[i].center, 0};
      const bool in_frame = !set.frame || std::isfinite(set.frame->radius_under_pose(balls[i].center, 0));
      if (in_frame && filtered::detail::in_reach_of_groups(centers_[i]) && reaches_[i].set(centers_[i], tree()))
        reaches_[i].set_radius(seen_[i].radius, tree()), together_.push_back(i);
      else
        leave_out(i);
    }
  }

  /// Adds the triangles that may be nearest. Leaves out the balls that floats cannot tell enough of.
  void search(std::uint32_t object, std::vector<PlaceOfBall>& places) {
    const auto nearest_first = [&](const NodeBoxes& boxes, std::uint32_t ball, unsigned lanes) {
      return ChildOrder(lanes, boxes.squares(reaches_[ball]));
    };
    const auto fetch = [&](const Leaf& leaf) { leaves_.prefetch_leaf(leaf); };
    walk_together(
        tree(), together_,
        [&](const NodeBoxes& boxes, std::uint32_t ball) { return boxes.nearest_met_by(reaches_[ball]); }, nearest_first,
        [&](const Leaf& leaf, BallNumbers balls) {
          for (const std::uint32_t ball : balls) first_leaf_[ball] = leaf.number;
          visit(leaf, balls);
        },
        fetch);
    std::vector<std::uint32_t> others;
    walk_together(
        tree(), together_, [&](const NodeBoxes& boxes, std::uint32_t ball) { return boxes.met_by(reaches_[ball]); },
        nearest_first,
        [&](const Leaf& leaf, BallNumbers balls) {
          others.clear();
          for (const std::uint32_t ball : balls)
            if (first_leaf_[ball] != leaf.number) others.push_back(ball);
          visit(leaf, others);
        },
        fetch);
    add_met(object, places);
  }

 private:
  static constexpr std::size_t kAtOnce = filtered::detail::kFloatLanes, kFew = 3;
  static constexpr std::uint32_t kNoLeaf = BoxTree::kNone;

  /// A triangle that a ball met, and what floats know of its distance.
  struct Met {
    std::uint32_t ball, place;
    filtered::detail::LaneDistance distance;
    double scale;
  };

  [[nodiscard]] const BoxTree& tree() const { return set_.placed->tree; }
  /// Sets a ball as the triangles see it, by its radius.
  TOUCHSTONE_INLINE void see(std::uint32_t i) {
    const Ball ball{balls_[i].center, radii_[i]};
    seen_[i] = set_.frame ? set_.frame->seen(ball).outer : ball;
  }
  void leave_out(std::uint32_t i) {
    radii_[i] = std::numeric_limits<double>::quiet_NaN();
    reaches_[i].limit = -1;
  }
  /// Shrinks a ball to a radius with which it touches a triangle as the triangles see it.
  TOUCHSTONE_INLINE void shrink(std::uint32_t i, double radius) {
    const double here = set_.frame ? set_.frame->radius_under_pose(balls_[i].center, radius) : radius;
    radii_[i] = std::min(radii_[i], here);
    see(i);
    reaches_[i].set_radius(seen_[i].radius, tree());
  }

  void visit(const Leaf& leaf, BallNumbers balls) {
    if (balls.size() < kFew) {
      for (const std::uint32_t ball : balls) look_at(leaf, ball);
      return;
    }
    for (std::size_t first = 0; first < balls.size(); first += kAtOnce)
      look_at_eight(leaf, balls.subspan(first, std::min(kAtOnce, balls.size() - first)));
  }

  /// Shrinks a ball to the nearest triangle of a leaf, and adds the triangles that it still may touch.
  void look_at(const Leaf& leaf, std::uint32_t ball) {
    using namespace filtered::detail;
    const TriangleGroup& group = leaves_.group(leaf);
    double seen[4];
    if (!filtered::detail::see(centers_[ball], group, seen)) [[unlikely]]
      return leave_out(ball);
    const LaneDistances distances = LaneTriangles(group).distances(seen);
    shrink(ball, touching_radius(least_of_first(distances.most, leaf.count), distances.size, group.scale));
    float most[kAtOnce], support[kAtOnce];
    store(most, distances.most), store(support, distances.support);
    add(leaf, ball, all_triangles(leaf) & ~distances.missed(seen_[ball].radius * group.scale), [&](unsigned lane) {
      return LaneDistance{most[lane], support[lane], distances.size};
    });
  }

  /// The same for up to eight triangle of a leaf, and adds the triangles that they still may touch.
  void look_at_eight(const Leaf& leaf, BallNumbers balls) {
    using namespace filtered::detail;
    const TriangleGroup& group = leaves_.group(leaf);
    const auto number = [&](int i) { return balls[std::min(static_cast<std::size_t>(i), balls.size() - 1)]; };
    const EightBalls eight(group, [&](int i) { return numbers_of(centers_[number(i)]); });
    const TrianglesInTurn triangles(group);
    float most[kAtOnce][kAtOnce], support[kAtOnce][kAtOnce];  // by triangle and ball
    FloatPack nearest = all_float_lanes(std::numeric_limits<float>::max());
    for (unsigned i = 0; i < leaf.count; ++i) {
      const EightDistances here = eight.distances(triangles, i);
      nearest = minimum(here.most, nearest);
      store(most[i], here.most), store(support[i], here.support);
    }
    float least[kAtOnce];
    double size[kAtOnce], radius[kAtOnce];
    store(least, nearest);
    store(size, eight.size(0)), store(size + kLanes, eight.size(1));
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if ((eight.beyond() >> i & 1) != 0) [[unlikely]]
        leave_out(balls[i]);
      else
        shrink(balls[i], touching_radius(least[i], size[i], group.scale));
    }
    for (int i = 0; i < static_cast<int>(kAtOnce); ++i) radius[i] = seen_[number(i)].radius;
    const FloatPack outer = eight.outer({load(radius), load(radius + kLanes)});
    EightMasks missed;
    for (unsigned i = 0; i < leaf.count; ++i)
      missed.set(i, negative_lanes(outer * load_eight(most[i]) - load_eight(support[i])));
    missed.turn();
    for (unsigned i = 0; i < balls.size(); ++i)
      add(leaf, balls[i], all_triangles(leaf) & ~missed.of(i), [&](unsigned lane) {
        return LaneDistance{most[lane][i], support[lane][i], size[i]};
      });
  }

  /// Adds triangles of a leaf, one per bit, to those that a ball met.
  template <class Distance>
  TOUCHSTONE_INLINE void add(const Leaf& leaf, std::uint32_t ball, unsigned lanes, const Distance& distance) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(lanes));
      met_.push_back({ball, leaf.first + lane, distance(lane), leaves_.group(leaf).scale});
    }
  }

  /// Adds the triangles that the balls still may touch: where those are several, doubles first shrink the ball.
  void add_met(std::uint32_t object, std::vector<PlaceOfBall>& places) {
    const auto missed = [&](const Met& met) {
      return !(radii_[met.ball] >= 0) || met.distance.missed(seen_[met.ball].radius * met.scale);
    };
    std::erase_if(met_, missed);
    each_ball(balls_.size(), std::span<const Met>(met_), [&](std::size_t ball, std::span<const Met> of_ball) {
      if (of_ball.size() == 1) {
        places.push_back({of_ball.front().ball, object, of_ball.front().place});
      } else if (of_ball.size() > 1) {
        const Ball now{balls_[ball].center, radii_[ball]};
        if (set_.frame)
          add_of_several(TrianglesInOwnFrame(set_, now), of_ball, object, places);
        else
          add_of_several(StandingTriangles(set_, now), of_ball, object, places);
      }
    });
  }
  template <class Triangles>
  void add_of_several(Triangles triangles, std::span<const Met> of_ball, std::uint32_t object,
                      std::vector<PlaceOfBall>& places) {
    double& radius = radii_[of_ball.front().ball];
    for (const Met& here : of_ball) radius = std::min(radius, triangles.distance_at_most(here.place));
    triangles.set_radius(radius);
    for (const Met& here : of_ball)
      if (triangles.may_touch(here.place)) places.push_back({here.ball, object, here.place});
  }

  std::span<const Ball> balls_;
  const TriangleSet& set_;
  TriangleLeaves leaves_;
  std::span<double> radii_;
  PerBall<Ball> seen_, centers_;  ///< centers_: the same with radius 0
  PerBall<FloatReach> reaches_;
  PerBall<std::uint32_t> first_leaf_;
  std::vector<std::uint32_t> together_;
  std::vector<Met> met_;
};

inline void nearest_triangles_each(std::span<const Ball> balls, const TriangleSet& set, std::uint32_t object,
                                   std::span<double> radii, std::vector<PlaceOfBall>& places) {
  NearestInCrowd(balls, set, radii).search(object, places);
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
