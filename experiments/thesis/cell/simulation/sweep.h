// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/simulation/moving_parts.h"
#include "experiments/thesis/cell/simulation/overlap.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// Contacts that a step may have.
struct Allowed {
  bool resting = true;                  ///< held material may rest on what lies wholly below it
  bool sphere = true;                   ///< the sphere may touch anything; else not what stands
  const LyingMaterial* copy = nullptr;  ///< and not this material or virtual copy, if it may touch nothing
};

/// Tests whole moves of the arm for contact of all that moves.
///
/// Tested are: every moving part of the arm and the gripper against the parts that stand, the floor and material that
/// lies in a slot; gripped material against the parts that stand and the floor; and parts of the arm, with what it
/// holds, against each other, unless they touch at home or sit next to each other in the chain; and the sphere, where
/// it may not touch (Allowed). All are triangles that cover the faces, as for Separation.
///
/// Guarantee: if a move has no hindrance, nothing that is tested touches at any angle of the move. The converse does
/// not hold: a hindrance may be a miss by what the parts move in a 64th of a step. Method: first_touch.
class Sweep {
 public:
  /// Requires a workcell that outlives it. With `sphere_alone` nothing else is tested.
  explicit Sweep(const Workcell& workcell, bool sphere_alone = false);

  /// Returns the first hindrance of a move of one joint, by the signed `degrees`, with the material where a transfer
  /// has put it. Adds the number of distances that it measures to `queries`. Cost: 1 to 30 ms.
  [[nodiscard]] std::optional<Hindrance> along(const kinematics::Angles& from, Moved joint, double degrees,
                                               const MaterialTransfer& state, std::uint64_t& queries) const;
  /// Returns the first hindrance of a step. If several joints turn, held material may rest only if its height changes
  /// steadily.
  [[nodiscard]] std::optional<Hindrance> along(const kinematics::Angles& from, const Step& step,
                                               const MaterialTransfer& state, std::uint64_t& queries,
                                               const Allowed& allowed = {}) const;
  /// Returns whether a step has no hindrance. Cost: less than that of finding the first one.
  [[nodiscard]] bool is_clear(const kinematics::Angles& from, const Step& step, const MaterialTransfer& state,
                              std::uint64_t& queries, const Allowed& allowed) const;
  /// Returns what the arm at rest touches, its fixed links against all but the floor.
  [[nodiscard]] std::optional<Hindrance> at_rest(const kinematics::Angles& commanded, const MaterialTransfer& state,
                                                 std::uint64_t& queries) const;

  [[nodiscard]] bool sphere_alone() const { return sphere_alone_; }

 private:
  friend class SweptMove;
  const Workcell* workcell_;
  bool sphere_alone_;
  std::vector<MovingPart> parts_;                           // all but the sphere
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // of parts that are to keep apart
  TriangleTree without_floor_;                              // what stands, for the foot
};

}  // namespace touchstone::cell
