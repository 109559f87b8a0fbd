// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robust/filtered/detail/scaled_vertices.h"

namespace touchstone::filtered {

/// Returns the axis of the largest component of a loop's Newell normal, the lowest on a tie, decided in integers of
/// fixed width; nothing if a coordinate from vertex 0 is not a multiple of 2^-127.
///
/// Requires at most EdgeTree::kMostEdges vertices, within 1/4 of vertex 0 in each coordinate, and round to nearest.
/// Cost: linear; 10 ns per vertex if all coordinates from vertex 0 are multiples of 2^-63, else 0.2 us.
[[nodiscard]] std::optional<int> exact_dropped_axis(std::span<const ScaledVertex> loop);

}  // namespace touchstone::filtered
