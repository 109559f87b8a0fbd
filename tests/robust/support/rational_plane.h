// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>

#include "geometry/shapes/polygon.h"

namespace touchstone::contact_tests {

using Rationals = std::array<mpq_class, 3>;

inline Rationals rationals(const Eigen::Vector3d& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }
inline Rationals minus(const Rationals& a, const Rationals& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline mpq_class dot(const Rationals& a, const Rationals& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Rationals cross(const Rationals& a, const Rationals& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The plane of a loop as the contract has it: Newell's normal, the mean of the vertices, and the axis along which
/// vertices are lifted.
struct RationalPlane {
  Rationals normal, mean;
  std::size_t dropped_axis = 0;

  /// The loop of the vertices at(0) to at(count - 1).
  template <class At>
  RationalPlane(std::size_t count, const At& at) {
    for (std::size_t i = 0; i < count; ++i) {
      const Rationals p = at(i), part = cross(p, at(i + 1 < count ? i + 1 : 0));
      for (std::size_t k = 0; k < 3; ++k) {
        normal[k] += part[k];
        mean[k] += p[k] / mpq_class(static_cast<unsigned long>(count));
      }
    }
    for (const std::size_t axis : {1U, 2U})
      if (abs(normal[axis]) > abs(normal[dropped_axis])) dropped_axis = axis;
  }
  explicit RationalPlane(const Polygon& polygon)
      : RationalPlane(polygon.loop_end(0), [&](std::size_t i) { return rationals(polygon.vertex(i)); }) {}

  [[nodiscard]] Rationals lifted(Rationals point) const {
    point[dropped_axis] += dot(normal, minus(mean, point)) / normal[dropped_axis];
    return point;
  }
};

}  // namespace touchstone::contact_tests
