// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "experiments/thesis/cell/simulation/hindrance.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// Returns parts of two things that stand and overlap: whose surfaces touch, or of which one lies in the other; none if
/// none do. A thing is what stands before the slash in the names of its parts, such as a station with what lies in it,
/// or another robot; a thing need not keep apart from itself, nor from the floor.
///
/// A result of nothing proves that no two things touch. The converse holds except for surfaces less than rounding
/// apart. Cost: 1 us per triangle.
[[nodiscard]] std::optional<Hindrance> overlap_of_things(const Workcell& workcell);

}  // namespace touchstone::cell
