// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/newell_plane.h"

#include <algorithm>
#include <cmath>

#include "robust/filtered/detail/newell_axis.h"

namespace touchstone::filtered {

NewellPlane::NewellPlane(const NewellSums& sums, std::span<const ScaledVertex> loop)
    : normal{sums.normal[0], sums.normal[1], sums.normal[2]}, dropped_axis(0) {
  const DoubleDouble share = DoubleDouble(1) / DoubleDouble(static_cast<double>(loop.size()));
  mean = {share * sums.vertices[0], share * sums.vertices[1], share * sums.vertices[2]};
  const auto size = [this](int axis) { return std::abs(normal[axis].high); };
  for (const int axis : {1, 2})
    if (size(axis) > size(dropped_axis)) dropped_axis = axis;

  // What products lose to underflow is far below the error of the smallest normal that is accepted.
  const double largest = size(dropped_axis);
  const double error = std::max({sums.error[0], sums.error[1], sums.error[2]});
  constexpr double kCertainlySmaller = 1 - 0x1p-50;  // kError and three roundings are less
  certain = largest > kSmallest && error < kError / 2 * largest;
  bool tied = false;
  for (int axis = 0; axis < 3; ++axis)
    tied = tied || (axis != dropped_axis && !(size(axis) < kCertainlySmaller * largest));
  if (!certain || !tied) return;
  const std::optional<int> axis = exact_dropped_axis(loop);
  certain = axis.has_value();
  dropped_axis = axis.value_or(dropped_axis);
}

void NewellPlane::take_exact(const Vector3<DoubleDouble>& rounded_normal, int exact_dropped_axis) {
  normal = rounded_normal;
  dropped_axis = exact_dropped_axis;
  certain = std::abs(normal[dropped_axis].high) > kSmallest;
}

}  // namespace touchstone::filtered
