// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/cell/kinematics/aristo.h"
#include "experiments/cell/kinematics/two_link.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::kinematics {

/// Where a station stands: `radius` from the axis of the base in the direction of `azimuth`, degrees counter-clockwise
/// as seen from above from where the arm points at home. Its frame has x away from that axis, z up.
struct Station {
  double azimuth, radius;
  double height;  ///< of the material's underside
};

/// The cell that the case studies of the thesis's chapter 6 are reproduced in. Millimetres and degrees. Every value is
/// chosen: what the captions and the arm's table give stands below and in aristo.h.
struct Layout {
  Coupling coupling;
  LinkAngles home;         ///< where upper arm and forearm point at home; the hand points straight down there
  double sphere_distance;  ///< of the virtual sphere's centre from the flange, along the hand's axis
  double sphere_radius;
  double side;                           ///< of the material, a cube
  double gap;                            ///< between a station's x axis and the material's near side, in storage
  std::array<double, 2> storage_radius;  ///< in the two cases
  std::array<double, 2> storage_height;
  double machine_radius, machine_height;
  double clearance;  ///< by which the sphere is lifted, at least, once it has gripped from above

  /// The storage at an angle of its own, in one of the two cases' places.
  [[nodiscard]] Station storage(std::size_t place, double angle) const;
  [[nodiscard]] Station machine() const;
};

/// Which way round the base the storage stands at its angle 0, and the machine: what the captions leave no choice in.
/// 150 - 1 = 149 and 150 + 33 = 183; 149 - 66 = 183 - 100 = 83. [arshad2008, captions of Figs 6.6, 6.13, 6.22, 6.27]
inline constexpr double kStorageHome = -150, kMachineAzimuth = -83;

/// The commanded angles, relative to home, that a case study's captions name. [arshad2008, Figs 6.4 to 6.29]
struct Captions {
  double storage_angle;
  int elbow, base, shoulder;  ///< to the storage
  int lift;                   ///< of the shoulder: not captioned, but net 28 in both cases asks for it, 25 - 11 + 14
  int elbow_to_machine, base_to_machine, shoulder_to_machine;
};
inline constexpr std::array<Captions, 2> kCases{
    {{1, -3, -149, 0, 0, 38, 66, 28}, {-33, 12, -183, 25, -11, 23, 100, 14}}};

/// The arm in its plane, from the shoulder to the centre of the sphere: the second link goes from the elbow to that
/// centre, because the wrist is locked.
class SphereArm {
 public:
  explicit SphereArm(const Layout& layout);

  /// Shoulder and elbow, relative to home.
  struct Commands {
    double shoulder, elbow;
  };
  /// Out from the axis of the base, and up from the floor.
  [[nodiscard]] Reach reach(const Commands& commands) const;
  /// The commands that bring the centre there, nearest to home; none where it is out of reach.
  [[nodiscard]] std::optional<Commands> inverse(const Reach& center) const;

 private:
  Coupling coupling_;
  LinkAngles home_;  // of the two links
  TwoLinks links_;
};

/// The chain, what it is commanded, and the sphere's centre in the flange's frame.
[[nodiscard]] Angles home_pose(const Layout& layout);
[[nodiscard]] Eigen::Vector3d sphere_center(const Layout& layout);

/// The faces of the material in storage and at the machine: outward quadrilaterals, each vertex rounded to doubles.
[[nodiscard]] std::vector<Polygon> material_in_storage(const Layout& layout, const Station& storage);
[[nodiscard]] std::vector<Polygon> material_at_machine(const Layout& layout);

}  // namespace touchstone::kinematics
