// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/pose.h"
#include "robust/scene/scene.h"

namespace touchstone::cell {

/// Balls that together hold every point of some faces, in a hierarchy: what is held by a ball is held by its children.
///
/// Guarantees
///  (1) every point of a face is in a ball of `smallest()`: the balls are those around boxes, halved again and again,
///      that tile the box of the faces, and a box is left out only where no face touches its ball, exactly
///      (Scene::touches);
///  (2) no point of those balls is further than `overhang()` from the faces, which is at most what was asked for.
/// What lies within a closed surface without meeting it is not covered.
class BallCover {
 public:
  /// Requires overhang > 0. Throws std::length_error where that takes more than about a million balls. Cost: some
  /// microseconds a ball, of which there are about 3 area / overhang^2.
  BallCover(const scene::Faces& faces, double overhang);

  /// May a point of the faces, posed, be where the test is true? Asks the test of the largest ball first, posed, and of
  /// smaller ones where it is true of the larger; true where it is of one of the smallest. Where this is false no point
  /// of the faces is there, if the test is false of every point of a ball of which it is false.
  [[nodiscard]] bool any(const Pose& pose, const std::function<bool(const Ball&)>& test) const;

  [[nodiscard]] std::vector<Ball> smallest() const;
  [[nodiscard]] double overhang() const { return overhang_; }

 private:
  struct Node {
    Ball ball;
    bool smallest;
    std::uint32_t first_child, children;  // a box whose ball is touched may have none: no face meets the box
  };
  std::vector<Node> nodes_;  // the root first; children next to each other
  double overhang_ = 0;
};

/// A ball under a pose, enlarged by more than posing its centre in doubles and the rotation's own rounding can be off:
/// it holds whatever point of the ball, exactly posed.
[[nodiscard]] Ball posed_generously(const Pose& pose, const Ball& ball);

}  // namespace touchstone::cell
