// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {

/// How the links of an arm move while one joint turns: not at all, about the joint's axis or, behind a joint that makes
/// up for the turning, along arcs without turning.
class JointTurn {
 public:
  static constexpr double kGenerous = 1 + 1e-9;  ///< more than the roundings of a few lengths add up to

  /// Without a joint the arm is at rest. Requires an arm that outlives it.
  JointTurn(const Arm& arm, const kinematics::Angles& from, std::optional<Moved> joint);

  enum class Motion { None, Turned, Shifted };
  [[nodiscard]] Motion motion(std::size_t link) const;
  /// Returns a length that no point of a ball, which moves so, leaves behind while the joint turns by `degrees`.
  [[nodiscard]] double moved(Motion motion, const Eigen::Vector3d& center, double radius, double degrees) const;

  /// Requires that there is one.
  [[nodiscard]] Moved joint() const { return *joint_; }
  [[nodiscard]] const Eigen::Vector3d& axis() const { return axis_; }
  [[nodiscard]] const Eigen::Vector3d& on_axis() const { return on_axis_; }
  /// A point along whose arc is shifted what is shifted; none if nothing is.
  [[nodiscard]] const std::optional<Eigen::Vector3d>& pivot() const { return pivot_; }

 private:
  [[nodiscard]] double from_axis(const Eigen::Vector3d& point) const { return axis_.cross(point - on_axis_).norm(); }

  const Arm* arm_;
  std::optional<Moved> joint_;
  Eigen::Vector3d on_axis_ = Eigen::Vector3d::Zero(), axis_ = Eigen::Vector3d::UnitZ();
  std::optional<std::size_t> shifted_from_;  // the frames from that of this joint on are shifted, not turned
  std::optional<Eigen::Vector3d> pivot_;
  double shift_ = 0;  // the radius of the arc along which they are
};

/// A part of a turn, between two angles in degrees from the turn's beginning, and lower bounds of the distance of two
/// bodies at these angles.
struct Clearance {
  double begin, at_begin, end, at_end;

  /// Returns a lower bound on the whole part. Requires that the distance changes by at most `rate` per degree.
  [[nodiscard]] double least(double rate) const { return (at_begin + at_end - rate * (end - begin)) / 2; }
};

enum class Next { Done, Halve, Stop };

/// Judges a part of a turn and, where that asks for it, its halves, the earlier one first; each halving calls
/// `measure(middle, part)` for a lower bound in the middle. Returns false if a judgement was to stop.
template <class Judge, class Measure>
bool by_halves(const Clearance& part, const Judge& judge, const Measure& measure) {
  if (const Next next = judge(part); next != Next::Halve) return next == Next::Done;
  const double middle = part.begin + (part.end - part.begin) / 2, there = measure(middle, part);
  return by_halves({part.begin, part.at_begin, middle, there}, judge, measure) &&
         by_halves({middle, there, part.end, part.at_end}, judge, measure);
}

constexpr double kFinest = 1.0 / 64;  ///< of a step: how finely a turn is searched for contact
constexpr double kAhead = 8;          ///< the number of steps that are skipped where a distance allows it

/// Returns the first angle from which on two bodies may touch; none if they do not touch on all of the part. Guarantee:
/// they do not touch at an earlier angle. It may name a miss by `finest` times `rate` and by what the measured bounds
/// are below the distances.
template <class Measure>
std::optional<double> first_touch(const Clearance& part, double rate, double finest, const Measure& measure) {
  std::optional<double> first;
  const auto judge = [&](const Clearance& p) {
    if (p.at_begin > 0 && p.at_end > 0 && p.least(rate) > 0) return Next::Done;
    if (p.at_begin > 0 && p.end - p.begin > finest) return Next::Halve;
    first = p.begin;
    return Next::Stop;
  };
  by_halves(part, judge, measure);
  return first;
}

/// A part of a mover, in the frame of a link.
struct MovingPart {
  Mover mover;
  std::string name;
  std::size_t link;
  TriangleTree triangles;
  double radius;                                     ///< of the sphere; 0 for other parts
  std::optional<std::size_t> finger = {};            ///< its number, if it is one,
  Eigen::Vector3d closes = Eigen::Vector3d::Zero();  ///< and the direction in which it closes

  /// Whether it is there while the material is where a transfer has put it.
  [[nodiscard]] bool is_there(const MaterialTransfer& state) const { return mover != Mover::Held || !state.slot; }
  /// Returns its pose with the arm at these links; a finger is closed as it is there. Requires that it is there.
  [[nodiscard]] Pose pose(const std::vector<Pose>& links, const MaterialTransfer& state) const;
  /// Returns a ball around it at a pose.
  [[nodiscard]] Ball around(const Pose& pose) const;
  /// Returns its distance from triangles that stand, as `distance` of two trees.
  [[nodiscard]] DistanceBounds distance_from(const TriangleTree& still, const Pose& pose, double cutoff) const;
};

/// Returns the moving parts of the arm, the gripper, the material and the virtual sphere; with `foot` also those of the
/// robot's foot, which does not move.
[[nodiscard]] std::vector<MovingPart> moving_parts(const Workcell& workcell, bool foot = false);
/// Returns triangles by their owners.
[[nodiscard]] std::vector<std::vector<NamedTriangle>> by_owner(const std::vector<NamedTriangle>& triangles);

/// A stretch of a run in which the material stays where it is.
struct Stretch {
  std::size_t first, last;  ///< stops
  const MaterialTransfer* state;
};
/// Returns the stretches of a run, which must outlive them; none without a stop.
[[nodiscard]] std::vector<Stretch> stretches_of(const Process& process);

/// Returns a length that no point of a ball around what moves with a link leaves behind on a step. The joints turn at
/// the same time: about each, a point is as far from its axis as it was, or further by what the joints behind move it.
[[nodiscard]] double moved(const Arm& arm, const kinematics::Angles& from, const Step& step, std::size_t link,
                           const Ball& around);

/// The way between two stops.
struct WayBetween {
  Step step;
  std::vector<double> moved;  ///< that no point of a part moves further, by part; 0 for what is not there
};
[[nodiscard]] WayBetween way_between(const Arm& arm, const std::vector<MovingPart>& parts, const Stop& from,
                                     const Stop& to, const std::vector<Pose>& links, const MaterialTransfer& state);

}  // namespace touchstone::cell
