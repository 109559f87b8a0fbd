// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/shapes/triangle.h"

namespace touchstone::cell {

/// Returns whether two closed triangles are certainly more than a distance >= 0 apart.
///
/// True is proved: along some direction the projections of the two are further apart than that, by more than they can
/// be rounded. False proves nothing: for the corners of two boxes, say, the distance must be up to 1.8 times as large.
/// The directions are those of the coordinates and the normals of faces, of edges within their faces and of pairs of
/// edges. Requires finite coordinates. Cost: 0.1 us.
[[nodiscard]] bool further_apart(const Triangle& first, const Triangle& second, double distance);

}  // namespace touchstone::cell
