// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "experiments/cell/model/solid.h"

namespace touchstone::cell {

/// A box of coordinates around the solid: around the first part of a difference or an intersection, around all of a
/// union. Rounding errors apart. Reads the mesh of a MeshFile, and throws BrokenMesh.
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Solid& solid);

}  // namespace touchstone::cell
