// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/judge/show/case_view.h"

namespace touchstone::show {

/// The shapes of a case in coordinates for pictures: two in the plane of the view's polygon and the height above it, in
/// doubles, scaled by a power of two. For drawing only.
struct FlatCase {
  std::vector<std::vector<Eigen::Vector2d>> loops;
  std::vector<std::vector<Eigen::Vector3d>> other_faces;  ///< of a mesh: their heights, too
  Eigen::Vector2d foot, foot_at_end;                      ///< of the centre, and of the end of its way (else the same)
  double height = 0, height_at_end = 0;
  double radius = 0;
  std::optional<Eigen::Vector2d> touched;  ///< the nearest point, or the first touched one
  std::optional<double> time;              ///< at which contact begins
  Eigen::Vector2d along;  ///< the direction of the section: a unit vector in the plane, through the foot

  /// The parts of the line through the foot in the direction `along` that lie inside the polygon, in lengths from the
  /// foot.
  [[nodiscard]] std::vector<std::pair<double, double>> section() const;
  /// The parts of the other faces in the plane of the section: lengths from the foot and heights of their ends.
  [[nodiscard]] std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> other_sections() const;
  [[nodiscard]] Eigen::Vector2d foot_at(double at_time) const { return foot + at_time * (foot_at_end - foot); }
  [[nodiscard]] double height_at(double at_time) const { return height + at_time * (height_at_end - height); }
};

/// Returns nothing if the numbers of the case differ too much for a picture.
[[nodiscard]] std::optional<FlatCase> flat_case(const CaseView& view);

}  // namespace touchstone::show
