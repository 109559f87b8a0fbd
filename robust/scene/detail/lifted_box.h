// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/bvh/box.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::scene::detail {

/// Returns a box that contains the lifted polygon, or the part of it within the finite doubles: points beyond them only
/// come nearer to every centre if they are moved back to the largest double. Requires round to nearest, without
/// flush-to-zero.
[[nodiscard]] Box lifted_box(const Polygon& polygon, const filtered::PreparedPolygon& prepared);

/// The same, at most 2^-20 of the polygon's size larger, computed in doubles only; nothing if the normal is not precise
/// enough in doubles. Cost: about 10 ns per vertex.
[[nodiscard]] std::optional<Box> quick_lifted_box(const Polygon& polygon);

}  // namespace touchstone::scene::detail
