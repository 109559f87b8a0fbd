// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/ball_triangle_view.h"
#include "robust/filtered/detail/sign_kind.h"

namespace touchstone::filtered {

/// The exact sign for edge i of a triangle (Above: not asked of triangles), in integers of any size: for every finite
/// input. Cost: 1 to 10 us.
[[nodiscard]] int bigint_sign(SignKind kind, const BallTriangleView& view, int edge);

}  // namespace touchstone::filtered
