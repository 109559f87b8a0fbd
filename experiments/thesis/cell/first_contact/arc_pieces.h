// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "geometry/bvh/box.h"

namespace touchstone::kinematics {

/// An arc in pieces of a few degrees, each within a known distance of its chord. The ball never touches an object whose
/// distance from every chord exceeds that distance plus the radius. Computed in doubles, with margins for rounding.
/// Requires a valid arc and rounding to nearest.
class ArcPieces {
 public:
  ArcPieces(const Arc& arc, double radius);

  /// An interval of angles, in degrees.
  struct Range {
    double begin, end;
  };
  /// Return where the ball may touch an object inside a box; inside a segment; inside the convex hull of points that
  /// lie roughly in a plane with the given normal, which may be inaccurate or 0. `lift` is the largest distance by
  /// which those points may be moved.
  [[nodiscard]] std::optional<Range> near(const Box& box) const;
  [[nodiscard]] std::optional<Range> near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double lift) const;
  [[nodiscard]] std::optional<Range> near(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal,
                                          double lift) const;

 private:
  struct Piece {
    Eigen::Vector3d begin, end;
    Box box;  ///< of the volume that the ball sweeps
  };
  template <class Test>
  [[nodiscard]] std::optional<Range> range(const Test& may_touch) const;

  std::vector<Piece> pieces_;
  double degrees_;  ///< of a piece
  double margin_;   ///< beyond the chord: the radius, the arc's own distance, rounding
};

}  // namespace touchstone::kinematics
