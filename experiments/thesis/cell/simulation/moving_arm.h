// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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
  Driver(const Workcell& workcell, const cases::Method& method);

  /// Returns the lowest face of the material in a slot, or of its virtual copy, for which the method says contact.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball, StationSlot slot, bool virtual_copy) const;

 private:
  std::array<std::vector<std::unique_ptr<cases::PreparedMethod>>, 4> faces_;  // by slot, real then virtual
};

/// An arm that moves one joint after the other, by whole steps, and records its moves and stops. A move that Process
/// does not allow throws SimulationFailure and leaves the reason in `process.stuck`.
class MovingArm {
 public:
  /// Without a sweep the sphere alone is tested; without a driver the exact answer says when it touches. All must
  /// outlive it.
  MovingArm(const Workcell& workcell, const Sweep* sweep, const Driver* driver);

  /// Records the arm at home. Fails if it touches something there.
  void start();
  void begin(Phase phase) { phase_ = phase; }

  /// Whether it has made more moves than another, or as many and more stops.
  [[nodiscard]] bool went_further_than(const MovingArm& other) const;
  /// Whether the method that drives has stopped it wrongly.
  [[nodiscard]] bool was_misled() const;

  Process process;

 protected:
  [[noreturn]] void fail(FailureCause cause, const std::string& reason);
  /// The same, for parts that touch with a joint turned so far from where it is.
  [[noreturn]] void fail_at(const std::string& reason, Moved joint, double degrees, std::vector<std::string> parts);

  /// Whether the sphere would find the virtual material in a slot, not the material itself.
  [[nodiscard]] bool is_virtual(StationSlot slot) const { return process.transfers.back().slot != slot; }

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
  /// Makes an obstacle again of what was let go.
  void left_behind();

  const Workcell* workcell_;
  const Sweep* sweep_;
  const Driver* driver_;
  const Arm* arm_;
  double step_;
  kinematics::Angles angles_;
  Phase phase_ = Phase::ToStorage;
  std::optional<StationSlot> target_;  // what the sphere comes for or leaves
  bool leaving_ = false;

 private:
  [[nodiscard]] const scene::Faces& faces_of(StationSlot slot) const;
  [[nodiscard]] std::string what(Moved joint, double degrees) const;
  [[nodiscard]] double degrees(long steps) const { return static_cast<double>(steps) * step_; }
  [[nodiscard]] kinematics::Arc arc(Moved joint, double degrees);
  [[nodiscard]] Workcell::Material obstacle() const;
  [[nodiscard]] Sweep::Load load() const;
  void require_free_arc(Moved joint, double degrees, Workcell::Material material);
  void require_free_matter(Moved joint, long steps);
  [[nodiscard]] std::optional<std::size_t> believed(const Ball& sphere) const;
  [[nodiscard]] long driven_steps(Moved joint, long most);
  bool stop();
  void turn(Moved joint, long from, long steps);

  std::vector<long> turned_;  // from home, in steps
};

}  // namespace touchstone::cell
