// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace touchstone::cell {

/// A part of a turn, between two angles in degrees from the turn's beginning, and lower bounds of the distance of two
/// bodies at these angles.
struct Clearance {
  double begin, at_begin, end, at_end;

  /// Returns a lower bound on the whole part. Requires that the distance changes by at most `rate` per degree.
  [[nodiscard]] double least(double rate) const { return (at_begin + at_end - rate * (end - begin)) / 2; }
};

enum class Next { Done, Halve, Stop };

/// Judges a part of a turn and, where that asks for it, its halves, the earlier one first; each halving calls
/// `measure(middle, part)` for a lower bound in the middle. Returns false if a judgement was to stop.
template <class Judge, class Measure>
bool by_halves(const Clearance& part, const Judge& judge, const Measure& measure) {
  if (const Next next = judge(part); next != Next::Halve) return next == Next::Done;
  const double middle = part.begin + (part.end - part.begin) / 2, there = measure(middle, part);
  return by_halves({part.begin, part.at_begin, middle, there}, judge, measure) &&
         by_halves({middle, there, part.end, part.at_end}, judge, measure);
}

/// Returns the first angle from which on two bodies may touch; none if they do not touch on all of the part. Guarantee:
/// they do not touch at an earlier angle. It may name a miss by `finest` times `rate` and by what the measured bounds
/// are below the distances.
template <class Measure>
std::optional<double> first_touch(const Clearance& part, double rate, double finest, const Measure& measure) {
  std::optional<double> first;
  const auto judge = [&](const Clearance& p) {
    if (p.at_begin > 0 && p.at_end > 0 && p.least(rate) > 0) return Next::Done;
    if (p.at_begin > 0 && p.end - p.begin > finest) return Next::Halve;
    first = p.begin;
    return Next::Stop;
  };
  by_halves(part, judge, measure);
  return first;
}

}  // namespace touchstone::cell
