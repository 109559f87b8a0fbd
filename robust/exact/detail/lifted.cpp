// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/lifted.h"

#include <algorithm>
#include <array>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::exact {

using namespace detail;

namespace {

/// Returns the Newell sum of the outer loop.
Vector newell_normal(const Polygon& polygon) {
  Vector sum(0, 0, 0);
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    sum = sum + kernel::cross_product(vector(polygon.vertex(i)), vector(polygon.vertex(polygon.next(i))));
  return sum;
}

int largest_component(const Vector& v) {
  int axis = 0;
  for (int k : {1, 2})
    if (kernel::abs(v[k]) > kernel::abs(v[axis])) axis = k;
  return axis;
}

}  // namespace

std::optional<int> detail::dropped_axis(const Polygon& polygon) {
  const FloatingPointState nearest;
  const Vector normal = newell_normal(polygon);
  if (normal == kernel::NULL_VECTOR) return std::nullopt;
  return largest_component(normal);
}

const PreparedPolygon::Lifted& lifted(const PreparedPolygon& polygon) { return *polygon.lifted_; }

PreparedPolygon::Lifted::Lifted(const Triangle& triangle)
    : scale(1), vertices{vector(triangle.a), vector(triangle.b), vector(triangle.c)}, next{1, 2, 0}, off_plane(0) {
  normal = kernel::cross_product(vertices[1] - vertices[0], vertices[2] - vertices[0]);
  normal_squared = normal.squared_length();
  dropped_axis = largest_component(normal);
}

PreparedPolygon::Lifted::Lifted(const Polygon& polygon) : scale(1), off_plane(0) {
  normal = newell_normal(polygon);
  if (normal == kernel::NULL_VECTOR)
    throw Rejected({RejectionCode::ZeroNormal, "the Newell normal of the outer loop is zero"});
  normal_squared = normal.squared_length();
  dropped_axis = largest_component(normal);

  const std::size_t count = polygon.vertex_count(), outer = polygon.loop_end(0);
  Vector outer_sum(0, 0, 0);
  for (std::size_t i = 0; i < count; ++i) {
    vertices.push_back(vector(polygon.vertex(i)));
    next.push_back(polygon.next(i));
    if (i < outer) outer_sum = outer_sum + vertices[i];
  }

  const Number n(static_cast<int>(outer));
  const Number plane = normal * outer_sum;  // n N.g
  std::vector<Number> height(count);        // n N.(p - g)
  for (std::size_t i = 0; i < count; ++i) height[i] = n * (normal * vertices[i]) - plane;
  if (std::all_of(height.begin(), height.end(), [](const Number& h) { return kernel::is_zero(h); })) return;

  const bool positive = kernel::is_positive(normal[dropped_axis]);
  scale = n * kernel::abs(normal[dropped_axis]);
  Number farthest(0);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Number, 3> lifted;
    for (int axis = 0; axis < 3; ++axis) lifted[static_cast<std::size_t>(axis)] = scale * vertices[i][axis];
    Number& along = lifted[static_cast<std::size_t>(dropped_axis)];
    along = positive ? Number(along - height[i]) : Number(along + height[i]);
    vertices[i] = Vector(lifted[0], lifted[1], lifted[2]);
    farthest = std::max(farthest, Number(kernel::abs(height[i])));
  }
  off_plane = rounded(farthest, scale, nearest_double);
}

}  // namespace touchstone::exact
