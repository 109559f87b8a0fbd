// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// A turn at the greatest speed that all of its joints allow.
struct Pace {
  double seconds;  ///< of the turn
  double ramp;     ///< seconds in which all of them can come to that speed; 0 if none has a greatest acceleration
};
/// Returns the pace of a turn. A joint that makes up for another turns, too. Empty if the greatest speed of one of them
/// is unknown.
[[nodiscard]] std::optional<Pace> pace_of(const Arm& arm, const Step& step);

/// A way from rest to rest: evenly faster, at the greatest speed, evenly slower (trapezoidal); without the middle part
/// if the way is too short for that speed (triangular). The way is measured by its seconds at the greatest speed.
struct SpeedProfile {
  double way = 0;   ///< >= 0
  double ramp = 0;  ///< seconds from rest to the greatest speed; >= 0

  /// Returns the seconds of the whole way.
  [[nodiscard]] double seconds() const { return 2 * speeding(way / 2); }
  /// Returns after how many seconds a part of the way is done. Requires a part within [0, way].
  [[nodiscard]] double seconds(double part) const;

 private:
  [[nodiscard]] double speeding(double part) const;
};

/// When the arm of a run is where, in seconds since the first stop. Each move goes from rest to rest as fast as its
/// joints allow, all of them by one SpeedProfile, so that they keep to the way that was tested; the arm waits as long
/// as the cell states for gripping, releasing and milling.
///
/// Guarantees, up to rounding
///  (1) times ascend along the run, from stop to stop and between them;
///  (2) a move of one joint by d degrees takes d / v + v / a if d >= v^2 / a, else 2 sqrt(d / a), where v is its
///      greatest speed and a its greatest acceleration; other joints that turn with it may make it longer;
///  (3) no joint exceeds its greatest speed; in a move that is not straight, none exceeds its greatest acceleration;
///  (4) without accelerations and waits a stop is reached after the sum of the paces of all steps before it;
///  (5) cycle() is the sum of the seconds of all moves and of all waits.
/// On a straight move the proportion of the joints changes from stop to stop; what that takes of their accelerations
/// is left out. The arm waits for milling only in a run that continues with the milled piece. A run that ends early has
/// the times up to there.
class Timing {
 public:
  Timing() = default;
  /// Cost: some us per stop.
  Timing(const Workcell& workcell, const Process& process);

  /// Returns when the arm arrives at each stop, where it may wait; empty if the greatest speed of a joint that turns is
  /// unknown.
  [[nodiscard]] const std::vector<double>& arrivals() const { return arrivals_; }
  /// Returns for each stop how long the arm waits there.
  [[nodiscard]] const std::vector<double>& waits() const { return waits_; }
  /// Returns how many seconds a move takes; empty if that is unknown.
  [[nodiscard]] std::optional<double> move(std::size_t number) const;
  /// Returns when the joint of a step has turned by `degrees`, of either sign, of its way from a stop to the next, at 0
  /// when the arm arrives at the stop; empty if that is unknown. At the last stop `degrees` is ignored.
  [[nodiscard]] std::optional<double> after(std::size_t stop, double degrees) const;
  /// Returns the time of all moves and waits; empty if it is unknown, or the run has no stops.
  [[nodiscard]] std::optional<double> cycle() const;
  /// Returns the cycle time and what it assumes, in words.
  [[nodiscard]] std::string text() const;

 private:
  struct MoveTime {
    SpeedProfile profile;
    double begins = 0;
    bool known = true;
  };
  struct Arrival {
    std::size_t move = 0;
    double way = 0;      // since the move began, in seconds at the greatest speed
    double degrees = 0;  // of the step that ends there
  };
  void take_paces(const Arm& arm, const Process& process);
  void take_waits(const Cell& cell, const Process& process);

  std::vector<MoveTime> moves_;
  std::vector<Arrival> stops_;
  std::vector<double> waits_, arrivals_;
  double gripping_ = 0, releasing_ = 0, milling_ = 0;
  bool accelerates_ = false;  // whether a joint of the arm has a greatest acceleration
  bool all_do_ = false;
};

}  // namespace touchstone::cell
