// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <vector>

#include "experiments/thesis/cell/model/solid.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cell {

/// The boundary of a solid, exact except for the rounding of its loops.
struct Boundary {
  /// A face's loops, the outer one first and counter-clockwise seen from outside, the holes clockwise; every vertex
  /// rounded to the nearest double in each coordinate. Loops that share a vertex before rounding share it afterwards.
  using Loops = std::vector<Loop>;
  std::vector<Loops> faces;  ///< in an order that depends on these coordinates alone
  mpq_class volume;          ///< before rounding
};

/// Evaluates a solid of boxes and cylinders exactly. Coplanar neighbouring faces are one.
///
/// Requires a solid that holds no mesh. Throws std::invalid_argument for a pose that does not keep orientation (its
/// determinant is not positive). Source: [hachenberger2007], as CGAL's Nef_polyhedron_3 (GPL).
[[nodiscard]] Boundary boundary_of(const Solid& solid);

}  // namespace touchstone::cell
