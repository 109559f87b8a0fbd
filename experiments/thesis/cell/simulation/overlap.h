// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// A contact that should not be: the angle up to which a move is clear, what touches then, in words, and the names of
/// the parts, as in ModelPart or as Workcell::scene names the material.
struct Hindrance {
  double degrees;
  std::string what;
  std::vector<std::string> parts;
};

/// Returns parts of two things that stand and overlap: whose surfaces touch, or of which one lies in the other; none if
/// none do. A thing is what stands before the slash in the names of its parts, such as a station with what lies in it,
/// or another robot; a thing need not keep apart from itself, nor from the floor.
///
/// A result of nothing proves that no two things touch. The converse holds except for surfaces less than rounding
/// apart. Cost: 1 us per triangle.
[[nodiscard]] std::optional<Hindrance> overlap_of_things(const Workcell& workcell);

/// Returns a part that stands and a part of the robot at home, its gripper included, of which one lies in the other;
/// none if none do. Where surfaces touch neither at home nor on a move, none comes into another later.
///
/// Requires that they do not touch at home. Cost: 1 us per triangle and part.
[[nodiscard]] std::optional<Hindrance> nested_at_home(const Workcell& workcell);

}  // namespace touchstone::cell
