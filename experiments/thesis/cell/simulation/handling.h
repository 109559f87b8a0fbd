// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "experiments/thesis/cell/simulation/moving_arm.h"

namespace touchstone::cell {

/// A robot that handles the material, in moves of one joint or by ways that it finds. Process says by which rules.
class Handling : public MovingArm {
 public:
  using MovingArm::MovingArm;

  /// Until the sphere touches the material there, or its virtual copy, in moves of one joint.
  void come_upon(StationSlot slot, Approach approach);
  /// Onto the material there, or its virtual copy, by the elbow, once the base faces it and the shoulder is as planned.
  void come_down_by_elbow(StationSlot slot);
  /// By the shoulder, onto the material at the machine.
  void come_down_again();
  /// By a way that is found, to above the material there, or its virtual copy.
  void find_to_above(StationSlot slot);
  /// Straight down, until the sphere touches what it is above.
  void come_straight_down(StationSlot slot);
  /// Straight up by a share of the clearance.
  void go_straight_up(double share);
  /// By a way that is found.
  void find_home() { find_to(arm_->home); }

  void grip();
  void release(StationSlot slot);

  /// By one joint, until the sphere has risen by the clearance.
  void lift(Moved joint);
  /// The shoulder to where it is at home.
  void raise();
  /// The joints in that order.
  void go_home(const std::array<Moved, 3>& order);

  /// Whether it has come from above to where it is.
  [[nodiscard]] bool is_above() const { return above_; }

 private:
  [[nodiscard]] double sense() const { return workcell_->plane().base(1) - workcell_->plane().base(0); }
  [[nodiscard]] bool clockwise(double target) const { return (target - angles_[kBase]) * sense() < 0; }
  [[nodiscard]] double drop(const Workplace& at) const { return is_virtual(*target_) ? at.drop : 0; }
  [[nodiscard]] double nearest_base(double direction) const;
  [[nodiscard]] double height_above(const Workplace& at) const;
  void face(const Workplace& at);
  [[nodiscard]] PlanarArm::Commands commands_above(const Workplace& at);
  void come_down(const Workplace& at);
  void go_down() { move_until_contact(kShoulder, shoulder_down_ > angles_[kShoulder]); }
  bool lift_by(Moved joint);
  void require_free_fingers(const Grip& grip, const char* what);
  [[nodiscard]] std::vector<kinematics::Angles> angles_up(double rise);
  Landing land();

  bool above_ = false;
  double shoulder_down_ = 0;  // the command that inverse kinematics has for the upper face
};

}  // namespace touchstone::cell
