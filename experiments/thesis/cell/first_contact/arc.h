// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace touchstone::kinematics {

/// The path of a point that one joint turns: the angles from 0 to `degrees` about a line.
///
/// All numbers are exact. With v = start - point, |axis| = the exact length of the axis, which need not be 1, and phi
/// an angle, the point of the arc is
///   point + (v.axis) axis / |axis|^2 + cos(phi) (v - (v.axis) axis / |axis|^2) + sin(phi) (axis x v) / |axis|:
/// right-handed about the axis. An arc of radius 0 is a point at rest.
struct Arc {
  Eigen::Vector3d start;  ///< the moving point at angle 0
  Eigen::Vector3d point;  ///< any point of the line
  Eigen::Vector3d axis;   ///< the direction of the line; not 0
  double degrees;         ///< the whole move, 0 to 360
};

/// Throws std::invalid_argument, which names the fault, for a number that is not finite, an axis of length 0, or a move
/// outside [0, 360].
void require_valid(const Arc& arc);

/// Returns the direction of a vector as a vector of length 1, off by some units in the last place, for every finite
/// vector but 0, however long or short: it is multiplied by a power of two first. Vectors that differ by a power of two
/// only have the same direction, bit by bit.
[[nodiscard]] Eigen::Vector3d direction_of(const Eigen::Vector3d& v);

/// Returns the point at an angle in degrees, in doubles: off by a few units in the last place of the largest coordinate
/// of start and point. At angle 0 it is the start itself. The bits are the same on every machine. Cost: some
/// microseconds.
[[nodiscard]] Eigen::Vector3d point_at(const Arc& arc, double degrees);

}  // namespace touchstone::kinematics
