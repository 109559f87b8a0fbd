// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/adversarial/shapes.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"

namespace touchstone::workloads::adversarial {
namespace {

using Eigen::Vector3d;

/// A vertex, the vectors to its neighbours, and unit vectors: along its edge, normal to both edges, and outwards.
struct Corner {
  Vector3d vertex, edge, back, along, normal, out;
};

Vector3d unit(const Vector3d& v) {
  const double length = std::hypot(v.x(), v.y(), v.z());
  return length > 0 && std::isfinite(length) ? Vector3d(v / length) : Vector3d(1, 0, 0);
}

Corner random_corner(Random& random, const Polygon& polygon) {
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  Corner c;
  c.vertex = polygon.vertex(i);
  c.edge = polygon.vertex(polygon.next(i)) - c.vertex;
  c.back = polygon.vertex(polygon.previous(i)) - c.vertex;
  c.along = unit(c.edge);
  c.normal = unit(c.along.cross(unit(c.back)));
  c.out = c.along.cross(c.normal);
  return c;
}

/// Draws a share from [0, 1], often of few bits.
double random_share(Random& random) {
  return random.coin() ? random.unit() : static_cast<double>(random.integer(0, 16)) / 16;
}

double random_length(Random& random, double size) {
  if (random.integer(0, 7) == 0) return 0;
  return size * random.log_uniform(-40, 3);
}

void move_a_coordinate(Random& random, Vector3d& point, std::int64_t most) {
  const auto axis = static_cast<int>(random.integer(0, 2));
  point[axis] = workloads::move_by_doubles(point[axis], random.integer(-most, most));
}

double moved(Random& random, double radius) {
  if (!(radius >= 0 && radius < 0x1p1023)) return std::abs(random.log_uniform(-30, 30));
  return std::max(0.0, workloads::move_by_doubles(radius, random.coin() ? 0 : random.integer(-3, 3)));
}

}  // namespace

double size_of(const Polygon& polygon) {
  double size = 0;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i)
    size = std::max(size, (polygon.vertex(i) - polygon.vertex(0)).cwiseAbs().maxCoeff());
  return size;
}

Vector3d center_off_feature(Random& random, const Polygon& polygon) {
  const Corner c = random_corner(random, polygon);
  const double size = size_of(polygon), height = random_length(random, size), aside = random_length(random, size);
  switch (random.integer(0, 2)) {
    case 0: {  // the face, where the polygon is convex there
      const double s = random.unit(), t = random.unit() * (1 - s);
      return c.vertex + (s * c.edge + t * c.back) + height * c.normal;
    }
    case 1: return c.vertex + random_share(random) * c.edge + (std::abs(aside) * c.out + height * c.normal);
    default: {
      const double s = random.unit();
      return c.vertex + (std::abs(aside) * (s * c.out - (1 - s) * c.along) + height * c.normal);
    }
  }
}

Vector3d center_on_polygon(Random& random, const Polygon& polygon) {
  const Corner c = random_corner(random, polygon);
  const double s = random_share(random);
  Vector3d point = c.vertex;
  switch (random.integer(0, 2)) {
    case 0: break;
    case 1: point += s * c.edge; break;
    default: point += s * c.edge + (1 - s) * random_share(random) * c.back;
  }
  if (random.coin()) move_a_coordinate(random, point, 4);
  return point;
}

Vector3d center_above_boundary(Random& random, const Polygon& polygon) {
  const Corner c = random_corner(random, polygon);
  const double share = random.integer(0, 3) == 0 ? 0 : random_share(random);
  Vector3d center = c.vertex + share * c.edge + random_length(random, size_of(polygon)) * c.normal;
  move_a_coordinate(random, center, 3);
  return center;
}

Ball ball_close_to_origin(Random& random, const Polygon& polygon) {
  const auto lowest = static_cast<int>(random.integer(-1074, -120));
  const int highest = lowest + static_cast<int>(random.integer(0, 60));
  Ball ball{};
  for (double& x : ball.center) x = random.integer(0, 3) == 0 ? 0 : random.log_uniform(lowest, highest);
  switch (random.integer(0, 3)) {
    case 0: ball.radius = 0; break;
    case 1: ball.radius = std::abs(ball.center[static_cast<int>(random.integer(0, 2))]); break;
    default: ball.radius = radius_at_exact_threshold(random, ball.center, polygon);
  }
  return ball;
}

double radius_at_threshold(Random& random, const Vector3d& center, const Polygon& polygon) {
  const fast::PreparedPolygon<long double> prepared(polygon);
  if (random.integer(0, 7) == 0) {
    const auto distance = [&]() -> long double {
      using Long = Eigen::Matrix<long double, 3, 1>;
      const Long from = center.cast<long double>() - polygon.vertex(0).cast<long double>();
      if (random.coin()) return std::sqrt(from.squaredNorm());
      return std::abs(prepared.plane().normal.dot(from)) / std::sqrt(prepared.normal_squared());
    }();
    return moved(random, static_cast<double>(distance));
  }
  return moved(random, fast::answer({center, 0}, prepared).distance);
}

double radius_at_exact_threshold(Random& random, const Vector3d& center, const Polygon& polygon) {
  return moved(random, exact::answer({center, 0}, polygon).distance);
}

}  // namespace touchstone::workloads::adversarial
