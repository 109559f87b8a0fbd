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

/// Where a piece of material can be: in its slot of the storage, or in that of the machine. Where it is not, an
/// invisible copy of it is what the sphere is brought down upon: the virtual material.
enum class Place { Storage, Machine };
[[nodiscard]] std::string_view word(Place place);

/// One of the two places, in the cell.
struct Workplace {
  double azimuth, out;  ///< of the point that the arm faces: degrees counter-clockwise, from the base's axis
  double bottom, top;   ///< of the material there, above the floor
  double left, right;   ///< of it, from the plane of the arm that faces it: counter-clockwise is left; left >= right
  Pose pose;            ///< of the material
  scene::Faces faces;   ///< of the material
};

/// What does not move, in the cell's frame.
struct Obstacles {
  scene::Faces faces;
  std::vector<std::string> owners;  ///< of each face: the part, as in ModelPart::name
};

/// A part of the arm, or the gripper, and the balls that hold it.
struct Covered {
  std::string name;  ///< as in ModelPart
  std::size_t link;
  BallCover cover;
};
/// Covers links and gripper. Throws std::length_error, which names the part, as BallCover does. Cost: that of
/// BallCover.
[[nodiscard]] std::vector<Covered> cover_arm(const std::vector<ModelPart>& parts, double overhang);

/// A cell, its faces where they stand, and what is known of the arm. Everything is in the cell's unit and frame.
class Workcell {
 public:
  /// Throws BadCell as arm_of and PlanarArm do, Rejected for a face that the contract rejects once it is turned.
  /// Requires a cover of these parts' arm. Cost: some us a face.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts, std::shared_ptr<const std::vector<Covered>> arm);
  /// With a cover of its own.
  Workcell(const Cell& cell, const std::vector<ModelPart>& parts, double overhang)
      : Workcell(cell, parts, std::make_shared<const std::vector<Covered>>(cover_arm(parts, overhang))) {}

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const Arm& arm() const { return arm_; }
  [[nodiscard]] const PlanarArm& plane() const { return plane_; }
  [[nodiscard]] const Workplace& at(Place place) const { return places_[static_cast<std::size_t>(place)]; }
  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }

  [[nodiscard]] const std::vector<Covered>& covered() const { return *covered_; }

  /// Which material is an obstacle.
  using Material = std::optional<Place>;

  /// Of a stop: what the sphere touches besides what it comes for, or a part of the arm may touch; empty for nothing.
  /// `balls` grows by how many were asked about.
  [[nodiscard]] std::string hindrance(const kinematics::Angles& commanded, Material material,
                                      std::uint64_t& balls) const;
  /// The lowest face of the material there that a ball touches.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball, Place place) const;

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

/// Where a station's frame stands in the cell.
[[nodiscard]] Pose pose_of(const Station& station);

}  // namespace touchstone::cell
