// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/read_solid.h"

namespace touchstone::cell {

/// Reads a serial arm from a URDF file, by urdfdom: links and joints from the root on. Its base is at the origin, its
/// home angles are 0, it has no couplings.
///
/// Lengths are in the unit of the context, each the exact multiple of the file's metres, rounded once; limits are in
/// degrees, rounded to the nearest 1e-9, since URDF writes 170 degrees as 2.967... radians, or lengths of a joint that
/// slides. For the same reason a rotation (`rpy`) within 1e-9 of one by quarter turns about the axes is replaced by
/// that one. A link consists of its collision elements or, if it has none, of its visual ones: boxes, cylinders (prisms
/// of `sides` sides), spheres (see Sphere), and meshes whose scale is that of a unit of length. Their names are
/// relative to the mesh folder, absolute (`file://`), or in a package (`package://NAME/FILE`), which is looked for in
/// the context's packages.
///
/// Throws BadCell, which names the file, the line and the link or joint, for a file of more than kMostCellMib, for
/// text that is not well-formed XML in UTF-8, has a document type, or is deeper or longer than read_urdf.cpp allows,
/// for an invalid name (is_name; for the robot and for joints: with a control character), a link with several children,
/// a joint that is neither revolute, continuous (limits -360 and 360), prismatic nor fixed, mimics another, has no axis
/// or crossed limits, another scale, or a missing mesh.
[[nodiscard]] Robot read_urdf(const std::filesystem::path& file, int sides, const SolidContext& context);

}  // namespace touchstone::cell
