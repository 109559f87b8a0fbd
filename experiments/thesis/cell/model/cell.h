// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "experiments/cases/workloads/unit.h"
#include "experiments/thesis/cell/model/solid.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// A virtual object: an invisible face, box, sphere or capsule that takes no room, and notices what comes into it.
struct Zone {
  struct Face {
    std::vector<Eigen::Vector3d> corners;  ///< of a convex polygon, in order; a fan of triangles
  };
  /// All points within a radius of a segment, which is a point for a sphere.
  struct Capsule {
    Eigen::Vector3d from, to;
    double radius;
  };

  std::string name;
  std::variant<Face, Eigen::AlignedBox3d, Capsule> shape;
  Pose pose = {};      ///< in the cell
  bool stops = false;  ///< whether the robot stops when something comes into it
};

}  // namespace touchstone::cell

/// The virtual manufacturing cell: the checked contents of a cell file, in plain structures.
///
/// All lengths have one unit (`Cell::unit`), angles are in degrees. In the cell's frame z points up, the floor is z =
/// 0, the origin lies on the axis of the robot's first joint, and the arm points along x at home. Angles in the plan
/// are counter-clockwise as seen from above. Parts of the robot are given in the frame of their link.
namespace touchstone::cell {

/// The origin of a value: the thesis's text, another public source, arithmetic on these, or chosen, because no public
/// source gives it.
enum class Label { Text = 'T', Source = 'S', Derived = 'D', Chosen = 'C' };

/// A joint, and the link that it carries, whose frame is the joint's.
struct Joint {
  enum class Kind { Revolute, Fixed, Prismatic };  ///< Prismatic in a URDF only: in a cell such a joint is fixed

  std::string name;
  Kind kind;
  Pose origin;              ///< of its frame in the frame of the previous link, at angle 0
  Eigen::Vector3d axis;     ///< in its own frame, of length 1 up to rounding; turns are right-handed
  double lower, upper;      ///< of the angle about the axis, in degrees, or of a way along it; 0 for a fixed joint
  double home;              ///< the commanded angle at home, in degrees; 0 for a fixed joint
  double speed = 0;         ///< the greatest, in degrees per second; 0 if unknown
  double acceleration = 0;  ///< the greatest, in degrees per second squared; 0 if it has its speed at once
  bool mimics = false;      ///< whether the URDF couples it to another: it has no command of its own but `home`
};

/// A coupling of two joints: the angle of `joint` about its axis is its command plus `factor` times the command of
/// `leader`. If the two axes are opposite and the factor is 1, or they are the same and it is -1, the leader does not
/// turn the links that the joint carries. A joint may follow several leaders. Limits apply to the angle.
struct Coupling {
  std::size_t joint, leader;  ///< places in Robot::joints
  double factor;
};

/// Returns the label of the value at a path. Throws std::out_of_range if it has none.
[[nodiscard]] Label label_of(const std::map<std::string, Label>& labels, const std::string& path);

struct Link {
  std::string name;
  std::vector<Part> parts;
};

/// A serial arm. links[0] is fixed; joints[i] carries links[i + 1] and is mounted on links[i].
struct Robot {
  std::string name;           ///< of the URDF
  std::string key = "robot";  ///< its path in the file
  std::filesystem::path urdf;
  Pose base;  ///< of links[0] in the cell: moved up, not turned
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Coupling> couplings;
  std::vector<std::string> warnings = {};  ///< what of the URDF is left out, or taken otherwise than it is written

  [[nodiscard]] const Link& flange() const { return links.back(); }
};

/// Returns the angle of a joint about its axis at home: its command and what it takes from those that it follows.
[[nodiscard]] double angle_at_home(const Robot& robot, std::size_t joint);
/// Returns the pose of every link at home, in the robot's frame.
[[nodiscard]] std::vector<Pose> home_poses(const Robot& robot);

/// The gripper, in the frame of the flange that carries it.
struct Gripper {
  std::vector<Part> parts;
  Ball sphere;  ///< the virtual sphere that is tested for contact

