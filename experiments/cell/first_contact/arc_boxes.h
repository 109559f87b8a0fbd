// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/cell/first_contact/arc.h"
#include "geometry/scene/box.h"

namespace touchstone::cell {

/// Boxes, rounded outwards, that hold what a ball sweeps in each piece of an arc: what none of them meets the ball
/// never touches on the move. Requires a valid arc, round to nearest.
class ArcBoxes {
 public:
  ArcBoxes(const Arc& arc, double radius);

  /// In which angles, in degrees, the ball can touch what lies in a box.
  struct Range {
    double begin, end;
  };
  [[nodiscard]] std::optional<Range> range(const Box& box) const;

 private:
  double piece_;  // degrees
  std::vector<Box> boxes_;
};

}  // namespace touchstone::cell
