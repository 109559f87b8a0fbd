// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "geometry/shapes/pose.h"

namespace touchstone::kinematics {

/// Where the links of an arm point, in degrees: the first leans forward from the vertical, the second is elevated above
/// the horizontal.
struct LinkAngles {
  double lean, elevation;
};

/// A point of the arm's plane: away from the shoulder, and above it.
struct Reach {
  double out, up;
};

/// Two links in a vertical plane.
struct TwoLinks {
  double first, second;  ///< lengths

  [[nodiscard]] Reach reach(const LinkAngles& angles) const;
  /// The angles that reach a point: none where it is too far or too near, else those with the elbow above the line to
  /// the point, then those with it below; one where the links are in line. Requires links that are not both 0.
  /// The law of cosines; near the ends of the reach the angles lose half of their digits.
  [[nodiscard]] std::vector<LinkAngles> inverse(const Reach& point) const;
};

/// A revolute joint of a serial arm. Its frame is at `origin` in the frame of the previous joint (for the first joint,
/// of the base), and turns about an axis through its own origin.
struct Joint {
  std::string name;
  Pose origin;             ///< at angle 0
  Eigen::Vector3d axis;    ///< in its own frame, of length 1; turns are right-handed
  double lowest, highest;  ///< limits in degrees, both included
};

/// A row of a Denavit-Hartenberg table: turn by theta about z, move by d along z and by a along the new x, turn by
/// alpha about that. In degrees and the arm's unit of length.
struct DenavitHartenberg {
  double alpha, a, d;
  double theta;  ///< at joint angle 0
};
/// Returns the pose of a row's link at its theta.
[[nodiscard]] Pose link_of(const DenavitHartenberg& row);

/// Commanded angles, one per joint, in degrees.
using Angles = std::vector<double>;

/// Two joints of a chain: the turning of `driver` is undone by `joint`, as parallel bars or belts do. The links after
/// `joint` are shifted by the driver but not turned.
struct Compensation {
  std::size_t driver, joint;
};

/// A serial chain of revolute joints, each turned by its commanded angle. A joint may also turn back by the commands of
/// joints before it (Compensation).
class Chain {
 public:
  /// `flange` is the flange's frame in the frame of the last joint; `rest` holds the commands at which joints between a
  /// driver and its compensating joint stay, all 0 if it is empty. Throws std::invalid_argument, which names the joint,
  /// for a number that is not finite, an axis that is not of length 1 (within 1e-12), crossed limits, a driver that two
  /// joints compensate, and a compensation by a joint that does not come later or whose axis, with the joints at rest,
  /// is not parallel to the driver's (within 1e-12).
  Chain(std::vector<Joint> joints, Pose flange, const std::vector<Compensation>& compensations = {},
        const Angles& rest = {});

  [[nodiscard]] const std::vector<Joint>& joints() const& { return joints_; }
  void joints() && = delete;  // a reference into a chain that is gone

  /// Returns the joint that compensates a driver, if any.
  [[nodiscard]] std::optional<std::size_t> compensating(std::size_t driver) const {
    return by_driver_.at(driver).joint;
  }
  /// Returns the angle by which each joint turns: its command plus what it compensates. Throws
  /// std::invalid_argument unless there is one angle per joint.
  [[nodiscard]] Angles turns(const Angles& commanded) const;
  /// Throws std::out_of_range, which names the joint and its limits, if a joint turns beyond them or by a NaN; also
  /// throws as above.
  void require_reachable(const Angles& commanded) const;

  /// Returns by how many degrees a joint's command can rise or fall until the joint or the one that compensates it is
  /// at a limit; negative beyond a limit. Throws as turns does.
  [[nodiscard]] double room(const Angles& commanded, std::size_t joint, bool up) const;

  /// Returns the frames of the joints, then that of the flange, all in the frame of the base. In doubles, off by some
  /// 1e-15 of the arm's length; the same bits on every machine. Ignores limits. Throws as turns does.
  [[nodiscard]] std::vector<Pose> frames(const Angles& commanded) const;
  /// Returns the position of a point of the flange's frame.
  [[nodiscard]] Eigen::Vector3d place(const Angles& commanded, const Eigen::Vector3d& point) const;

  /// Returns the path of a point of the flange's frame while one joint moves by `move` degrees: an arc about that
  /// joint's axis or, for a driver, about a parallel axis. Requires that joints between a driver and its compensating
  /// joint are at rest or parallel to both. Throws std::out_of_range if the move begins or ends beyond a limit,
  /// std::invalid_argument for a move of more than 360 degrees.
  [[nodiscard]] Arc arc(const Angles& commanded, std::size_t joint, double move, const Eigen::Vector3d& point) const;

 private:
  std::vector<Joint> joints_;
  Pose flange_;
  struct ByDriver {
    std::optional<std::size_t> joint;
    double factor = 0;  // of the driver's command, in the angle of the joint
  };
  std::vector<ByDriver> by_driver_;
};

}  // namespace touchstone::kinematics
