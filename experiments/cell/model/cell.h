// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/model/solid.h"
#include "experiments/workloads/meshes/unit.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/pose.h"

/// The virtual manufacturing cell: what a cell file says, checked, in plain structures.
///
/// One unit of length for all (`Cell::unit`), angles in degrees. The cell's frame: z up, the floor at z = 0, the origin
/// on the axis of the robot's first joint, x the direction in which the arm points at home. Angles in the plan are
/// counted counter-clockwise as seen from above. Parts of the robot are given in the frame of their link.
namespace touchstone::cell {

/// Where a value comes from: the thesis's text, another public source, arithmetic on these, or chosen, because no
/// public source gives it.
enum class Label { Text = 'T', Source = 'S', Derived = 'D', Chosen = 'C' };

/// A joint, and the link that it carries, whose frame is the joint's.
struct Joint {
  enum class Kind { Revolute, Fixed };

  std::string name;
  Kind kind;
  Pose origin;           ///< of its frame in the frame of the link before, at angle 0
  Eigen::Vector3d axis;  ///< in its own frame, of length 1 but for rounding; turns are right-handed
  double lower, upper;   ///< of the angle about the axis, in degrees; 0 of a fixed joint
  double home;           ///< the commanded angle at home, in degrees; 0 of a fixed joint
};

/// The angle of `joint` about its axis is what is commanded plus `factor` times what is commanded of `leader`: where
/// the two axes are opposite, with 1 what the joint carries is not turned by the leader. Limits are those of the angle.
struct Coupling {
  std::size_t joint, leader;  ///< places in Robot::joints
  double factor;
};

struct Link {
  std::string name;
  std::vector<Part> parts;
};

/// A serial arm. links[0] stands still; joints[i] carries links[i + 1], on links[i].
struct Robot {
  std::string name;
  std::filesystem::path urdf;
  Pose base;  ///< of links[0] in the cell: moved up, not turned
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Coupling> couplings;

  [[nodiscard]] const Link& flange() const { return links.back(); }
};

/// What the flange carries, in its frame.
struct Gripper {
  std::vector<Part> parts;
  Ball sphere;  ///< the virtual sphere that is tested for contact
};

/// A place for a piece of material.
struct Slot {
  std::string name;
  Eigen::Vector3d place;  ///< in the frame of its station: where the middle of the material's underside goes
  Eigen::Vector2d aim;    ///< there, in plan: what the arm faces, and brings its sphere down upon
};

/// The storage or the machine. Its frame has z up, x away from the robot's axis, and its origin at `radius` from that
/// axis, in the direction `home + angle`, `height` above the floor.
struct Station {
  double home;    ///< where the angle is counted from: degrees counter-clockwise from the cell's x
  double angle;   ///< degrees counter-clockwise
  double radius;  ///< > 0
  double height;  ///< >= 0
  std::vector<Slot> slots;
  std::vector<Part> parts;
  /// A column from the floor up to z = `top` in the station's frame: it grows and shrinks with the height.
  struct Stand {
    Eigen::Vector2d lower, upper;
    double top;
  };
  std::optional<Stand> stand;

  [[nodiscard]] double azimuth() const { return home + angle; }
};

/// The stand as a part, in its frame. Requires that there is one.
[[nodiscard]] Solid stand_of(const Station& station);

/// The piece that is moved: its frame's origin, the middle of its underside, goes to the place of a slot; z is up.
struct Material {
  Solid solid;
  std::size_t slot;          ///< of the storage, where it lies at first
  std::size_t machine_slot;  ///< of the machine, where it is taken to
};

struct Cell {
  std::filesystem::path file;
  std::string name;
  workloads::Unit unit;
  Robot robot;
  Gripper gripper;
  Station storage, machine;
  Material material;
  double step;       ///< of every joint, in degrees; > 0
  double clearance;  ///< by which the sphere rises, at least, once it has gripped from above or let go; > 0
  /// By path in the file, such as `storage.radius`. A label holds for all that lies below its path and has no nearer
  /// one.
  std::map<std::string, Label> labels;

  /// The label of the value at a path. Throws std::out_of_range where there is none.
  [[nodiscard]] Label label(const std::string& path) const;
};

}  // namespace touchstone::cell
