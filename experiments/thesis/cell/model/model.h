// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/solid.h"
#include "robust/scene/scene.h"

namespace touchstone::cell {

/// The carrier of a part: the part moves with it, and its faces are in the carrier's frame; that of an obstacle is the
/// cell.
enum class Carrier { Link, Gripper, Finger, Storage, Machine, Obstacle, Material };

/// `link`, `gripper`, ...
[[nodiscard]] std::string_view to_string(Carrier carrier);

struct ModelPart {
  Carrier carrier;
  std::size_t
      link;  ///< index in Robot::links; the flange's for gripper and fingers, 0 for parts that do not belong to the robot
  std::string name;  ///< `Axis1/body`, `gripper/jaws`, `storage/deck`, `storage/stand`, `machine/bed`, `fence`,
                     ///< `material`
  SolidFaces faces;
};

/// Evaluates every part of a cell: links in order from the base, gripper, fingers, storage, machine, obstacles,
/// material.
///
/// Calls `done`, if given, after each part with the number of finished parts and of all. Throws what faces_of throws;
/// messages begin with the name of the part. Cost: that of faces_of.
[[nodiscard]] std::vector<ModelPart> build_model(const Cell& cell,
                                                 const std::function<void(std::size_t, std::size_t)>& done = {});

/// The faces as a scene takes them: faces of one loop with three vertices as triangles, the others as polygons, each
/// group in order. `numbers` holds their indices in SolidFaces::faces.
struct ModelFaces {
  scene::Faces faces;
  std::vector<std::size_t> numbers;
};
[[nodiscard]] ModelFaces scene_faces(const SolidFaces& solid);
/// Returns the faces of a scene as polygons, by their numbers there: triangles first.
[[nodiscard]] std::vector<Polygon> polygons_of(const scene::Faces& faces);

}  // namespace touchstone::cell
