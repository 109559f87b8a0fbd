// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "geometry/shapes/motion.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"

namespace touchstone::scene_tests {

/// The faces of objects without any hierarchy, to ask each of them about a moving ball.
class FacesOnWay {
 public:
  explicit FacesOnWay(const std::vector<scene::Faces>& objects);

  /// Returns the faces that are touched on the way, each asked by `filtered`.
  [[nodiscard]] std::vector<scene::FaceId> touched(const Motion& motion) const;
  /// Returns the first face. Single faces are asked by `filtered`, equal rounded times are compared by `exact`.
  [[nodiscard]] std::optional<scene::FirstFace> first(const Motion& motion) const;

  /// @{
  /// The same by `exact` alone.
  [[nodiscard]] std::vector<scene::FaceId> touched_by_exact(const Motion& motion) const;
  [[nodiscard]] std::optional<scene::FirstFace> first_by_exact(const Motion& motion) const;
  /// @}

 private:
  struct Face {
    scene::FaceId id;
    std::variant<Triangle, filtered::PreparedPolygon> filtered;
    exact::PreparedPolygon exact;
  };
  std::vector<Face> faces_;
};

}  // namespace touchstone::scene_tests
