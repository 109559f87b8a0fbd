// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/own_frame.h"

#include <algorithm>
#include <cmath>

namespace touchstone::scene::detail {
namespace {

using namespace own_frame;
using filtered::detail::Vector3;

/// Returns whether the centre is not too far away to be moved into a frame.
bool sees(const Eigen::Vector3d& center) { return center.lpNorm<Eigen::Infinity>() <= kLargestOfCenters; }

Vector3<double> components(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Returns a bound of the norm of a b - I, except for rounding: the largest sum of magnitudes in a row or a column.
double distance_from_identity(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  Eigen::Matrix3d rest;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      rest(i, j) = std::abs(entry(components(a.row(i)), components(b.col(j))) - (i == j ? 1 : 0));
  return std::max(rest.rowwise().sum().maxCoeff(), rest.colwise().sum().maxCoeff());
}

}  // namespace

OwnFrame::OwnFrame(const Pose& pose, const Eigen::Matrix3d& inverse, double scale, double residual, double reach)
    : pose_(pose),
      inverse_(inverse),
      residual_(residual),
      lengths_(lengths(scale, residual, reach, pose.translation.lpNorm<Eigen::Infinity>())) {}

std::optional<OwnFrame> OwnFrame::of(const Pose& pose, double reach, double thinnest) {
  const double scale = pose.rotation.norm() / std::sqrt(3.0);
  if (!(scale >= 1 / kLargest && scale <= kLargest && reach <= kLargest)) return std::nullopt;
  if (!(pose.translation.lpNorm<Eigen::Infinity>() <= kLargest)) return std::nullopt;
  const Eigen::Matrix3d inverse = pose.rotation.transpose() / (scale * scale);
  const double rest =
      std::max(distance_from_identity(inverse, pose.rotation), distance_from_identity(pose.rotation, inverse));
  const double residual = rest * kWide + kResidual;
  if (!(residual <= kMostResidual)) return std::nullopt;
  const OwnFrame frame(pose, inverse, scale, residual, reach);
  if (!(thinnest_altitude(frame.lengths_, residual) < thinnest)) return std::nullopt;
  return frame;
}

SeenBall OwnFrame::seen(const Ball& ball) const {
  if (!sees(ball.center)) return {{Eigen::Vector3d::Zero(), HUGE_VAL}, -1};
  const Vector3<double> center = components(ball.center), t = components(pose_.translation);
  const double far = spread(center, t);
  Ball outer{Eigen::Vector3d::Zero(), outer_radius(ball.radius, lengths_, far)};
  for (int i = 0; i < 3; ++i) outer.center[i] = coordinate(components(inverse_.row(i)), center, t);
  return {outer, inner_radius(ball.radius, lengths_, lost(lengths_, residual_, far))};
}

SeenMotion OwnFrame::seen(const Motion& motion) const {
  if (!sees(motion.ball.center) || !sees(motion.to))
    return {{{Eigen::Vector3d::Zero(), HUGE_VAL}, Eigen::Vector3d::Zero()}, -1};
  const SeenBall first = seen(motion.ball), last = seen(Ball{motion.to, motion.ball.radius});
  return {{{first.outer.center, std::max(first.outer.radius, last.outer.radius)}, last.outer.center},
          std::min(first.inner, last.inner)};
}

double OwnFrame::radius_under_pose(const Eigen::Vector3d& center, double radius) const {
  if (!sees(center)) return HUGE_VAL;
  const double far = spread(components(center), components(pose_.translation));
  return own_frame::radius_under_pose(radius, lengths_, lost(lengths_, residual_, far));
}

double distance_from_origin(const Eigen::Vector3d& point) { return length_at_least(components(point)); }

double least_altitude(const Triangle& t) {
  const Vector3<double> sides[] = {components(t.b - t.a), components(t.c - t.a), components(t.c - t.b)};
  const double longest = std::max({length(sides[0]), length(sides[1]), length(sides[2])});
  if (!(longest >= kShortest && longest <= kLongest)) return 0;
  const double area = length(cross(sides[0], sides[1])) - off_normal(longest);
  return std::max(altitude_at_most(area, longest), 0.0);
}

}  // namespace touchstone::scene::detail
