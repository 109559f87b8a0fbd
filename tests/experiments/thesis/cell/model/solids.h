// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/model/exact_boolean.h"
#include "experiments/thesis/cell/model/solid.h"

namespace touchstone::cell {

[[nodiscard]] inline Solid box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return {Box{lower, upper}};
}
[[nodiscard]] Solid cylinder(int axis, const Eigen::Vector3d& from, double length, double radius, int sides);
[[nodiscard]] Solid combined(Boolean::Operation operation, std::vector<Solid> parts);

/// A box or a cylinder whose numbers are small and whole, so that faces of several often lie in one plane.
[[nodiscard]] Solid random_primitive(workloads::Random& random);
/// Two to four primitives under random operations, sometimes turned by quarters.
[[nodiscard]] Solid random_solid(workloads::Random& random);

/// Returns the side of a point according to the primitives; TooNear within 1e-6 of the surface of a primitive.
enum class Side { Inside, Outside, TooNear };
[[nodiscard]] Side side_of(const Solid& solid, const Eigen::Vector3d& point);

/// How often the faces wind about the point, by the solid angles that they are seen under: 1 inside of a closed surface
/// that is oriented outwards, 0 outside, with rounding errors.
[[nodiscard]] double winding_number(const std::vector<Boundary::Loops>& faces, const Eigen::Vector3d& point);

}  // namespace touchstone::cell
