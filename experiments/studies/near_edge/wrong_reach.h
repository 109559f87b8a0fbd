// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "experiments/cases/comparison.h"
#include "experiments/cases/threshold.h"

namespace touchstone::near_edge {

using cases::Test;

/// A ball at a threshold, exactly except for rounding, and the direction in which it is moved.
struct AtThreshold {
  Polygon polygon;
  Ball ball;       ///< radius: the double nearest to the distance; foot: the last centre whose foot is not outside
  int moved_axis;  ///< of the centre; none (-1) if the radius is moved

  [[nodiscard]] Test test() const { return moved_axis < 0 ? Test::Contact : Test::Foot; }
  /// Returns the largest coordinate difference of two vertices, to which offsets are relative.
  [[nodiscard]] double size() const;
  /// Returns the ball moved by that share of the size, rounded to doubles; nothing if the radius would be negative.
  [[nodiscard]] std::optional<Ball> moved(double share) const;
  /// Returns the share of the size by which a ball is moved.
  [[nodiscard]] double share_of(const Ball& ball) const;
};

/// Returns the ball of offset 0 of a sample, or nothing if none was found.
[[nodiscard]] std::optional<AtThreshold> draw_at_threshold(const cases::SamplePlace& place);

/// Balls are moved by 2^-k of the size, k = 0, ..., kMostExponent, to either side.
inline constexpr std::size_t kMostExponent = 60;

/// The distance from a threshold up to which a method was seen to be wrong.
struct WrongReach {
  std::array<bool, kMostExponent + 1>
      wrong{};                   ///< [k]: whether at 2^-k, on either side; false if that is less than a double.
  std::optional<Ball> furthest;  ///< the furthest ball on which it was seen to be wrong
  double share = 0;              ///< by which it is moved, as a share of the size

  friend bool operator<(const WrongReach& a, const WrongReach& b) { return a.share < b.share; }
};

/// Tests at 2^-k of the size to either side, for every k, then at kSteps even steps between the largest offset found
/// wrong and twice that.
///
/// Wrong answers need not end at one offset, and a sweep of all doubles is not affordable. So the result only states
/// that the method is wrong at `furthest` and was right at every tested ball further out. `truth` must be a correct
/// method, prepared for the same polygon.
[[nodiscard]] WrongReach wrong_reach(const AtThreshold& at, const cases::PreparedMethod& method, bool knows_boundary,
                                     const cases::PreparedMethod& truth);
inline constexpr int kSteps = 64;

}  // namespace touchstone::near_edge
