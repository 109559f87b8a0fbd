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

/// What a way came to nothing by.
enum class Hindrance {
  OutOfReach,  ///< the material, of the arm
  JointLimit,
  InTheWay,   ///< the sphere touches what it should not
  NoContact,  ///< the sphere touches nothing where it should, or steps pass over it, or nothing lifts it clear
};

/// From home to the storage, to the machine: what the thesis's case studies show.
struct Rehearsal {
  std::vector<Move> moves;
  std::string failure;                 ///< why neither way came out, naming the moves; then there are no moves
  std::optional<Hindrance> hindrance;  ///< then: of the last way that was tried

  [[nodiscard]] bool complete() const { return !hindrance; }
  /// What a joint was moved by until the sphere first touched the material; and by all moves; in sum.
  [[nodiscard]] int to_storage(AristoJoint joint) const;
  [[nodiscard]] int net(AristoJoint joint) const;
};

/// One rule for every angle, radius and height of the storage: from the side where the shoulder can stay as it is, else
/// from above, else from the side; the first of these that comes out.
///
/// From above: the elbow goes where inverse kinematics has it for the sphere on the upper face, in whole degrees, the
/// base turns to face the storage, the shoulder goes down until the sphere touches, then up until it is clear. From the
/// side: shoulder and elbow go where inverse kinematics has them for half the height of the material, and the base
/// turns towards facing the storage until the sphere touches the side. Then from above at the machine, with what was
/// gripped carried along. No other contact may happen: the whole arc of every move is asked about, by first_contact.
[[nodiscard]] Rehearsal rehearse(const Layout& layout, const Station& storage);

/// What the captions of a case say otherwise than a rehearsal; empty where they agree to the degree.
[[nodiscard]] std::string difference(const Rehearsal& rehearsal, const Captions& captions);

}  // namespace touchstone::kinematics
