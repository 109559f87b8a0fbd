// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/reach.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/solid.h"

namespace touchstone::cell {
namespace {

constexpr int kMoved = 3;  // the process moves the first three joints that turn
constexpr double kNear = 1e-9;

struct Span {
  double least, most;
};

/// Returns how far from the robot's axis the arm can hold its sphere at a height above the second joint.
std::optional<Span> plan_distances(const Reach& reach, double up) {
  if (std::abs(up) > reach.outer) return std::nullopt;
  const double far = std::sqrt(reach.outer * reach.outer - up * up),
               near = std::sqrt(std::max(0.0, reach.inner * reach.inner - up * up));
  const auto from_axis = [&](double ahead) { return std::hypot(std::max(0.0, ahead), reach.beside); };
  return Span{from_axis(near <= reach.radius ? 0 : reach.radius + near), from_axis(reach.radius + far)};
}

/// The radii of a station at which the sphere can be brought down upon material in its slot.
std::optional<Span> radii(const Reach& reach, double sphere, const Station& station, const Slot& slot,
                          const Eigen::AlignedBox3d& solid) {
  const double up = station.height + slot.place.z() + solid.max().z() + sphere - reach.height;
  const std::optional<Span> distances = plan_distances(reach, up);
  if (!distances) return std::nullopt;
  const auto radius = [&](double distance) {
    const Eigen::Vector2d aim = turned(station, slot.aim);
    const double out = distance * distance - aim.y() * aim.y();
    return std::max(0.0, std::sqrt(std::max(0.0, out)) - aim.x());
  };
  return Span{radius(distances->least), radius(distances->most)};
}

/// Rounded to four digits, to the inside of a span.
double rounded(double value, bool up) {
  if (value <= 0) return 0;
  const double digit = std::pow(10, std::floor(std::log10(value)) - 3);
  return (up ? std::ceil(value / digit) : std::floor(value / digit)) * digit;
}

/// At which radii the arm would come upon all slots from above.
std::string advice(const Reach& reach, double sphere, const Station& station, const Eigen::AlignedBox3d& solid) {
  Span all{0, std::numeric_limits<double>::infinity()};
  for (const Slot& slot : station.slots) {
    const std::optional<Span> span = radii(reach, sphere, station, slot, solid);
    if (!span) return "at this height the arm reaches it from above at no radius";
    all = {std::max(all.least, span->least), std::min(all.most, span->most)};
  }
  if (all.least > all.most) return "at this height the arm reaches all slots from above at no radius";
  return fmt::format(
      "at this height the arm reaches all slots from above at radii from {:g} to {:g}, if nothing is in the "
      "way",
      rounded(all.least, true), rounded(all.most, false));
}

std::optional<std::string> fault(const Cell& cell, const Station& station, const Reach& reach) {
  const Eigen::AlignedBox3d material = bounds_of(cell.material.solid);
  const double around = cell.gripper.sphere.radius + material.diagonal().norm() / 2;
  for (const Slot& slot : station.slots) {
    const Eigen::Vector3d middle = slot.place + material.center();
    const Eigen::Vector2d at = in_plan(station, middle.head<2>());  // the azimuth does not change the distance
    const double distance = reach.distance({at.x(), at.y(), station.height + middle.z()});
    // If the plane is beside the axis, a point may be nearer to the circle than to the joint, so none is too near.
    if (distance > reach.outer + around || (reach.beside == 0 && distance < reach.inner - around))
      return fmt::format(
          "{}.radius: {}: material in slot \"{}\" is {:.6g} from the second joint{}, where the arm holds "
          "its sphere {:.6g} to {:.6g} away; {}",
          station.key, distance < reach.inner ? "too near" : "too far", slot.name, distance,
          reach.shift > 0 ? fmt::format(" (shifted by {:.6g}, as the sphere is from the hand's joint)", reach.shift)
                          : "",
          reach.inner, reach.outer, advice(reach, cell.gripper.sphere.radius, station, material));
  }
  return std::nullopt;
}

}  // namespace

double Reach::distance(const Eigen::Vector3d& point) const {
  return std::hypot(std::hypot(point.x(), point.y()) - std::hypot(radius, beside), point.z() - height);
}

double Reach::furthest() const { return std::hypot(radius + outer, beside); }

Reach reach_of(const Cell& cell) {
  const Robot& robot = cell.robot;
  // Between joints that move the arm is rigid, as it is at home. These are the origins of all such joints but the
  // first, whose axis is the cell's, and the sphere's centre, all with the first joint at 0.
  std::vector<Eigen::Vector3d> points;
  Pose frame = robot.base;
  int turning = 0;
  std::size_t third = robot.joints.size();
  Eigen::Vector3d across = Eigen::Vector3d::Zero();  // along the second joint
  std::optional<Eigen::Vector3d> hand;  // where a joint undoes the turning of the third: the hand behind it stays level
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    frame.translation += frame.rotation * joint.origin.translation;
    frame.rotation *= joint.origin.rotation;
    if (joint.kind == Joint::Kind::Fixed) continue;
    double angle = joint.home;
    if (++turning == kMoved) third = i;
    if (turning == 2) across = frame.rotation * joint.axis.normalized();
    for (const Coupling& coupling : robot.couplings)
      if (coupling.joint == i) {
        angle += coupling.factor * robot.joints[coupling.leader].home;
        if (coupling.leader == third) hand = frame.translation;
      }
    if (turning == 1) continue;
    if (turning <= kMoved) points.push_back(frame.translation);
    frame.rotation *= rotation_about(joint.axis, angle);
  }
  const Eigen::Vector3d center = frame.translation + frame.rotation * cell.gripper.sphere.center;
  points.push_back(hand ? *hand : center);
  const Eigen::Vector3d level = center - points.back();  // the same in every pose
  Eigen::Vector3d ahead = across.cross(Eigen::Vector3d::UnitZ());
  if (ahead.dot(center) < 0) ahead = -ahead;
  double beside = std::abs(across.dot(center));
  if (beside < kNear * center.norm()) beside = 0;
  if (beside > 0)
    for (Eigen::Vector3d& point : points) point -= across.dot(point) * across;
  double sum = 0, longest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    sum += length;
    longest = std::max(longest, length);
  }
  const Eigen::Vector3d& second = points.front();
  const double shift = std::hypot(level.dot(ahead), level.z());
  return {.beside = beside,
          .radius = (second + level).dot(ahead),
          .height = second.z() + level.z(),
          .inner = std::max(0.0, 2 * longest - sum),
          .outer = sum,
          .shift = shift > kNear * sum ? shift : 0};
}

std::optional<std::string> reach_fault(const Cell& cell) {
  const Reach reach = reach_of(cell);
  const std::optional<std::string> storage = fault(cell, cell.storage, reach);
  return storage ? storage : fault(cell, cell.machine, reach);
}

}  // namespace touchstone::cell
