// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/joint_turn.h"

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace touchstone::cell {

JointTurn::JointTurn(const Arm& arm, const kinematics::Angles& from, std::optional<Moved> joint)
    : arm_(&arm), joint_(joint) {
  if (!joint) return;
  const std::vector<Pose> frames = arm.chain.frames(from);
  on_axis_ = frames[*joint].translation;
  axis_ = frames[*joint].rotation * arm.chain.joints()[*joint].axis;
  if (const auto by = arm.chain.compensating(*joint)) {
    shifted_from_ = *by;
    pivot_ = frames[*by].translation;
    shift_ = from_axis(*pivot_) * kGenerous;
  }
}

JointTurn::Motion JointTurn::motion(std::size_t link) const {
  const auto frame = arm_->links[link].frame;
  if (!joint_ || !frame || *frame < *joint_) return Motion::None;
  return shifted_from_ && *frame >= *shifted_from_ ? Motion::Shifted : Motion::Turned;
}

double JointTurn::moved(Motion motion, const Eigen::Vector3d& center, double radius, double degrees) const {
  if (motion == Motion::None) return 0;
  const double lever = motion == Motion::Shifted ? shift_ : from_axis(center) + radius;
  return lever * degrees * (std::numbers::pi / 180) * kGenerous;
}

}  // namespace touchstone::cell
