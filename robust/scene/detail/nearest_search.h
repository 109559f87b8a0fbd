// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

/// The search for the face nearest to a centre, by contact: a ball about the centre shrinks, but some face that was met
/// touches it always, so that whatever does not touch it is farther than the nearest. Distances decide at the end,
/// among the faces that still touch it.
class NearestSearch {
 public:
  /// Begins with the largest ball there is.
  explicit NearestSearch(const Eigen::Vector3d& center);

  [[nodiscard]] const Ball& ball() const { return ball_; }

  /// The first of the faces that come next.
  void enter(FaceId first) { first_ = first; }
  /// A face that will be met if it is near: a beginning for the ball, if it has none.
  void expect(const Triangle& triangle);
  void expect(const filtered::PreparedPolygon& polygon);
  /// A face that the ball touches, by its place after the first; it stays where it is. Cost: some 0.2 us a triangle,
  /// that of filtered::answer a polygon.
  void meet(const Triangle& triangle, std::uint32_t number);
  void meet(const filtered::PreparedPolygon& polygon, std::uint32_t number);

  /// Of those that were met, the one of least distance, the lowest of equals. Cost: about 1 us, and 20 us for each two
  /// whose distances are equal doubles though not those of one vertex or edge.
  [[nodiscard]] std::optional<NearestFace> nearest() const;

 private:
  struct Met {
    FaceId id;
    Feature feature;
    const Triangle* triangle;  ///< or
    const filtered::PreparedPolygon* polygon;
    std::optional<filtered::ClosestPoint> closest;  ///< of a polygon, from the beginning
  };
  [[nodiscard]] bool touched(const Met& met) const;
  /// Where the feature is: the ends of an edge in lexicographical order, a vertex twice. Features in one place are
  /// equally far. None for a face, nor where vertices are lifted.
  [[nodiscard]] static std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> place(const Met& met);
  void shrink_to(double distance);
  /// Shrinks the ball to little more than the triangle's distance.
  void shrink(const Triangle& triangle, const Feature& feature);
  /// The distance, rounded to the nearest double.
  [[nodiscard]] double distance(const Met& met) const;
  /// Is the first one nearer (-), as near (0), farther (+)?
  [[nodiscard]] int compare(const Met& first, double first_distance, const Met& second, double second_distance) const;

  Ball ball_;
  FaceId first_{0, 0};
  std::vector<Met> met_;
};

}  // namespace touchstone::scene
