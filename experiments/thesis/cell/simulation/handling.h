// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "experiments/thesis/cell/simulation/moving_arm.h"

namespace touchstone::cell {

/// Whether the base or the elbow moves first.
enum class Order { ElbowFirst, BaseFirst };

/// A robot that handles the material in moves of one joint. Process says which rules these follow.
class Handling : public MovingArm {
 public:
  using MovingArm::MovingArm;

  /// Until the sphere touches the material there, or its virtual copy.
  void come_upon(StationSlot slot, Approach approach, Order order);
  /// Onto the material there, or its virtual copy, by the elbow, once the base faces it and the shoulder is as planned.
  void come_down_by_elbow(StationSlot slot);
  /// By the shoulder, onto the material at the machine.
  void come_down_again();

  void grip();
  void release(StationSlot slot);

  /// By one joint, until the sphere has risen by the clearance.
  void lift(Moved joint);
  /// Up to the height at which the material was carried to the machine: the shoulder as at home, the elbow as there.
  void raise();
  /// The joints in that order.
  void go_home(const std::array<Moved, 3>& order);

  /// Whether it has come from above to where it is.
  [[nodiscard]] bool is_above() const { return above_; }

 private:
  [[nodiscard]] double sense() const { return workcell_->plane().base(1) - workcell_->plane().base(0); }
  [[nodiscard]] bool clockwise(double target) const { return (target - angles_[kBase]) * sense() < 0; }
  [[nodiscard]] double drop(const Workplace& at) const { return is_virtual(*target_) ? at.drop : 0; }
  [[nodiscard]] double nearest_base(double azimuth) const;
  void turn_near(const Workplace& at);
  void face(const Workplace& at);
  [[nodiscard]] PlanarArm::Commands commands_above(const Workplace& at);
  void come_down(const Workplace& at);
  void go_down() { move_until_contact(kShoulder, shoulder_down_ > angles_[kShoulder]); }
  bool lift_by(Moved joint);

  bool above_ = false;
  double carried_at_ = 0;     // the elbow's command on the way to the place last come down upon
  double shoulder_down_ = 0;  // the command that inverse kinematics has for the upper face
};

}  // namespace touchstone::cell
