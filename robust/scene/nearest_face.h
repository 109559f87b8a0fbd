// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

/// The search for the face nearest to a centre, by contact alone: the ball about the centre shrinks to the distance of
/// the nearest face found, rounded up, so that whatever does not touch it is farther.
class NearestSearch {
 public:
  struct Found {
    FaceId id;
    Polygon face;
    Answer answer;
  };

  /// The largest ball there is.
  explicit NearestSearch(const Eigen::Vector3d& center);

  [[nodiscard]] const Ball& ball() const { return ball_; }
  [[nodiscard]] const std::optional<Found>& found() const { return found_; }

  /// The first of the faces that come next.
  void enter(FaceId first) { first_ = first; }
  /// A face that the ball touches, by its place after the first. Cost: that of two exact answers, some 10 us each.
  void meet(const Triangle& triangle, std::uint32_t number);
  void meet(const Polygon& polygon, std::uint32_t number);

 private:
  Ball ball_;
  FaceId first_{0, 0};
  std::optional<Found> found_;
};

}  // namespace touchstone::scene
