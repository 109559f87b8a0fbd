// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace touchstone::kinematics {

/// Where the links of an arm point, in degrees: the first leans forward from the vertical, the second is elevated above
/// the horizontal.
struct LinkAngles {
  double lean, elevation;
};

/// A point of the arm's plane: away from the shoulder, and above it.
struct Reach {
  double out, up;
};

/// Two links in a vertical plane.
struct TwoLinks {
  double first, second;  ///< lengths

  [[nodiscard]] Reach reach(const LinkAngles& angles) const;
  /// The angles that reach a point: none where it is too far or too near, else those with the elbow above the line to
  /// the point, then those with it below; one where the links are in line. Requires links that are not both 0.
  /// The law of cosines; near the ends of the reach the angles lose half of their digits.
  [[nodiscard]] std::vector<LinkAngles> inverse(const Reach& point) const;
};

}  // namespace touchstone::kinematics
