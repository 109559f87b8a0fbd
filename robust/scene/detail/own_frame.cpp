// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/own_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::scene::detail {
namespace {

using namespace own_frame;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns whether the centre is not too far away to be moved into a frame.
bool sees(const Eigen::Vector3d& center) { return center.lpNorm<Eigen::Infinity>() <= kLargestOfCenters; }

/// Returns a bound of the norm of a matrix less the identity, except for rounding.
double distance_from_identity(const Eigen::Matrix3d& product) {
  const Eigen::Matrix3d rest = (product - Eigen::Matrix3d::Identity()).cwiseAbs();
  return std::max(rest.rowwise().sum().maxCoeff(), rest.colwise().sum().maxCoeff());
}

}  // namespace

OwnFrame::OwnFrame(const Pose& pose, const Eigen::Matrix3d& inverse, double scale, double residual, double reach)
    : pose_(pose),
      inverse_(inverse),
      residual_(residual),
      longer_((1 + residual) * scale * kWide),
      shorter_((1 + residual) / scale * kWide),
      rounding_((kRounding * (longer_ * reach + pose.translation.lpNorm<Eigen::Infinity>()) + kTiny) * kWide),
      margin_((shorter_ * rounding_ + residual * reach) * kWide) {}

std::optional<OwnFrame> OwnFrame::of(const Pose& pose, double reach, double thinnest) {
  const double scale = pose.rotation.norm() / std::sqrt(3.0);
  if (!(scale >= 1 / kLargest && scale <= kLargest && reach <= kLargest)) return std::nullopt;
  if (!(pose.translation.lpNorm<Eigen::Infinity>() <= kLargest)) return std::nullopt;
  const Eigen::Matrix3d inverse = pose.rotation.transpose() / (scale * scale);
  const double residual =
      std::max(distance_from_identity(inverse * pose.rotation), distance_from_identity(pose.rotation * inverse)) *
          kWide +
      kResidual;
  if (!(residual <= kMostResidual)) return std::nullopt;
  const OwnFrame frame(pose, inverse, scale, residual, reach);
  if (!(2 * frame.rounding_ * frame.shorter_ < (1 - residual) * thinnest * kNarrow)) return std::nullopt;
  return frame;
}

double OwnFrame::spread(const Eigen::Vector3d& center) const { return (center - pose_.translation).lpNorm<1>(); }

SeenBall OwnFrame::seen(const Ball& ball) const {
  if (!sees(ball.center)) return {{Eigen::Vector3d::Zero(), kInfinity}, -1};
  const double spread = this->spread(ball.center);
  return {{inverse_ * (ball.center - pose_.translation), outer_radius(ball.radius, shorter_, margin_, spread)},
          (ball.radius - lost(rounding_, residual_, spread)) * kNarrow / longer_};
}

SeenMotion OwnFrame::seen(const Motion& motion) const {
  if (!sees(motion.ball.center) || !sees(motion.to))
    return {{{Eigen::Vector3d::Zero(), kInfinity}, Eigen::Vector3d::Zero()}, -1};
  const SeenBall first = seen(motion.ball), last = seen(Ball{motion.to, motion.ball.radius});
  return {{{first.outer.center, std::max(first.outer.radius, last.outer.radius)}, last.outer.center},
          std::min(first.inner, last.inner)};
}

double OwnFrame::radius_under_pose(const Eigen::Vector3d& center, double radius) const {
  return sees(center) ? (longer_ * radius + lost(rounding_, residual_, spread(center))) * kWide : kInfinity;
}

double distance_from_origin(const Eigen::Vector3d& point) { return point.norm() * kWide + 0x1p-500; }

double least_altitude(const Triangle& t) {
  const Eigen::Vector3d u = t.b - t.a, v = t.c - t.a;
  const double longest = std::max({u.norm(), v.norm(), (t.c - t.b).norm()});
  if (!(longest >= 0x1p-240 && longest <= 0x1p240)) return 0;
  // A component of the normal is known to bounds::kNormal units of the largest components of the two edges.
  const double altitude = (u.cross(v).norm() - 0x1p-48 * longest * longest) / longest * kNarrow;
  return std::max(altitude, 0.0);
}

}  // namespace touchstone::scene::detail
