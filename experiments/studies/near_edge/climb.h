// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/studies/near_edge/wrong_reach.h"
#include "experiments/workloads/random.h"

namespace touchstone::near_edge {

inline constexpr int kClimbSteps = 64;

/// A case and how far from its threshold the method is wrong about it.
struct Climbed {
  AtThreshold at;
  WrongReach reach;
};

/// Moves one coordinate at a time of a vertex or the centre, by some doubles or by one of its lower 32 bits, and keeps
/// what is wrong at least as far from the threshold, kClimbSteps times. What is no polygon any more, or has another
/// kind of nearest feature, is not kept. Where the radius is moved, it is set to the new distance; where the foot is,
/// the threshold is looked for anew along the same axis. At the origin shapes hardly change; 10^6 sizes away, where a
/// double is 2^-33 of the size, they do.
///
/// A function of its arguments. Cost: about 10 ms.
[[nodiscard]] Climbed climb(AtThreshold start, const cases::Method& method, workloads::Random random);

}  // namespace touchstone::near_edge
