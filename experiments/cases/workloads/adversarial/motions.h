// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/cases/workloads/adversarial/case.h"
#include "geometry/shapes/motion.h"

namespace touchstone::adversarial {

/// Draws how the ball of case `index` moves: a function of (seed, index) alone, which `find_fault` accepts.
///
/// The ball's place is at the start, in the middle or at the end of its way. The way is parallel to an edge or to an
/// axis, leads towards a vertex or past it at a right angle, through the face, in any direction, far away, or nowhere.
/// In a quarter of the draws the radius is the one that just grazes, up to a double, instead of that at the place.
[[nodiscard]] Motion draw_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::adversarial
