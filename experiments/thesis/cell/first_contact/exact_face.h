// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/thesis/cell/first_contact/integer_vector.h"
#include "geometry/bvh/box.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::kinematics {

/// Returns the exponent of the lowest bit that is set in any of these numbers; `none` if all are 0.
[[nodiscard]] int lowest_bit(const Eigen::Vector3d& v, int none);
/// Returns v / 2^unit. Requires that this is a vector of integers.
[[nodiscard]] IntegerVector in_units(const Eigen::Vector3d& v, int unit);

/// A polygon, lifted exactly onto its supporting plane: a vertex is vertices[i] times 2^unit / scale.
struct ExactFace {
  /// Requires a polygon that exact::validate accepts, and a unit that divides its coordinates.
  ExactFace(const Polygon& polygon, int unit);

  std::vector<IntegerVector> vertices;
  std::vector<std::size_t> next;  ///< edge i runs from vertex i to next[i]
  mpz_class scale;                ///< positive; 1 for polygons that are exactly planar
  IntegerVector normal;           ///< up to a positive factor
  std::size_t dropped_axis;
  double off_plane;  ///< in the unit of the polygon: the largest distance by which a vertex is lifted
};

}  // namespace touchstone::kinematics
