// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "geometry/contact/answer.h"
#include "geometry/shapes/triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

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

}  // namespace touchstone::scene
