// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/robust/support/generators.h"

namespace touchstone::contact_tests {

/// What a ball is near: Hole, an edge or a vertex of a hole; Pinch, a vertex at which two loops touch.
enum class Spot { Face, Edge, Vertex, Hole, Pinch };
[[nodiscard]] const std::vector<Spot>& all_spots();
[[nodiscard]] std::string_view to_string(Spot spot);

/// How a polygon lies in space: Planar, with coordinates of 50 bits in one plane exactly; Rotated, off its plane by
/// rounding, as the samples of workloads are; Triangle, a rotated triangle, which has no plane to be off.
enum class Lie { Planar, Rotated, Triangle };

/// Draws a polygon of any family, unless it is to be a triangle, and a ball with its closest point at such a spot: a function of (seed, index) alone. Its
/// radius is the double nearest to the distance. Nothing where (seed, index) has no such ball.
[[nodiscard]] std::optional<Case> near_contact(Spot spot, Lie lie, std::uint64_t seed, std::uint64_t index);

/// Those of any (seed, index). Vertices and holes shrink away while the polygon stays valid; the radius follows.
[[nodiscard]] rc::Gen<Case> near_contact(Spot spot, Lie lie);

}  // namespace touchstone::contact_tests
