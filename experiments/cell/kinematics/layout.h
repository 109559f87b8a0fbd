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

/// The place of a station: at `radius` from the axis of the base in the direction `azimuth`, in degrees
/// counter-clockwise as seen from above, counted from the arm's direction at home. The x axis of its frame points away
/// from the base's axis, z points up.
struct Station {
  double azimuth, radius;
  double height;  ///< of the material's underside
};

/// The cell in which the case studies of the thesis's chapter 6 are reproduced. In millimetres and degrees. Every value
/// here is chosen; the values that the captions and the arm's table give are below and in aristo.h.
struct Layout {
  Coupling coupling;
  LinkAngles home;         ///< directions of upper arm and forearm at home; the hand then points straight down
  double sphere_distance;  ///< of the virtual sphere's centre from the flange, along the hand's axis
  double sphere_radius;
  double side;                           ///< of the material, a cube
  double gap;                            ///< between a station's x axis and the material's near side, in storage
  std::array<double, 2> storage_radius;  ///< in the two cases
  std::array<double, 2> storage_height;
  double machine_radius, machine_height;
  double clearance;  ///< the least distance by which the sphere is lifted after gripping from above

  /// Returns the storage at the given angle, in the place of one of the two cases.
  [[nodiscard]] Station storage(std::size_t place, double angle) const;
  [[nodiscard]] Station machine() const;
};

/// The directions of the storage at its angle 0 and of the machine, as seen from the base. The captions determine both:
/// 150 - 1 = 149 and 150 + 33 = 183; 149 - 66 = 183 - 100 = 83. [arshad2008, captions of Figs 6.6, 6.13, 6.22, 6.27]
inline constexpr double kStorageHome = -150, kMachineAzimuth = -83;

/// The commanded angles, relative to home, that a case study's captions name. [arshad2008, Figs 6.4 to 6.29]
struct Captions {
  double storage_angle;
  int elbow, base, shoulder;  ///< to the storage
  int lift;  ///< of the shoulder: not captioned, but required by the net 28 in both cases, 25 - 11 + 14
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
  /// Returns the distance from the axis of the base, and the height above the floor.
  [[nodiscard]] Reach reach(const Commands& commands) const;
  /// Returns the commands, nearest to home, that bring the centre to the given place; none if it is out of reach.
  [[nodiscard]] std::optional<Commands> inverse(const Reach& center) const;

 private:
  Coupling coupling_;
  LinkAngles home_;  // of the two links
  TwoLinks links_;
};

/// Return the commands of the home pose, and the sphere's centre in the flange's frame.
[[nodiscard]] Angles home_pose(const Layout& layout);
[[nodiscard]] Eigen::Vector3d sphere_center(const Layout& layout);

/// Return the faces of the material in storage and at the machine: outward quadrilaterals, each vertex rounded to
/// doubles.
[[nodiscard]] std::vector<Polygon> material_in_storage(const Layout& layout, const Station& storage);
[[nodiscard]] std::vector<Polygon> material_at_machine(const Layout& layout);

}  // namespace touchstone::kinematics
