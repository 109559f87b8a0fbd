// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/sets/eight_balls.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/triangle_leaves.h"
#include "robust/scene/detail/walk_together.h"
#include "robust/scene/detail/walks.h"
#include "robust/scene/detail/walks_alone.h"

/// Many balls that ask together which triangles of a set they touch.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The question whether a ball touches a triangle, which floats leave open.
struct OpenQuestion {
  std::uint32_t ball, place;
};

/// The balls of a crowd as a set of triangles sees them. Requires round to nearest, without flush-to-zero.
class Crowd {
 public:
  /// Keeps references. Leaves out balls that are done.
  Crowd(std::span<const Ball> balls, const TriangleSet& set, std::span<const std::uint8_t> done)
      : balls_(balls), set_(set), leaves_(*set.placed), seen_(balls.size(), kUnset), reaches_(balls.size(), kUnset) {
    together_.reserve(balls.size());
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
      if (done[i] != 0) continue;
      seen_[i] = set.frame ? set.frame->seen(balls[i]) : SeenBall{balls[i], balls[i].radius};
      const Ball& outer = seen_[i].outer;
      const bool in_floats = filtered::detail::in_reach_of_groups(outer) && reaches_[i].set(outer, set.placed->tree);
      (in_floats ? together_ : alone_).push_back(i);
    }
  }

  /// Returns the balls that are beyond floats, and have to walk alone.
  [[nodiscard]] BallNumbers alone() const { return alone_; }

  /// Calls visit(leaf, balls, answers) for each leaf and the balls that may touch it. A ball that is done comes to no
  /// more leaves.
  template <class Visit>
  void walk(std::span<const std::uint8_t> done, const Visit& visit) const {
    std::vector<filtered::detail::GroupAnswers> answers(together_.size() + kAtOnce);
    walk_together(
        set_.placed->tree, together_,
        [&](const NodeBoxes& boxes, std::uint32_t ball) { return done[ball] != 0 ? 0 : boxes.met_by(reaches_[ball]); },
        [](const NodeBoxes&, std::uint32_t, unsigned lanes) { return ChildOrder(lanes); },
        [&](const Leaf& leaf, BallNumbers balls) {
          if (balls.size() < kFew)
            ask_each(leaf, balls, answers.data());
          else
            for (std::size_t first = 0; first < balls.size(); first += kAtOnce)
              ask_eight(leaf, balls.subspan(first), answers.data() + first);
          visit(leaf, balls, answers.data());
        },
        [&](const Leaf& leaf) { leaves_.prefetch_leaf(leaf); });
  }

  /// Answers a question.
  [[nodiscard]] bool touches(const OpenQuestion& question) const {
    const auto touches = [&](const auto& triangles) { return triangles.touches(question.place); };
    const Ball& ball = balls_[question.ball];
    return set_.frame ? touches(TrianglesInOwnFrame(set_, ball)) : touches(StandingTriangles(set_, ball));
  }

 private:
  static constexpr std::size_t kAtOnce = filtered::detail::kFloatLanes, kFew = 3;

  /// Writes what floats know of each ball and the triangles of a leaf.
  void ask_each(const Leaf& leaf, BallNumbers balls, filtered::detail::GroupAnswers* answers) const {
    for (std::size_t i = 0; i < balls.size(); ++i)
      answers[i] = leaves_.contact(seen_[balls[i]].outer, seen_[balls[i]].inner, leaf);
  }
  /// The same for the first eight. If there are fewer, writes anything for the rest of eight.
  void ask_eight(const Leaf& leaf, BallNumbers balls, filtered::detail::GroupAnswers* answers) const {
    using namespace filtered::detail;
    const TriangleGroup& group = leaves_.group(leaf);
    const auto seen = [&](int i) -> const SeenBall& {
      return seen_[balls[std::min(static_cast<std::size_t>(i), balls.size() - 1)]];
    };
    const auto four = [](int first, const auto& number) {
      return pack(number(first), number(first + 1), number(first + 2), number(first + 3));
    };
    const auto radii = [&](const auto& radius) { return EightBalls::Radii{four(0, radius), four(kLanes, radius)}; };
    const EightBalls eight(group, [&](int i) { return numbers_of(seen(i).outer); });
    const FloatPack inner = eight.inner(radii([&](int i) { return seen(i).inner; })),
                    outer = eight.outer(radii([&](int i) { return seen(i).outer.radius; }));
    const TrianglesInTurn triangles(group);
    EightMasks touched, missed;
    for (unsigned i = 0; i < leaf.count; ++i) {
      const EightDistances here = eight.distances(triangles, i);
      touched.set(i, negative_lanes(here.most - inner) & ~eight.beyond());
      missed.set(i, negative_lanes(outer * here.most - here.support) & ~eight.beyond());
    }
    touched.turn(), missed.turn();
    for (unsigned i = 0; i < kAtOnce; ++i)
      answers[i] = {touched.of(i), all_triangles(leaf) & ~(touched.of(i) | missed.of(i))};
  }

  std::span<const Ball> balls_;
  const TriangleSet& set_;
  TriangleLeaves leaves_;
  PerBall<SeenBall> seen_;
  PerBall<FloatReach> reaches_;  ///< of the balls that walk together
  std::vector<std::uint32_t> together_, alone_;
};

// The walks of a crowd: CrowdWalks.

inline void touches_triangle_each(std::span<const Ball> balls, const TriangleSet& set,
                                  std::span<std::uint8_t> touches) {
  const Crowd crowd(balls, set, touches);
  for (const std::uint32_t ball : crowd.alone()) touches[ball] = touches_triangle(balls[ball], set) ? 1 : 0;
  std::vector<OpenQuestion> open;
  crowd.walk(touches, [&](const Leaf& leaf, BallNumbers numbers, const filtered::detail::GroupAnswers* known) {
    unsigned unsure = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      touches[numbers[i]] |= known[i].touched != 0 ? 1 : 0;
      unsure |= known[i].unsure;
    }
    if (unsure == 0) return;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (touches[numbers[i]] == 0)
        for_lanes(known[i].unsure, leaf, [&](std::uint32_t place) { open.push_back({numbers[i], place}); });
  });
  for (const OpenQuestion& question : open)
    if (touches[question.ball] == 0 && crowd.touches(question)) touches[question.ball] = 1;
}

inline void touched_triangles_each(std::span<const Ball> balls, const TriangleSet& set, FaceId first,
                                   std::vector<TouchedFace>& faces) {
  const std::vector<std::uint8_t> none(balls.size(), 0);
  const Crowd crowd(balls, set, none);
  for (const std::uint32_t ball : crowd.alone()) {
    std::vector<FaceId> touched;
    touched_triangles(balls[ball], set, first, touched);
    for (const FaceId& face : touched) faces.push_back({ball, face});
  }
  const std::vector<std::uint32_t>& order = set.placed->tree.order();
  const auto add = [&](std::uint32_t ball, std::uint32_t place) {
    faces.push_back({ball, {first.object, first.face + order[place]}});
  };
  std::vector<OpenQuestion> open;
  crowd.walk(none, [&](const Leaf& leaf, BallNumbers numbers, const filtered::detail::GroupAnswers* known) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for_lanes(known[i].touched, leaf, [&](std::uint32_t place) { add(numbers[i], place); });
      for_lanes(known[i].unsure, leaf, [&](std::uint32_t place) { open.push_back({numbers[i], place}); });
    }
  });
  for (const OpenQuestion& question : open)
    if (crowd.touches(question)) add(question.ball, question.place);
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
