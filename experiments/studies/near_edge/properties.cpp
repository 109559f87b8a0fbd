// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/properties.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/contact/fast.h"
#include "robust/filtered/filtered.h"

namespace touchstone::near_edge {
namespace {

std::size_t range_of(Property property, double value) {
  const auto& list = ends(property);
  const auto found = std::ranges::lower_bound(list, value) - list.begin();
  return std::min(static_cast<std::size_t>(found), list.size() - 1);
}

/// Between the edges that meet at vertex i, in degrees.
double angle_at(const fast::PreparedPolygon<>& polygon, std::size_t i) {
  std::size_t before = 0;
  while (polygon.next(before) != i) ++before;
  const Eigen::Vector3d in = -polygon.edges()[before].direction.normalized();
  const Eigen::Vector3d out = polygon.edges()[i].direction.normalized();
  return std::acos(std::clamp(in.dot(out), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

std::string_view to_string(Property property) {
  switch (property) {
    case Property::Radius: return "radius";
    case Property::Thinness: return "thinness";
    case Property::Tilt: return "tilt";
    case Property::Length: return "edge-length";
    case Property::Angle: break;
  }
  return "angle";
}

const std::vector<double>& ends(Property property) {
  static const std::array<std::vector<double>, kProperties.size()> all{{
      {1e-8, 1e-6, 1e-4, 1e-2, 1},  // by Property
      {2, 4, 8, 16, 64},
      {0.65, 0.75, 0.85, 0.95, 1},
      {0x1p-6, 0x1p-4, 0x1p-2, 1},
      {45, 90, 135, 180},
  }};
  return all[static_cast<std::size_t>(property)];
}

Ranges ranges(const cases::Crossing& crossing) {
  const Ball& ball = crossing.balls[crossing.middle()];
  const double size = cases::rounding_unit(crossing.polygon) * 0x1p53;
  const fast::PreparedPolygon<> polygon(crossing.polygon);
  const Feature nearest = filtered::answer(ball, crossing.polygon).nearest;
  Ranges found;
  const auto set = [&](Property property, double value) {
    found[static_cast<std::size_t>(property)] = range_of(property, value);
  };
  const double length = polygon.plane().normal.norm();  // twice the area
  set(Property::Radius, ball.radius / size);
  set(Property::Thinness, size * size / (length / 2));
  set(Property::Tilt, polygon.plane().normal.cwiseAbs().maxCoeff() / length);
  if (nearest.kind == Feature::Kind::Edge)
    set(Property::Length, polygon.edges()[nearest.index].direction.norm() / size);
  if (nearest.kind == Feature::Kind::Vertex) set(Property::Angle, angle_at(polygon, nearest.index));
  return found;
}

}  // namespace touchstone::near_edge
