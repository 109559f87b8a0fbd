// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "experiments/thesis/cell/model/solid.h"

namespace touchstone::cell {

/// Returns an axis-parallel box around the solid: around the first part of a difference or an intersection, around all
/// parts of a union; up to rounding errors. Reads the mesh of a MeshFile, and throws BrokenMesh.
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Solid& solid);

}  // namespace touchstone::cell
