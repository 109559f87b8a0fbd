// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/thesis/cell/model/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/thesis/cell/model/exact_boolean.h"
#include "experiments/thesis/cell/model/poses.h"

namespace touchstone::cell {
namespace {

using workloads::Random;

Eigen::Vector3d small_point(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.integer(-4, 4)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

/// By how much the point is inside; negative outside, where its size means little.
struct Depth {
  const Eigen::Vector3d& point;

  double operator()(const Box& box) const {
    return std::min((point - box.lower).minCoeff(), (box.upper - point).minCoeff());
  }
  double operator()(const Cylinder& cylinder) const {
    const int u = (cylinder.axis + 1) % 3, v = (cylinder.axis + 2) % 3;
    const double from = cylinder.from[cylinder.axis], to = cylinder.to[cylinder.axis], at = point[cylinder.axis];
    double depth = std::min(at - std::min(from, to), std::max(from, to) - at);
    const auto corners = circle_points(cylinder.sides);
    const Eigen::Vector2d p(point[u] - cylinder.from[u], point[v] - cylinder.from[v]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto corner = [&](const CirclePoint& c) -> Eigen::Vector2d {
        return Eigen::Vector2d(static_cast<double>(c.cosine), static_cast<double>(c.sine)) *
               (cylinder.radius / static_cast<double>(c.denominator));
      };
      const Eigen::Vector2d a = corner(corners[i]), along = corner(corners[(i + 1) % corners.size()]) - a, to_p = p - a;
      depth = std::min(depth, (along.x() * to_p.y() - along.y() * to_p.x()) / along.norm());
    }
    return depth;
  }
  double operator()(const Sphere&) const { return -1; }
  double operator()(const MeshFile&) const { return -1; }
  double operator()(const Boolean&) const { return -1; }
};

}  // namespace

Solid cylinder(int axis, const Eigen::Vector3d& from, double length, double radius, int sides) {
  Eigen::Vector3d to = from;
  to[axis] += length;
  return {Cylinder{axis, from, to, radius, sides}};
}

Solid combined(Boolean::Operation operation, std::vector<Solid> parts) {
  return {Boolean{operation, std::move(parts)}};
}

Solid random_primitive(Random& random) {
  const Eigen::Vector3d from = small_point(random);
  if (random.coin()) {
    const auto size = [&] { return static_cast<double>(random.integer(1, 5)); };
    const double x = size(), y = size(), z = size();
    return box(from, from + Eigen::Vector3d(x, y, z));
  }
  const auto axis = static_cast<int>(random.integer(0, 2));
  const auto length = static_cast<double>(random.coin() ? random.integer(1, 6) : random.integer(-6, -1));
  const auto radius = static_cast<double>(random.integer(1, 4));
  return cylinder(axis, from, length, radius, static_cast<int>(random.integer(3, 12)));
}

/// Quarter turns about one of the axes.
static Eigen::Matrix3d random_turns(Random& random, int fewest, int most) {
  const auto turns = static_cast<int>(random.integer(fewest, most));
  return quarter_turns(static_cast<int>(random.integer(0, 2)), turns);
}

Solid random_solid(Random& random) {
  Solid solid = random_primitive(random);
  for (std::int64_t more = random.integer(1, 3); more > 0; --more) {
    Solid part = random_primitive(random);
    part.pose.rotation = random_turns(random, -1, 2);
    part.pose.translation = small_point(random);
    const auto operation = static_cast<Boolean::Operation>(random.integer(0, 2));
    solid = combined(operation, {std::move(solid), std::move(part)});
    solid.pose.rotation = random_turns(random, 0, 3);
    solid.pose.translation = small_point(random);
  }
  return solid;
}

Side side_of(const Solid& solid, const Eigen::Vector3d& point) {
  // Poses of these tests are quarter turns: the inverse is the transpose.
  const Eigen::Vector3d local = solid.pose.rotation.transpose() * (point - solid.pose.translation);
  const auto* const boolean = std::get_if<Boolean>(&solid.shape);
  if (boolean == nullptr) {
    const double depth = std::visit(Depth{local}, solid.shape);
    return std::abs(depth) < 1e-6 ? Side::TooNear : depth > 0 ? Side::Inside : Side::Outside;
  }
  bool inside = false;
  for (std::size_t i = 0; i < boolean->parts.size(); ++i) {
    const Side side = side_of(boolean->parts[i], local);
    if (side == Side::TooNear) return side;
    const bool in = side == Side::Inside;
    if (i == 0)
      inside = in;
    else if (boolean->operation == Boolean::Operation::Union)
      inside = inside || in;
    else
      inside = inside && in == (boolean->operation == Boolean::Operation::Intersection);
  }
  return inside ? Side::Inside : Side::Outside;
}

double winding_number(const std::vector<Boundary::Loops>& faces, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const auto& face : faces)
    for (const Loop& loop : face)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        // A loop's angle is the sum of those of the triangles of a fan, signed. Source: [vanoosterom1983].
        const Eigen::Vector3d a = loop[0] - point, b = loop[i] - point, c = loop[i + 1] - point;
        const double x = a.norm(), y = b.norm(), z = c.norm();
        sum += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + a.dot(c) * y + b.dot(c) * x);
      }
  return sum / (4 * std::numbers::pi);
}

}  // namespace touchstone::cell
