// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/triangle_contacts.h"

namespace touchstone::methods {
namespace {

using Vector = Eigen::Vector3d;

/// Returns the vector from the closest point of the triangle to the centre. Tests vertices first, as their regions are
/// the cheapest to decide; computes the areas opposite to vertices, in the projection, from dot products alone.
Vector from_closest_point(const Vector& center, const Triangle& triangle) {
  const Vector ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  Vector from_a = center - triangle.a;
  const double a_along_ab = ab.dot(from_a), a_along_ac = ac.dot(from_a);
  if (a_along_ab <= 0 && a_along_ac <= 0) return from_a;

  Vector from_b = center - triangle.b;
  const double b_along_ab = ab.dot(from_b), b_along_ac = ac.dot(from_b);
  if (b_along_ab >= 0 && b_along_ac <= b_along_ab) return from_b;

  const double opposite_c = a_along_ab * b_along_ac - b_along_ab * a_along_ac;
  if (opposite_c <= 0 && a_along_ab >= 0 && b_along_ab <= 0)
    return from_a - a_along_ab / (a_along_ab - b_along_ab) * ab;

  Vector from_c = center - triangle.c;
  const double c_along_ab = ab.dot(from_c), c_along_ac = ac.dot(from_c);
  if (c_along_ac >= 0 && c_along_ab <= c_along_ac) return from_c;

  const double opposite_b = c_along_ab * a_along_ac - a_along_ab * c_along_ac;
  if (opposite_b <= 0 && a_along_ac >= 0 && c_along_ac <= 0)
    return from_a - a_along_ac / (a_along_ac - c_along_ac) * ac;

  const double opposite_a = b_along_ab * c_along_ac - c_along_ab * b_along_ac;
  const double b_along_bc = b_along_ac - b_along_ab, c_along_cb = c_along_ab - c_along_ac;
  if (opposite_a <= 0 && b_along_bc >= 0 && c_along_cb >= 0)
    return from_b - b_along_bc / (b_along_bc + c_along_cb) * (triangle.c - triangle.b);

  const double scale = 1 / (opposite_a + opposite_b + opposite_c);
  return from_a - opposite_b * scale * ab - opposite_c * scale * ac;
}

}  // namespace

bool ericson_contact(const Ball& ball, const Triangle& triangle) {
  return ericson_squared_distance(ball.center, triangle) <= ball.radius * ball.radius;
}

double ericson_squared_distance(const Eigen::Vector3d& center, const Triangle& triangle) {
  return from_closest_point(center, triangle).squaredNorm();
}

}  // namespace touchstone::methods
