// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/studies/soak/system_under_test.h"
#include "experiments/studies/soak/tally.h"

namespace touchstone::soak {

/// Asks the system under test about case `index` and adds the result to the tally.
///
/// Every case: contact with the polygon, prepared, with and without counts and vector instructions; with a triangle
/// also unprepared, and in a batch of all orders of its vertices. One case in 16: every question and the whole answer,
/// the closest point of a triangle, and a batch of balls of neighbouring radii. Compares all answers with `exact`; an
/// exception counts as a difference.
void compare(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally);

/// Asks about the ball of case `index` as it moves: contact and first contact with the polygon, prepared, with and
/// without counts and vector instructions; with a triangle also unprepared; and in batches, backwards and at rest.
void compare_moving(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally);

}  // namespace touchstone::soak
