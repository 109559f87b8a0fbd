// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "experiments/thesis/cell/kinematics/chain.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// Returns whether nothing touches while all joints turn evenly from some angles to others.
using StretchTest = std::function<bool(const kinematics::Angles& from, const kinematics::Angles& to)>;

/// A way of the arm, by stretches on which all joints turn evenly.
struct Way {
  std::vector<kinematics::Angles> ends;  ///< of the stretches, in order
  bool found = false;                    ///< otherwise all stretches but the last one are free
};

/// Finds a way between two poses: the first one that is free of these.
///
///  1. All joints at the same time; the base first; the base last.
///  2. Lift, turn, lower: with the base as it is to a point that inverse kinematics reaches, at one of some heights
///     from the higher end upwards, then below it, and one of some distances from the base's axis; the base; and on.
/// Each of these to every command of the base within its limits that faces the same direction.
///
/// If none is free, returns the one whose first stretches are the most, and of those the first one tried. Requires that
/// the other pose is within the limits of the joints.
///
/// Guarantees
///  (1) all ends of stretches are within the limits of the joints, and the test has found every stretch free, but
///      perhaps the last one if no way is found;
///  (2) the result is a function of the arm, the two poses and the answers of the test.
///
/// Cost: that of at most about 200 tests.
[[nodiscard]] Way find_way(const Workcell& workcell, const kinematics::Angles& from, const kinematics::Angles& to,
                           const StretchTest& test);

}  // namespace touchstone::cell
