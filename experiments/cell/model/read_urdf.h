// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/read_solid.h"

namespace touchstone::cell {

/// A serial arm from a URDF file (read by urdfdom): links and joints from the root on. Its base stands at the origin,
/// its home angles are 0, it has no couplings.
///
/// Lengths come in the unit of the context, each the exact multiple of the file's metres, rounded once; limits in
/// degrees, to the nearest 1e-9, since URDF writes 170 degrees as 2.967... radians. For the same reason a rotation
/// (`rpy`) that is within 1e-9 of one by quarter turns about the axes is taken for it. What a link consists of are its
/// collision elements, its visual ones where it has none: boxes, cylinders (prisms of `sides` sides), and meshes whose
/// scale is that of a unit of length, named relative to the mesh folder.
///
/// Throws BadCell, which names the file, the line and the link or joint, for a file of more than kMostCellMib, for what
/// check_xml refuses, a name that is none (is_name; of the robot and of joints: with a control character), a link of
/// several children, a joint that is neither revolute, continuous (limits -360 and 360) nor fixed, mimics another, has
/// no axis or crossed limits, a sphere, another scale, or a mesh that is not there.
[[nodiscard]] Robot read_urdf(const std::filesystem::path& file, int sides, const SolidContext& context);

}  // namespace touchstone::cell
