// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/grip.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/methods/triangulate.h"
#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {
namespace {

constexpr double kOpposite = 1e-3;  // by which the sum of two unit normals may differ from 0
constexpr double kOnFace = 1e-9;    // of the material's size: what is so near to a finger touches it

constexpr double kBroad = 100;  // an area that is wider than this many such distances

using Points = std::vector<Eigen::Vector3d>;

/// The part of a convex polygon on one side of a plane. Sutherland and Hodgman's method.
Points clipped(const Points& polygon, const Eigen::Vector3d& normal, double most) {
  Points kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at = normal.dot(a) - most, to = normal.dot(b) - most;
    if (at <= 0) kept.push_back(a);
    if ((at <= 0) != (to <= 0)) kept.push_back(a + at / (at - to) * (b - a));
  }
  return kept;
}

/// The points of one triangle that are near to another, seen along a direction: those beside it by no more than `near`
/// and before or behind its plane by no more.
Points shared(const Triangle& of, const Triangle& other, const Eigen::Vector3d& along, double near) {
  Points points{of.a, of.b, of.c};
  const std::array corners{other.a, other.b, other.c};
  Eigen::Vector3d normal = (other.b - other.a).cross(other.c - other.a);
  if (!(normal.norm() > 0)) return {};
  normal.normalize();
  const double facing = normal.dot(along);
  if (facing == 0) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d edge = corners[(i + 1) % 3] - corners[i];
    const Eigen::Vector3d out = (facing > 0 ? edge.cross(along) : along.cross(edge)).normalized();
    points = clipped(points, out, out.dot(corners[i]) + near);
  }
  points = clipped(points, normal, normal.dot(other.a) + near);
  return clipped(points, -normal, -normal.dot(other.a) + near);
}

/// The area of a convex polygon.
double area(const Points& polygon) {
  Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    doubled += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return doubled.norm() / 2;
}

/// Finds what a closed finger touches: faces that it meets in an area or, if there are none, at an edge or a corner.
void find_touched(const Workcell& workcell, std::size_t finger, const Pose& in_flange, FingerContact& contact) {
  const auto& fingers = *workcell.cell().gripper.fingers;
  const Eigen::Vector3d shift = fingers.shift(finger, contact.way);
  const touchstone::Box whole = workcell.material_tree().whole();
  const double size = (whole.high - whole.low).norm(), near = contact.gap + kOnFace * size;
  const std::vector<Polygon> faces = polygons_of(workcell.material_faces());
  bool broadly = false;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Points points;
    double met = 0;
    for (const Triangle& own : methods::triangles_of(faces[i]))
      for (const NamedTriangle& each : workcell.fingers()[finger]) {
        const Triangle at{each.triangle.a + shift, each.triangle.b + shift, each.triangle.c + shift};
        const Triangle there{in_flange * own.a, in_flange * own.b, in_flange * own.c};
        const Points both = shared(there, at, fingers.along, near);
        points.insert(points.end(), both.begin(), both.end());
        met += area(both);
      }
    const bool in_area = met > kBroad * near * size;
    if (points.empty() || (broadly && !in_area)) continue;
    if (in_area && !broadly) contact.faces.clear(), contact.place.setEmpty();
    broadly |= in_area;
    contact.faces.push_back(i);
    for (const Eigen::Vector3d& point : points) contact.place.extend(point);
  }
}

bool opposite(const Workcell& workcell, const Grip& grip) {
  const std::vector<Polygon> faces = polygons_of(workcell.material_faces());
  const auto normal = [&](std::size_t face) -> Eigen::Vector3d { return doubled_area(faces[face]).normalized(); };
  for (const std::size_t one : grip.fingers[0].faces)
    for (const std::size_t other : grip.fingers[1].faces)
      if ((normal(one) + normal(other)).norm() <= kOpposite) return true;
  return false;
}

std::string listed(const std::vector<std::size_t>& faces) {
  std::string text;
  for (const std::size_t face : faces) text += (text.empty() ? "" : ", ") + std::to_string(face);
  return text.empty() ? "none" : text;
}

/// The distance between the open fingers along the direction in which they close.
double open(const Workcell& workcell) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const Eigen::Vector3d& along = workcell.cell().gripper.fingers->along;
  for (const NamedTriangle& each : workcell.fingers()[0])
    for (const Eigen::Vector3d& v : {each.triangle.a, each.triangle.b, each.triangle.c})
      high = std::max(high, along.dot(v));
  for (const NamedTriangle& each : workcell.fingers()[1])
    for (const Eigen::Vector3d& v : {each.triangle.a, each.triangle.b, each.triangle.c})
      low = std::min(low, along.dot(v));
  return low - high;
}

}  // namespace

std::variant<Grip, std::string> close_upon(const Workcell& workcell, const Pose& in_flange) {
  const auto& fingers = *workcell.cell().gripper.fingers;
  const auto name = [&](std::size_t finger) { return "gripper/" + fingers.parts[finger].name; };
  const Pose to_material = inverse(in_flange);
  Grip grip{{}, open(workcell)};
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d direction = to_material.rotation * fingers.shift(i, 1);
    const StraightWay found = until_touch(TriangleTree(workcell.fingers()[i]), to_material, direction, fingers.stroke,
                                          workcell.material_tree());
    if (!found.touches)
      return fmt::format("{} closes by {:g} {} and touches nothing: it is too narrow there, or not between the fingers",
                         name(i), fingers.stroke, workcell.cell().unit.name);
    if (!(found.way > 0)) return name(i) + " touches it before it closes: it is too wide there";
    const touchstone::Box whole = workcell.material_tree().whole();
    if (found.gap > kOnFace * (whole.high - whole.low).norm())
      return name(i) + " slides along it, too closely to close";
    grip.fingers[i] = {found.way, found.gap, {}, {}};
    grip.opening -= found.way;
    find_touched(workcell, i, in_flange, grip.fingers[i]);
  }
  if (!opposite(workcell, grip))
    return fmt::format("{} touches its faces {} and {} its faces {}, of which no two are opposite: it would slip",
                       name(0), listed(grip.fingers[0].faces), name(1), listed(grip.fingers[1].faces));
  return grip;
}

}  // namespace touchstone::cell
