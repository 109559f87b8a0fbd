// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robust/filtered/engine.h"
#include "robust/filtered/filtered.h"

namespace touchstone::filtered {

/// What `closest` would give, from the questions of one engine.
template <class Counts>
ClosestPoint closest_by(const Questions<Counts>& ask, const Eigen::Vector3d& center, const Triangle& triangle) {
  Counts counts;
  const Ball point_ball{center, 0};
  const auto asked = question(point_ball, triangle);
  const Feature feature = ask.triangle_nearest(asked, counts);
  double point[3];
  ask.triangle_point(asked, feature, point, counts);
  return {feature, {point[0], point[1], point[2]}, ask.triangle_distance(asked, feature, counts)};
}

}  // namespace touchstone::filtered
