// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "experiments/thesis/cell/simulation/workcell.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// Where a finger touches the material.
struct FingerContact {
  double way;                      ///< by which the finger has closed
  double gap;                      ///< at most, between the two
  std::vector<std::size_t> faces;  ///< of the material that it touches, as numbers of Workcell::material_faces
  Eigen::AlignedBox3d place;       ///< around the points where it does, in the flange's frame
};

/// How the fingers hold the material.
struct Grip {
  std::array<FingerContact, 2> fingers;
  double opening;  ///< between the fingers, along the direction in which they close
};

/// Closes the fingers upon material at a pose in the flange's frame: each by itself, until its first contact.
///
/// Guarantees
///  (1) no finger touches the material before it has closed by its `way` (until_touch);
///  (2) there it is at most `gap` from the material, less than 1e-9 for a cell in mm whose faces meet squarely;
///  (3) two of the touched faces, one by each finger, are opposite: their normals are, within a thousandth. An edge
///      belongs to both of its faces, so a turned box is held by two edges; whether it would turn there is not asked.
/// Otherwise returns why not, as a sentence: a finger touches nothing within its stroke, or touches at once, or slides
/// along the material, or the touched faces are not opposite, so that the material would slip. Requires a gripper with
/// fingers.
[[nodiscard]] std::variant<Grip, std::string> close_upon(const Workcell& workcell, const Pose& in_flange);

}  // namespace touchstone::cell
