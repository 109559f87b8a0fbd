// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/read_solid.h"
#include "experiments/thesis/cell/model/urdf_chain.h"

namespace touchstone::cell {

/// Reads a serial arm from a URDF file, by urdfdom: the links and joints of chain_of. Its base is at the origin, its
/// home angles are 0.
///
/// Lengths are in the unit of the context, each the exact multiple of the file's metres, rounded once; limits are in
/// degrees, rounded to the nearest 1e-9, since URDF writes 170 degrees as 2.967... radians, or lengths of a joint that
/// slides. For the same reason a rotation (`rpy`) whose matrix is within 1e-5 of one by quarter turns about the axes is
/// replaced by that one, and an axis that is so near to a coordinate axis by that.
///
/// A link consists of its collision elements or, if it has none, of its visual ones: boxes, cylinders (prisms of
/// `sides` sides), spheres (see Sphere), and meshes, scaled or mirrored. Names of meshes are relative to the mesh
/// folder or, if there is no such file, to that of the URDF, absolute (`file://`), or in a package
/// (`package://NAME/FILE`, `model://NAME/FILE`), which is looked for in the context's packages. In names of links and
/// elements, all characters that is_name refuses become '_'.
///
/// Links beside the arm, such as those of a gripper or a camera, move with the link of the arm that carries them: their
/// parts become parts of that, after their link's name. Joints between them stand still, at 0 or at the limit nearest
/// to it, or where a joint that they mimic puts them. In the arm, a joint that mimics another is coupled to it. A
/// revolute joint without a limit turns from -360 to 360 degrees, as a continuous one does. Robot::warnings has a
/// sentence about all that is left out, called or taken otherwise.
///
/// Throws BadCell, which names the file, the line and the link or joint, for a file of more than kMostCellMib, for what
/// checked_urdf and chain_of refuse, for a name with a control character, links whose names are equal once changed, a
/// joint that is neither revolute, continuous, prismatic nor fixed, has no axis or crossed limits, or mimics one that
/// is not there, a scale of 0, a missing mesh, and what is xacro's.
[[nodiscard]] Robot read_urdf(const std::filesystem::path& file, int sides, const SolidContext& context,
                              const UrdfEnds& ends = {});

}  // namespace touchstone::cell
