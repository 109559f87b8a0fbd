// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/sweep.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// A method that is asked about every face of the material, real or virtual, at a stop, as the exact answer is.
class Driver {
 public:
  explicit Driver(const cases::Method& method) : method_(method) {}

  /// Returns the lowest face of the material, or of a virtual copy, for which the method says contact.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball, const Lying& material) const;

 private:
  const cases::Method& method_;
  mutable std::map<Lying, std::vector<std::unique_ptr<cases::PreparedMethod>>> faces_;
};

/// An arm that moves one joint after the other, by whole steps, or by a way that is found, and records its moves and
/// stops. A move that Process does not allow throws SimulationFailure and leaves the reason in `process.stuck`.
class MovingArm {
 public:
  /// Without a driver the exact answer says when the sphere touches. All must outlive it.
  MovingArm(const Workcell& workcell, const Sweep& sweep, const Driver* driver);

  /// Records the arm at home. Fails if it touches something there.
  void start();
  void begin(Phase phase) { phase_ = phase; }

  /// Whether it has handed the material over more often than another; else, whether it is in a later phase; else has
  /// made more moves; else more stops.
  [[nodiscard]] bool went_further_than(const MovingArm& other) const;
  /// Whether it is to move by whole steps of one joint only, except for straight down and back; not so once it has
  /// found a way.
  [[nodiscard]] bool in_order() const { return in_order_; }
  void leave_order() { in_order_ = false; }
  /// Whether the method that drives has stopped it wrongly.
  [[nodiscard]] bool was_misled() const;

  Process process;

 protected:
  [[noreturn]] void fail(FailureCause cause, const std::string& reason);
  /// The same, for parts that touch with a joint turned so far from where it is.
  [[noreturn]] void fail_at(const std::string& reason, Moved joint, double degrees, std::vector<std::string> parts);

  /// Returns where the material is.
  [[nodiscard]] const MaterialTransfer& state() const { return process.transfers.back(); }
  /// Returns what the sphere finds in a slot: the material, or its virtual copy.
  [[nodiscard]] const Lying& found_in(StationSlot slot) const {
    return is_virtual(slot) ? workcell_->at(slot).copy : state().lies;
  }
  /// Whether the sphere would find the virtual material in a slot, not the material itself.
  [[nodiscard]] bool is_virtual(StationSlot slot) const { return state().slot != slot; }

  /// The whole number of steps that is nearest to a command.
  [[nodiscard]] long steps_to(Moved joint, double command) const;
  void move_to(Moved joint, double command);
  void turn_base(double command, Until until);
  /// A whole move, which meets nothing: not even what it comes for, virtual or not. `exact`: before rounding to steps.
  void go(Moved joint, Until until, long steps, double exact);
  /// Up or down, by at most half a turn, until the sphere touches the target.
  void move_until_contact(Moved joint, bool up);
  /// The same, by at most `most` steps.
  void move_until_contact(Moved joint, long most);
  /// Straight up or down by way of these angles; the last ones are exactly where it ends.
  void go_straight(Until until, double rise, const std::vector<kinematics::Angles>& way);
  /// To a pose within the limits of the joints, by a way that is found.
  void find_to(const kinematics::Angles& to);
  /// Makes an obstacle again of what was let go.
  void left_behind();

  const Workcell* workcell_;
  const Sweep* sweep_;
  bool matter_;  // whether more than the sphere is tested
  const Driver* driver_;
  const Arm* arm_;
  double step_;
  kinematics::Angles angles_;
  Phase phase_ = Phase::ToStorage;
  std::optional<StationSlot> target_;  // what the sphere comes for or leaves
  bool leaving_ = false;

 private:
  [[nodiscard]] std::string what(Moved joint, double degrees) const;
  [[nodiscard]] double degrees(long steps) const { return static_cast<double>(steps) * step_; }
  [[nodiscard]] kinematics::Arc arc(Moved joint, double degrees);
  [[nodiscard]] bool is_obstacle() const;
  [[nodiscard]] Lying kept_from() const;
  void require_free_arc(Moved joint, double degrees, const Lying& material);
  void require_free_matter(Moved joint, long steps);
  [[nodiscard]] std::optional<std::size_t> believed(const Ball& sphere) const;
  [[nodiscard]] long driven_steps(Moved joint, long most);
  bool stop();
  void turn(Moved joint, long from, long steps);

  kinematics::Angles counted_from_;
  std::vector<long> turned_;  // from there, in steps
  bool in_order_ = true;
};

}  // namespace touchstone::cell
