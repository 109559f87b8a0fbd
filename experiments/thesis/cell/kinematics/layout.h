// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/cell/kinematics/chain.h"

namespace touchstone::kinematics {

/// The place of a station: at `radius` from the axis of the base in the direction `azimuth`, in degrees
/// counter-clockwise as seen from above, counted from the arm's direction at home. The x axis of its frame points away
/// from the base's axis, z points up.
struct Station {
  double azimuth, radius;
  double height;  ///< of the underside of the material in its place
};

/// The cell in which the case studies of the thesis's chapter 6 are reproduced. In millimetres and degrees. Every value
/// here is chosen; the values that the captions and the arm's table give are below and in aristo.h.
struct Layout {
  Coupling coupling;
  Hand hand;
  LinkAngles home;         ///< directions of upper arm and forearm at home; the hand then points straight down
  double sphere_distance;  ///< of the virtual sphere's centre from the flange, along the hand's axis
  double sphere_radius;
  double side;                           ///< of the material, a cube
  double gap;                            ///< between a station's x axis and the material's near side
  double drop;                           ///< of the virtual material at the machine above the material's place there
  std::array<double, 2> storage_radius;  ///< in the two cases
  std::array<double, 2> storage_height;
  double machine_radius, machine_height;  ///< of the place at the machine
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

/// Returns by how much the sphere's centre, on its way to the material from the side, is below the upper face: as far
/// as rounding to degrees can raise it and the sphere still touches the face.
[[nodiscard]] constexpr double below_upper_face(double sphere_radius) { return sphere_radius / 8; }

/// The arm in its plane, from the shoulder to the centre of the sphere. If the wrist is locked, the second link goes
/// from the elbow to that centre, else to the wrist, below which the centre hangs.
class SphereArm {
 public:
  explicit SphereArm(const Layout& layout);

  /// Shoulder and elbow, relative to home.
  struct Commands {
    double shoulder, elbow;
  };
  /// Returns the distance from the axis of the base, and the height above the floor.
  [[nodiscard]] Reach reach(const Commands& commands) const;

 private:
  Coupling coupling_;
  LinkAngles home_;  // of the two links
  double below_;     // by which the centre is below the second link's end
  TwoLinks links_;
};

/// Return the commands of the home pose, and the sphere's centre in the flange's frame.
[[nodiscard]] Angles home_pose(const Layout& layout);
[[nodiscard]] Eigen::Vector3d sphere_center(const Layout& layout);

/// The assumptions of the solution. All of them are chosen.
struct Assumptions {
  double sphere_distance = 65, sphere_radius = 6, side = 40, drop = 2.5;  ///< as in Layout
};

/// How the arm's links move while others turn.
struct Linkage {
  Coupling coupling;
  Hand hand;
};

/// Returns the layout for a linkage and a home pose in which every captioned angle of both cases results half a degree
/// from the next. The places of storage and machine, the gap and the clearance follow; radii and heights of the storage
/// generally differ between the cases. Returns nothing if the sphere would have to be behind the base's axis, or the
/// arm would have to sink when it should be lifted. Does not check for obstacles; `simulate` does.
[[nodiscard]] std::optional<Layout> solve_layout(const Linkage& linkage, const LinkAngles& home,
                                                 const Assumptions& assumptions = {});

/// Returns, ascending, the leans from -60 to 60 degrees for which the solved layout has one height of the storage in
/// both cases, for a linkage and a forearm's elevation at home.
[[nodiscard]] std::vector<double> leans_of_one_height(const Linkage& linkage, double elevation,
                                                      const Assumptions& assumptions = {});

/// The elevation of the forearm at home that the project uses. With the forearm level the hand, on its way from home to
/// the storage, would go through the place at the machine: at -25 degrees it passes in front of it.
inline constexpr double kChosenElevation = -25;

/// Returns the layout that the project uses: a level hand, a forearm that keeps its elevation while the shoulder turns,
/// and the lean that gives the storage one height in both cases. Every length and the lean are rounded to a tenth. Only
/// the storage's angle and radius then differ between the cases.
[[nodiscard]] Layout chosen_layout();

}  // namespace touchstone::kinematics
