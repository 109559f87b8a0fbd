// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/rejection.h"

namespace touchstone::exact {

/// Decides exactly whether the loops bound a region: `zero-normal`, `loop-meets-itself`, `loops-meet`, `hole-outside`
/// (the first that applies), or nothing where all is well. The message names loops, edges and vertices.
///
/// Loops are judged with the dropped coordinate left out. Straight runs of collinear edges are legal; spikes,
/// touching, and edges that become points are not. Holes may lie inside holes (even-odd). Answers do not depend on
/// the caller's rounding mode or flush-to-zero setting.
///
/// Cost: O(n log n) by a sweep, plus O(n h) for h holes; about 1 us a vertex. Source: [shamos1976], [deberg2008, 2.1].
[[nodiscard]] std::optional<Rejection> validate(const Polygon& polygon);

}  // namespace touchstone::exact
