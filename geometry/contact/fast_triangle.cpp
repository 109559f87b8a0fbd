// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/fast_triangle.h"

#include <Eigen/Geometry>

#include "geometry/contact/detail/fast_triangle_views.h"
#include "geometry/detail/required.h"

namespace touchstone::fast {
namespace {

/// Two doubles in one register; compilers do not find this by themselves.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

using Vectors = detail::Vectors<Pair>;
using Views = detail::Views<Pair>;

/// Two vectors side by side.
Vectors both(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  return {Pair{first.x(), second.x()}, Pair{first.y(), second.y()}, Pair{first.z(), second.z()}};
}

}  // namespace

bool contact(const Ball& ball, const Triangle& triangle) {
  const auto& [a, b, c] = required(triangle);
  const double radius_squared = required(ball).radius * ball.radius;
  const Eigen::Vector3d ca = a - c, normal = (b - a).cross(ca);  // away from where a, b, c turn left
  const Vectors center = both(ball.center, ball.center), start = both(a, b);
  const Views ab_bc(center - start, both(b, c) - start);
  const Views ca_normal(center - both(c, c), both(ca, normal));

  const Vectors normals = both(normal, normal);
  const Pair side = dot(normals, ab_bc.moment), last_side = dot(normals, ca_normal.moment);
  const double height = ca_normal.along[1];  // in units of |normal|
  const bool inside = (side[0] >= 0) & (side[1] >= 0) & (last_side[0] >= 0);
  const bool face = inside & (height * height <= radius_squared * ca_normal.length_squared[1]);

  const auto edges = ab_bc.touched(radius_squared);
  return face | ((edges[0] | edges[1] | ca_normal.touched(radius_squared)[0]) != 0);
}

}  // namespace touchstone::fast
