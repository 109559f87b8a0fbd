// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <optional>
#include <utility>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"

namespace touchstone::scene::detail {

/// A face that a search has found: a copy of a triangle, or a pointer to a polygon.
struct MetFace {
  MetFace(const FaceId& number, const Triangle& face) : id(number), triangle(face), polygon(nullptr) {}
  MetFace(const FaceId& number, const filtered::PreparedPolygon& face) : id(number), polygon(&face) {}

  FaceId id;
  std::optional<Triangle> triangle;          ///< either this
  const filtered::PreparedPolygon* polygon;  ///< or this

  /// Returns the position of a feature: the ends of an edge in lexicographic order, or a vertex twice. Features at one
  /// position have the same distance from any point. Nothing for a face, or if vertices are lifted.
  [[nodiscard]] std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> place(const Feature& feature) const;
  /// Returns the face as `exact` takes it.
  [[nodiscard]] exact::PreparedPolygon exactly() const;
};

/// The search for the face nearest to a centre. It shrinks a ball about the centre that always touches some face found
/// so far, so faces that do not touch the ball are farther than the nearest. At the end distances decide among the
/// faces that still touch it.
class NearestSearch {
 public:
  /// Begins with the largest possible ball about the centre of this one.
  explicit NearestSearch(const Ball& given);

  [[nodiscard]] const Ball& ball() const { return ball_; }

  /// Sets the first face of the set that is searched next.
  void enter(FaceId first) { first_ = first; }
  /// Returns whether the ball has been shrunk.
  [[nodiscard]] bool has_shrunk() const;
  /// Shrinks the ball to a radius at which it touches some face.
  void shrink(double radius) { ball_.radius = std::min(ball_.radius, radius); }
  /// Shrinks the ball to the distance of a triangle, which is computed exactly and rounded up.
  void shrink(const Triangle& triangle);
  /// Shrinks the ball to a finite radius at which it touches the polygon. No effect if it has been shrunk.
  void expect(const filtered::PreparedPolygon& polygon);
  /// Adds a face that the ball may touch, by its number in the set.
  void meet(const Triangle& triangle, std::uint32_t number);
  /// The same, and shrinks the ball to its distance. Keeps a pointer to the polygon. Cost: that of filtered::answer.
  void meet(const filtered::PreparedPolygon& polygon, std::uint32_t number);

  /// Returns the added face with the least distance, the lowest of equals. Cost: about 0.3 us, 0.2 us more for
  /// each face but one, and 20 us for each pair of faces with equal rounded distances that do not share the nearest
  /// vertex or edge.
  [[nodiscard]] std::optional<NearestFace> nearest();
  /// Returns that face alone. Cost: nothing for a single face.
  [[nodiscard]] std::optional<FaceId> nearest_face();

 private:
  struct Met {
    MetFace face;
    std::optional<Feature> feature;                 ///< that contains the closest point; of triangles, if it is known
    std::optional<filtered::ClosestPoint> closest;  ///< for polygons only
  };
  /// Returns the face that `nearest` names; null if there is none.
  [[nodiscard]] Met* best();
  [[nodiscard]] bool touched(const Met& met) const;
  /// Shrinks the ball to a distance that was rounded to the nearest double.
  void shrink_to(double distance);
  /// Returns the distance, rounded to the nearest double.
  [[nodiscard]] double distance(Met& met) const;
  /// Returns the feature that contains the closest point.
  [[nodiscard]] const Feature& feature(Met& met) const;
  /// Returns whether the first face is nearer (-), as near (0) or farther (+).
  [[nodiscard]] int compare(const Met& first, double first_distance, const Met& second, double second_distance) const;

  double given_radius_;
  Ball ball_;
  FaceId first_{0, 0};
  boost::container::small_vector<Met, 2> met_;
};

}  // namespace touchstone::scene::detail