  /// Two prismatic joints, each with a part: the first closes along a direction, the second against it.
  struct Fingers {
    std::array<Part, 2> parts;  ///< as they are when the gripper is open
    Eigen::Vector3d along;      ///< of length 1
    double stroke;              ///< of each; > 0

    /// Returns by how much a finger is shifted once it has closed by a way.
    [[nodiscard]] Eigen::Vector3d shift(std::size_t finger, double way) const {
      return finger == 0 ? Eigen::Vector3d(way * along) : Eigen::Vector3d(-way * along);
    }
  };
  std::optional<Fingers> fingers;                ///< if none, whatever the sphere touches sticks to the gripper
  double grip_seconds = 0, release_seconds = 0;  ///< that it takes
};

/// Returns the parts of an open gripper, its fingers last.
[[nodiscard]] std::vector<Part> parts_of(const Gripper& gripper);

/// A place for a piece of material.
struct Slot {
  std::string name;
  Eigen::Vector3d place;  ///< in the frame of its station: the place of the middle of the material's underside
  Eigen::Vector2d aim;    ///< in that frame, in plan: the point that the arm faces, and onto which it lowers its sphere
};

/// The storage or the machine. Its frame has z up, x away from the robot's axis unless it is turned, and its origin at
/// `radius` from that axis, in the direction `home + angle`, `height` above the floor.
struct Station {
  double home;    ///< the zero of the angle: degrees counter-clockwise from the cell's x
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
  double turn = 0;        ///< of its frame, counter-clockwise, from where x points away from the robot's axis
  std::string name = {};  ///< of its parts' names: `storage` in `storage/deck`
  std::string key = {};   ///< its path in the file: `storage`, `machines[1]`

  [[nodiscard]] double azimuth() const { return home + angle; }
};

/// Returns the pose of the station's frame in the cell.
[[nodiscard]] Pose pose_of(const Station& station);
/// Returns a direction of the station's plan as it is seen with x away from the robot's axis.
[[nodiscard]] Eigen::Vector2d turned(const Station& station, const Eigen::Vector2d& direction);
/// Returns a point of the station's plan in the same way, from the robot's axis.
[[nodiscard]] Eigen::Vector2d in_plan(const Station& station, const Eigen::Vector2d& point);
/// Returns the stand as a part, in the frame of the station. Requires a station with a stand.
[[nodiscard]] Solid stand_of(const Station& station);

/// The piece that is moved. The origin of its frame is the middle of its underside and is put at the place of a slot; z
/// is up.
struct Material {
  Solid solid;
  std::size_t slot;          ///< of the storage, where it lies initially
  std::size_t machine_slot;  ///< of the machine, its destination
  double drop = 0;  ///< >= 0: the virtual material, onto which the sphere is lowered, is so far above the place itself

  /// How far from its place, and how many degrees turned, it may be when the gripper lets go.
  struct Tolerance {
    double distance, degrees;
  };
  std::optional<Tolerance> tolerance;  ///< if none, it may be anywhere
  double milling_seconds = 0;          ///< that the machine takes for it
};

/// One robot, the piece of material that it handles, and everything that stands about it, in the robot's frame. A cell
/// file with several robots or pieces is read as several of these (plant.h).
struct Cell {
  std::filesystem::path file;
  std::string name;
  workloads::Unit unit;
  Robot robot;
  Gripper gripper;
  Station storage, machine;
  Material material;
  /// All else that stands: obstacles, other stations, other robots at home, other pieces. What is before a slash in a
  /// name is one thing.
  std::vector<Part> obstacles = {};
  std::vector<Zone> zones = {};
  double step;       ///< of every joint, in degrees; > 0
  double clearance;  ///< the least rise of the sphere after gripping from above or letting go; > 0
  /// Labels by path in the file, such as `storage.radius`. A label applies to all values below its path that have no
  /// nearer one.
  std::map<std::string, Label> labels;

  [[nodiscard]] Label label(const std::string& path) const { return label_of(labels, path); }
};

}  // namespace touchstone::cell
