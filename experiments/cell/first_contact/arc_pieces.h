// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "experiments/cell/first_contact/arc.h"
#include "geometry/bvh/box.h"

namespace touchstone::kinematics {

/// An arc in pieces of a few degrees, each within a known distance of its chord: what keeps further than that and the
/// radius from every chord the ball never touches on the move. Doubles, with margins for their rounding. Requires a
/// valid arc, round to nearest.
class ArcPieces {
 public:
  ArcPieces(const Arc& arc, double radius);

  /// Angles, in degrees.
  struct Range {
    double begin, end;
  };
  /// Where the ball may touch what lies in a box; in a segment; in the convex hull of points that are about in a plane
  /// with that normal, which may be off or 0. `lift` is the most by which those points may be moved.
  [[nodiscard]] std::optional<Range> near(const Box& box) const;
  [[nodiscard]] std::optional<Range> near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double lift) const;
  [[nodiscard]] std::optional<Range> near(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal,
                                          double lift) const;

 private:
  struct Piece {
    Eigen::Vector3d begin, end;
    Box box;  ///< of what the ball sweeps
  };
  template <class Test>
  [[nodiscard]] std::optional<Range> range(const Test& may_touch) const;

  std::vector<Piece> pieces_;
  double degrees_;  ///< of a piece
  double margin_;   ///< beyond the chord: the radius, the arc's own distance, rounding
};

}  // namespace touchstone::kinematics
