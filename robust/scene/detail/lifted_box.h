// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/bvh/box.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/prepared.h"

namespace touchstone::scene {

/// A box that holds the lifted polygon, or what of it is within the finite doubles: what lies beyond them is nearer to
/// every centre when it is moved back to the last of them. Requires round to nearest, without flush-to-zero.
[[nodiscard]] Box lifted_box(const Polygon& polygon, const filtered::PreparedPolygon& prepared);

/// The same, at most 2^-20 of the polygon's size larger, from doubles alone; none where those do not tell the normal
/// well enough. Cost: some 10 ns a vertex.
[[nodiscard]] std::optional<Box> quick_lifted_box(const Polygon& polygon);

}  // namespace touchstone::scene
