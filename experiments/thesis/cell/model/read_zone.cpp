// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_zone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace touchstone::cell {
namespace {

constexpr double kOffPlane = 1e-6;  // of the face's size

Zone::Face read_face(const CellEntry& entry) {
  Zone::Face face;
  for (const CellEntry& corner : entry.items()) face.corners.push_back(corner.point());
  const std::size_t count = face.corners.size();
  if (count < 3) entry.bad("needs at least three corners");
  const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& { return face.corners[i % count]; };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < count; ++i) {
    normal += (corner(i) - corner(0)).cross(corner(i + 1) - corner(0));
    size = std::max(size, (corner(i) - corner(0)).norm());
  }
  if (!(normal.norm() > 0)) entry.bad("its corners lie on a line");
  normal.normalize();
  double turned = 0;  // in all
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d in = corner(i + 1) - corner(i), out = corner(i + 2) - corner(i + 1);
    const double across = in.cross(out).dot(normal);
    if (!(across > 0)) entry.bad("its corners do not turn in one direction: a face is convex");
    turned += std::atan2(across, in.dot(out));
    if (std::abs(normal.dot(corner(i) - corner(0))) > kOffPlane * size) entry.bad("its corners are not in one plane");
  }
  if (turned > 7) entry.bad("its corners go round more than once");  // than 2 pi
  return face;
}

Zone::Cuboid read_cuboid(const CellEntry& entry) {
  entry.has_only({"from", "to"});
  const Zone::Cuboid box{entry.at("from").point(), entry.at("to").point()};
  if (!(box.lower.array() < box.upper.array()).all()) entry.bad("\"from\" must be less than \"to\" in each coordinate");
  return box;
}

Zone::Capsule read_sphere(const CellEntry& entry) {
  entry.has_only({"at", "radius"});
  const Eigen::Vector3d at = entry.at("at").point();
  return {at, at, entry.at("radius").positive()};
}

Zone::Capsule read_capsule(const CellEntry& entry) {
  entry.has_only({"from", "to", "radius"});
  return {entry.at("from").point(), entry.at("to").point(), entry.at("radius").positive()};
}

}  // namespace

Zone read_zone(const CellEntry& entry) {
  entry.has_only({"name", "face", "box", "sphere", "capsule", "move", "stops"});
  std::optional<decltype(Zone::shape)> shape;
  const auto take = [&](const char* key, const auto& read) {
    const auto given = entry.find(key);
    if (!given) return;
    if (shape) entry.bad("has more than one shape");
    shape = read(*given);
  };
  take("face", read_face);
  take("box", read_cuboid);
  take("sphere", read_sphere);
  take("capsule", read_capsule);
  if (!shape) entry.bad("has no shape: face, box, sphere or capsule");
  Zone zone{entry.at("name").name(), std::move(*shape), {}, false};
  if (const auto move = entry.find("move")) zone.pose.translation = move->point();
  if (const auto stops = entry.find("stops")) zone.stops = stops->yes();
  return zone;
}

}  // namespace touchstone::cell
