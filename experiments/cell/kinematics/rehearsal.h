// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/first_contact/first_contact.h"
#include "experiments/cell/kinematics/layout.h"

namespace touchstone::kinematics {

/// How far a joint is moved.
enum class Until {
  Planned,  ///< by the whole number of degrees nearest to what inverse kinematics gives
  Facing,   ///< until the base faces a station, which takes a whole number of degrees here
  Contact,  ///< by steps of 1 degree until the sphere touches the material it comes for
  Cleared,  ///< by steps of 1 degree until the sphere has risen by the clearance
};
[[nodiscard]] std::string_view word(Until until);

/// One move of one joint, as it came out.
struct Move {
  AristoJoint joint;
  Until until;
  int degrees;                          ///< moved, relative to where the joint was
  double exact;                         ///< what was not rounded to whole degrees
  std::optional<FirstContact> contact;  ///< of Until::Contact and of a base that comes upon the material, certified
  double margin;  ///< degrees that `exact` may change by before `degrees` does; 1 where nothing is rounded
};

/// From home to the storage, to the machine: what the thesis's case studies show.
struct Rehearsal {
  std::vector<Move> moves;
  std::string failure;  ///< why it ended early: it names the move; empty where it did not

  [[nodiscard]] bool complete() const { return failure.empty(); }
  /// What a joint was moved by from the first of the moves to the last but `but_last`, in sum.
  [[nodiscard]] int net(AristoJoint joint) const;
};

/// The rule that is followed, whatever the storage's angle, radius and height:
/// the arm is to touch the near side of the material at half its height where that takes no move of the shoulder, else
/// its upper face; inverse kinematics gives the elbow, in whole degrees; the base turns to face the storage, or until
/// the sphere touches the side; the shoulder goes down until it touches the upper face, and then up until it is clear.
/// Then the same from above at the machine, the sphere carrying its material. No other contact may happen: every
/// move's whole arc is asked about, by first_contact.
[[nodiscard]] Rehearsal rehearse(const Layout& layout, const Station& storage);

/// What the captions of a case say otherwise than a rehearsal; empty where they agree to the degree.
[[nodiscard]] std::string difference(const Rehearsal& rehearsal, const Captions& captions);

}  // namespace touchstone::kinematics
