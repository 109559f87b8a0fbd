// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/model.h"
#include "experiments/cell/simulation/arm.h"
#include "experiments/cell/simulation/ball_cover.h"
#include "robust/scene/scene.h"

namespace touchstone::cell {

/// The slots for a piece of material: that of the storage and that of the machine. At the empty slot the sphere is
/// lowered onto an invisible copy of the material, the virtual material.
enum class StationSlot { Storage, Machine };
[[nodiscard]] std::string_view to_string(StationSlot slot);

/// One of the two slots, in the cell.
struct Workplace {
  double azimuth,
      out;  ///< of the point that the arm faces: degrees counter-clockwise, and distance from the base's axis
  double bottom, top;  ///< of the material there, above the floor
  double left,
      right;  ///< of the material, from the plane of the arm that faces it: counter-clockwise is left; left >= right
  Pose pose;  ///< of the material
  scene::Faces faces;  ///< of the material
};

/// The fixed obstacles, in the cell's frame.
struct Obstacles {
  scene::Faces faces;
  std::vector<std::string> owners;  ///< for each face, the part, as in ModelPart::name
};

/// A part of the arm, or the gripper, and the balls that cover it.
struct Covered {
  std::string name;  ///< as in ModelPart
  std::size_t link;
  BallCover cover;
};
/// Covers links and gripper. Throws std::length_error, which names the part, as BallCover does. Cost: that of
/// BallCover.
[[nodiscard]] std::vector<Covered> cover_arm(const std::vector<ModelPart>& parts, double overhang);

/// A cell with its posed faces and its arm. Everything is in the cell's unit and frame.
class Workcell {
 public:
  /// Throws BadCell as arm_of and PlanarArm do, Rejected for a face that the contract rejects after posing. Requires a
  /// cover of these parts' arm. Cost: some us per face.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts, std::shared_ptr<const std::vector<Covered>> arm);
  /// Computes the cover itself.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts, double overhang)
      : Workcell(cell, parts, std::make_shared<const std::vector<Covered>>(cover_arm(parts, overhang))) {}

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const Arm& arm() const { return arm_; }
  [[nodiscard]] const PlanarArm& plane() const { return plane_; }
  [[nodiscard]] const Workplace& at(StationSlot slot) const { return places_[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }

  [[nodiscard]] const std::vector<Covered>& covered() const { return *covered_; }

  /// The place of the material that is an obstacle, if any.
  using Material = std::optional<StationSlot>;

  /// Names the obstacle that the sphere touches at a stop, besides its target, or that a part of the arm may touch;
  /// empty if nothing is touched. Adds the number of tested balls to `balls`.
  [[nodiscard]] std::string touched_obstacle(const kinematics::Angles& commanded, Material material,
                                             std::uint64_t& balls) const;
  /// Returns the lowest face of the material at a place that a ball touches.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball, StationSlot slot) const;

 private:
  Cell cell_;
  Arm arm_;
  PlanarArm plane_;
  std::vector<Workplace> places_;
  Obstacles obstacles_;
  std::shared_ptr<const std::vector<Covered>> covered_;
  scene::Scene scene_;
  std::vector<std::uint32_t> standing_;  // objects of the scene
  std::vector<std::uint32_t> material_;  // by place
};

/// Returns the pose of a station's frame in the cell.
[[nodiscard]] Pose pose_of(const Station& station);

}  // namespace touchstone::cell
