// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/rejection.h"

namespace touchstone::exact {

/// Decides exactly whether the loops bound a region. Returns nothing if they do, else the first of `zero-normal`,
/// `loop-meets-itself`, `loops-meet` and `hole-outside` that applies, with a message that names loops, edges and
/// vertices.
///
/// Loops are examined in the projection that drops one coordinate. A loop may touch itself or other loops where a
/// vertex lies on a vertex or on an edge, if they do not cross there. Runs of collinear edges are valid; edges that
/// overlap, spikes among them, and edges that become points are not. Holes may lie inside holes (even-odd rule). The
/// result does not depend on the caller's rounding mode or flush-to-zero setting.
///
/// Cost: O(n log n) by a sweep, plus O(n h) for h holes; about 1 us per vertex. Source: [shamos1976],
/// [deberg2008, 2.1].
[[nodiscard]] std::optional<Rejection> validate(const Polygon& polygon);

}  // namespace touchstone::exact
