// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "geometry/shapes/polygon.h"
#include "robust/scene/scene.h"

namespace touchstone::kinematics {

using RationalPoint = std::array<mpq_class, 3>;

/// A point of an arc whose half angle has a rational tangent: `tangent` times the length of the axis. By Rodrigues'
/// formula; the angle is 2 atan(tangent |axis|), here in doubles.
struct ArcPoint {
  double degrees;
  RationalPoint center;
};
[[nodiscard]] ArcPoint exact_point(const Arc& arc, const mpq_class& tangent);
/// The one with about this angle, which is less than 180 degrees.
[[nodiscard]] ArcPoint exact_point_near(const Arc& arc, double degrees);

/// The square of the distance of a point from the polygon of the contract, by rationals: written from the contract
/// alone, with nothing of the library.
[[nodiscard]] mpq_class squared_distance(const RationalPoint& point, const Polygon& polygon);

/// Does the closed ball about that point touch one of the faces?
[[nodiscard]] bool touches(const RationalPoint& center, double radius, const scene::Faces& faces);

}  // namespace touchstone::kinematics
