// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {

/// The least distance of a mover from an element along the run.
struct LeastDistance {
  Mover mover;
  std::string element;    ///< a part that stands, the floor, or the material in a slot, as Workcell::scene names them
  std::string part;       ///< of the mover, at the upper bound
  DistanceBounds bounds;  ///< `lower` holds at every angle of every move; `upper` is attained
  std::size_t stop;       ///< where it is attained: after this stop,
  double degrees;         ///< and the joint's way from there to the next one
};

/// The distance of a mover from the nearest element.
struct NearestElement {
  DistanceBounds bounds;  ///< `lower` holds on the whole way from the stop before; `upper` is attained on it
  double here;            ///< attained at the stop itself
  std::size_t element;    ///< the nearest one there, an index of Separation::elements
};

struct Separation {
  std::vector<std::string> elements;
  std::vector<LeastDistance> least;  ///< of every mover that is ever there, and every element that ever is
  /// By Mover, then for each stop; empty where nothing is held.
  std::array<std::vector<std::optional<NearestElement>>, kMovers.size()> nearest;
  double tolerance;  ///< bounds of `least` differ by at most this
};

/// Computes how near everything that moves comes to everything that stands, on the whole run.
///
/// Distances are those of triangles that cover the faces. The material in a slot is an element while it lies there, the
/// held material a mover while it is held; what touches as planned has the distance 0: the sphere at a contact, held
/// material in the slot where it rests. The foot of the robot does not move and is left out.
///
/// Guarantees
///  (1) at no angle of any move is a mover nearer to an element than `lower`;
///  (2) at the named angle, its distance is `upper`, up to 1e-12 of the arm's reach;
///  (3) for `least` the two differ by at most `tolerance`, a 5,000th of the arm's reach; for `nearest` by at most that
///      or a tenth, whichever is more.
/// Method: distances at every stop, skipped while the last one less the way since then suffices; between stops, halving
/// with the greatest way of any point of a part as the constant of Lipschitz, and with heights, which a turn of the
/// base does not change. Cost: 0.3 to 0.5 s for the default cell.
[[nodiscard]] Separation separation_of(const Workcell& workcell, const Process& process);

}  // namespace touchstone::cell
