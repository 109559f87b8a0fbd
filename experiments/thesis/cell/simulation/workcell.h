// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/kinematics/chain.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"
#include "robust/scene/scene.h"

namespace touchstone::cell {

/// The slots for a piece of material: that of the storage and that of the machine. At the empty slot the sphere is
/// lowered onto an invisible copy of the material, the virtual material.
enum class StationSlot { Storage, Machine };
[[nodiscard]] std::string_view to_string(StationSlot slot);

/// The material, or its virtual copy, where it lies in the cell.
struct LyingMaterial {
  Pose pose;
  scene::Faces faces;
  scene::Scene scene;  ///< of these faces

  /// Returns the lowest face that a ball touches.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball) const;
  /// Returns the distance from a ball; 0 if they touch.
  [[nodiscard]] double gap(const Ball& ball) const;
};
using Lying = std::shared_ptr<const LyingMaterial>;

/// One of the two slots, in the cell.
struct Workplace {
  double facing;       ///< the direction of the arm's plane that holds the point to come to, counter-clockwise
  double out;          ///< the distance of that point from the base's axis
  double bottom, top;  ///< of the material there, above the floor
  double drop;         ///< of its virtual copy above it
  double left,
      right;  ///< of the material, from the plane of the arm that faces it: counter-clockwise is left; left >= right
  Lying material, copy;  ///< the material in its place, and its virtual copy, `drop` above it
};

/// The fixed obstacles, in the cell's frame.
struct Obstacles {
  scene::Faces faces;
  std::vector<std::string> owners;  ///< for each face, the part, as in ModelPart::name
};

/// A part of the arm, of the gripper, or the material.
struct Covered {
  std::string name;  ///< as in ModelPart
  Carrier carrier;
  std::size_t link;
  std::vector<NamedTriangle> triangles;  ///< that cover its faces, in its frame
};
/// Covers links, gripper and material by triangles.
[[nodiscard]] std::vector<Covered> cover_arm(const std::vector<ModelPart>& parts);

/// A cell with its posed faces and its arm. Everything is in the cell's unit and frame.
class Workcell {
 public:
  /// Throws BadCell as arm_of and PlanarArm do, Rejected for a face that the contract rejects after posing. Requires a
  /// cover of these parts' arm. Cost: some us per face.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts, std::shared_ptr<const std::vector<Covered>> arm);
  /// Computes the cover itself.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts)
      : Workcell(cell, parts, std::make_shared<const std::vector<Covered>>(cover_arm(parts))) {}

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const Arm& arm() const { return arm_; }
  [[nodiscard]] const PlanarArm& plane() const { return plane_; }
  [[nodiscard]] const Workplace& at(StationSlot slot) const { return places_[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }

  [[nodiscard]] const std::vector<Covered>& covered() const { return *covered_; }

  /// The parts that stand.
  [[nodiscard]] const scene::Scene& scene() const { return scene_; }

  /// The same things as triangles, which cover their faces: those of the parts that stand and of the floor. Owners are
  /// indices of `names()`.
  [[nodiscard]] const TriangleTree& standing() const { return *standing_tree_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The triangles of all that stands, in the cell, and those of the floor.
  [[nodiscard]] std::vector<NamedTriangle> standing_parts() const;
  /// Those without the floor.
  [[nodiscard]] const std::vector<NamedTriangle>& standing_triangles() const { return standing_triangles_; }
  /// The triangles of the gripper without its fingers and of each finger, open, in the flange's frame.
  [[nodiscard]] const std::vector<NamedTriangle>& gripper() const { return gripper_; }
  [[nodiscard]] const std::vector<std::vector<NamedTriangle>>& fingers() const { return fingers_; }
  /// Returns the material at a pose in the cell.
  [[nodiscard]] Lying lay(const Pose& pose) const;
  /// The material in its own frame: its faces, the triangles that cover them, and these in a hierarchy.
  [[nodiscard]] const scene::Faces& material_faces() const { return material_faces_; }
  [[nodiscard]] const std::vector<NamedTriangle>& material() const { return material_triangles_; }
  [[nodiscard]] const TriangleTree& material_tree() const { return *material_tree_; }

 private:
  Cell cell_;
  Arm arm_;
  PlanarArm plane_;
  std::vector<Workplace> places_;
  Obstacles obstacles_;
  std::shared_ptr<const std::vector<Covered>> covered_;
  scene::Scene scene_;
  scene::Faces floor_faces_, material_faces_;
  std::vector<std::string> names_;
  std::vector<NamedTriangle> gripper_, material_triangles_;
  std::vector<std::vector<NamedTriangle>> fingers_;
  std::vector<NamedTriangle> standing_triangles_;  // without the floor
  std::optional<TriangleTree> standing_tree_, material_tree_;
};

}  // namespace touchstone::cell
