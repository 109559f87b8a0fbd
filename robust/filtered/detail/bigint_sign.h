// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/ball_triangle_view.h"
#include "robust/filtered/detail/sign_kind.h"

namespace touchstone::filtered {

/// Returns the exact sign for an edge of a triangle, for every finite input, in integers of any size. Requires a kind
/// other than Above. Cost: 1 to 10 us.
[[nodiscard]] int bigint_sign(SignKind kind, const BallTriangleView& view, int edge);

}  // namespace touchstone::filtered
