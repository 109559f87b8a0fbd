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

/// A hierarchy of balls that together contain every point of some faces: the children of a ball contain all points of
/// the faces that it contains.
///
/// Guarantees
///  (1) every point of a face is in a ball of `smallest()`: the balls circumscribe repeatedly halved boxes that tile
///      the box of the faces, and a box is left out only if, exactly, no face touches its ball (Scene::touches);
///  (2) no point of those balls is further than `overhang()` from the faces, which is at most the requested value.
/// Points inside a closed surface that are not on it need not be covered.
class BallCover {
 public:
  /// Requires overhang > 0. Throws std::length_error if that takes more than about a million balls. Cost: some
  /// microseconds per ball; there are about 3 area / overhang^2 balls.
  BallCover(const scene::Faces& faces, double overhang);

  /// Returns whether a point of the posed faces may satisfy the test. Applies the test to the largest posed ball first,
  /// and to smaller balls if it is true for the larger one; returns true if it is true for one of the smallest. If the
  /// test is monotone, that is, false for every point of a ball for which it is false, a result of false proves that no
  /// point of the faces satisfies it.
  [[nodiscard]] bool any(const Pose& pose, const std::function<bool(const Ball&)>& test) const;

  /// Returns whether points of these faces and of other posed faces may be within a distance of each other. False
  /// proves that none are.
  [[nodiscard]] bool may_be_near(const Pose& pose, const BallCover& other, const Pose& its_pose, double distance) const;

  [[nodiscard]] std::vector<Ball> smallest() const;
  /// Returns a ball around all faces.
  [[nodiscard]] Ball whole() const { return nodes_.empty() ? Ball{Eigen::Vector3d::Zero(), 0} : nodes_.front().ball; }
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

/// Returns a ball under a pose, enlarged by more than the rounding error of posing its centre in doubles and of the
/// rotation itself: it contains every exactly posed point of the ball.
[[nodiscard]] Ball posed_generously(const Pose& pose, const Ball& ball);

}  // namespace touchstone::cell
