// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/solid_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::cell {

/// What a part of the model moves with, in whose frame its faces are.
enum class Carrier { Link, Gripper, Storage, Machine, Material };

/// `link`, `gripper`, ...
[[nodiscard]] std::string_view word(Carrier carrier);

struct ModelPart {
  Carrier carrier;
  std::size_t link;  ///< place in Robot::links; that of the flange for the gripper, 0 of what is no part of the robot
  std::string name;  ///< `Axis1/body`, `gripper/jaws`, `storage/deck`, `storage/stand`, `machine/bed`, `material`
  SolidFaces faces;
};

/// Evaluates every part of a cell: links in order from the base, gripper, storage, machine, material.
///
/// Calls `done` after each part, if there is one, with how many of how many. Throws what faces_of throws; messages
/// begin with the name of the part. Cost: that of faces_of.
[[nodiscard]] std::vector<ModelPart> build_model(const Cell& cell,
                                                 const std::function<void(std::size_t, std::size_t)>& done = {});

/// The faces as a scene takes them: those of one loop of three vertices as triangles, the others as polygons; each in
/// order. `numbers` is where each of them stands in SolidFaces::faces.
struct ModelFaces {
  scene::Faces faces;
  std::vector<std::size_t> numbers;
};
[[nodiscard]] ModelFaces scene_faces(const SolidFaces& solid);

}  // namespace touchstone::cell
