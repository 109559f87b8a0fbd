// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "experiments/cases/comparison.h"
#include "experiments/cases/threshold.h"

namespace touchstone::near_edge {

using cases::Test;

/// A ball exactly at a threshold, but for its rounding, and what it is moved by.
struct AtThreshold {
  Polygon polygon;
  Ball ball;       ///< radius: the double nearest to the distance; foot: the last centre whose foot is not outside
  int moved_axis;  ///< of the centre; none (-1) where the radius is moved

  [[nodiscard]] Test test() const { return moved_axis < 0 ? Test::Contact : Test::Foot; }
  /// The largest coordinate difference of two vertices: what offsets are relative to.
  [[nodiscard]] double size() const;
  /// Moved by that share of the size, rounded to doubles; nothing where the radius would be negative.
  [[nodiscard]] std::optional<Ball> moved(double share) const;
  /// The share of the size by which a ball is moved.
  [[nodiscard]] double share_of(const Ball& ball) const;
};

/// The ball of offset 0 of a sample. Nothing where none was found.
[[nodiscard]] std::optional<AtThreshold> draw_at_threshold(const cases::SamplePlace& place);

/// Balls are moved by 2^-k of the size, k = 0, ..., kMostExponent, to either side.
inline constexpr std::size_t kMostExponent = 60;

/// How far from a threshold a method is still wrong.
struct WrongReach {
  std::array<bool, kMostExponent + 1> wrong{};  ///< [k]: at 2^-k, on either side? Not where that is no double away.
  std::optional<Ball> furthest;                 ///< the furthest ball on which it was seen to be wrong
  double share = 0;                             ///< how far it is moved, of the size

  friend bool operator<(const WrongReach& a, const WrongReach& b) { return a.share < b.share; }
};

/// Asks at 2^-k of the size to either side, for every k, then at kSteps even steps between the largest offset found
/// wrong and twice that.
///
/// Wrongness need not end at one offset, and no sweep of all doubles is affordable. So: the method is wrong at
/// `furthest`; further out, it was right at every ball that was asked about. More is not promised. `truth` is one that
/// is right, prepared for the same polygon.
[[nodiscard]] WrongReach wrong_reach(const AtThreshold& at, const cases::PreparedMethod& method, bool knows_boundary,
                                     const cases::PreparedMethod& truth);
inline constexpr int kSteps = 64;

}  // namespace touchstone::near_edge
