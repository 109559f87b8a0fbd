// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/fast_triangle.h"

#include <Eigen/Geometry>

#include "geometry/detail/required.h"

namespace touchstone::fast {
namespace {

/// Two doubles in one register; compilers do not find this by themselves.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

/// Two vectors side by side.
struct Vectors {
  Vectors(const Eigen::Vector3d& first, const Eigen::Vector3d& second)
      : x{first.x(), second.x()}, y{first.y(), second.y()}, z{first.z(), second.z()} {}
  Vectors(Pair x_, Pair y_, Pair z_) : x(x_), y(y_), z(z_) {}
  Pair x, y, z;
};

Vectors operator-(const Vectors& a, const Vectors& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Pair dot(const Vectors& a, const Vectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vectors cross(const Vectors& a, const Vectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Directions as seen from the centre.
struct Views {
  Views(const Vectors& from_start_, const Vectors& direction)
      : from_start(from_start_),
        moment(cross(from_start, direction)),
        along(dot(from_start, direction)),
        length_squared(dot(direction, direction)) {}

  Vectors from_start;  ///< to the centre
  Vectors moment;      ///< from_start x direction: as long as direction times the distance from the line
  Pair along, length_squared;

  /// Does the ball touch the edge, its end not counted?
  [[nodiscard]] auto touched(double radius_squared) const {
    const auto line =
        (dot(moment, moment) <= radius_squared * length_squared) & (along >= 0) & (along <= length_squared);
    return line | (dot(from_start, from_start) <= radius_squared);
  }
};

}  // namespace

bool contact(const Ball& ball, const Triangle& triangle) {
  const auto& [a, b, c] = required(triangle);
  const double radius_squared = required(ball).radius * ball.radius;
  const Eigen::Vector3d ca = a - c, normal = (b - a).cross(ca);  // away from where a, b, c turn left
  const Vectors center(ball.center, ball.center), start(a, b);
  const Views ab_bc(center - start, Vectors(b, c) - start);
  const Views ca_normal(center - Vectors(c, c), {ca, normal});

  const Vectors normals(normal, normal);
  const Pair side = dot(normals, ab_bc.moment), last_side = dot(normals, ca_normal.moment);
  const double height = ca_normal.along[1];  // in units of |normal|
  const bool inside = (side[0] >= 0) & (side[1] >= 0) & (last_side[0] >= 0);
  const bool face = inside & (height * height <= radius_squared * ca_normal.length_squared[1]);

  const auto edges = ab_bc.touched(radius_squared);
  return face | ((edges[0] | edges[1] | ca_normal.touched(radius_squared)[0]) != 0);
}

}  // namespace touchstone::fast
