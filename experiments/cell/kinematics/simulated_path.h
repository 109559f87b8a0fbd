// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/first_contact/first_contact.h"
#include "experiments/cell/kinematics/layout.h"
#include "experiments/cell/kinematics/simulation_terms.h"

namespace touchstone::kinematics {

/// One completed move of one joint, in steps of 1 degree.
struct Move {
  AristoJoint joint;
  Until until;
  int degrees;                          ///< moved, relative to where the joint was
  double exact;                         ///< the angle before rounding to whole degrees
  std::optional<FirstContact> contact;  ///< certified; for Until::Contact and for a base that meets the material
  double margin;  ///< degrees by which `exact` may change before `degrees` does; 1 if nothing is rounded
};

/// The path from home to the storage and to the machine, as in the thesis's case studies.
struct SimulatedPath {
  std::vector<Move> moves;
  std::string failure;  ///< why no approach succeeded, naming the moves; then there are no moves
  /// Set in that case: the cause of the last approach. NoContact also if no lift clears the material.
  std::optional<FailureCause> cause;

  [[nodiscard]] bool complete() const { return !cause; }
  /// Return the sum of a joint's moves until the sphere first touched the material, and the sum of all its moves.
  [[nodiscard]] int to_storage(AristoJoint joint) const;
  [[nodiscard]] int net(AristoJoint joint) const;
};

/// Simulates the path for any angle, radius and height of the storage by one rule: takes the first of these approaches
/// that succeeds: from the side without moving the shoulder, from above, from the side.
///
/// From above: the elbow moves to the angle that inverse kinematics gives for the sphere on the upper face, in whole
/// degrees, the base turns to face the storage, the shoulder moves down until the sphere touches, then up until it is
/// clear. From the side: shoulder and elbow move to the angles that inverse kinematics gives for half the height of the
/// material, and the base turns towards the storage until the sphere touches the side. The machine is then approached
/// from above, carrying the gripped material. No other contact may happen: first_contact checks the whole arc of every
/// move.
[[nodiscard]] SimulatedPath simulate(const Layout& layout, const Station& storage);

/// Returns how the captions of a case differ from a simulated path; empty if they agree to the degree.
[[nodiscard]] std::string difference(const SimulatedPath& path, const Captions& captions);

}  // namespace touchstone::kinematics
