// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/random.h"
#include "experiments/studies/near_edge/wrong_reach.h"

namespace touchstone::near_edge {

inline constexpr int kClimbSteps = 64;

/// A case and the distance from its threshold at which the method is wrong about it.
struct Climbed {
  AtThreshold at;
  WrongReach reach;
};

/// Takes kClimbSteps steps. Each step moves one coordinate of a vertex or the centre, by some doubles or by one of its
/// lower 32 bits, and keeps the change if the method is wrong at least as far from the threshold. A change that yields
/// an invalid polygon or another kind of nearest feature is discarded. If the threshold moves the radius, the radius is
/// set to the new distance; if it moves the foot, the threshold is searched again along the same axis. At the origin
/// shapes hardly change; 10^6 sizes away, where a double is 2^-33 of the size, they do.
///
/// A function of its arguments. Cost: about 10 ms.
[[nodiscard]] Climbed climb(AtThreshold start, const cases::Method& method, workloads::Random random);

}  // namespace touchstone::near_edge
