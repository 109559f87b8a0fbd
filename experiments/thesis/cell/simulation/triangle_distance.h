// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/bvh/box.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::cell {

/// A triangle of a named thing.
struct NamedTriangle {
  Triangle triangle;
  std::uint32_t owner;  ///< index of its name
};

struct DistanceOfTrees;

/// A hierarchy of boxes over triangles, for their distances.
class TriangleTree {
 public:
  /// Cost: O(n log n), about 0.3 us per triangle.
  explicit TriangleTree(std::vector<NamedTriangle> triangles);

  /// Returns whether any triangle satisfies a test.
  [[nodiscard]] bool any(const std::function<bool(const NamedTriangle&)>& test) const {
    return std::ranges::any_of(triangles_, test);
  }
  /// Returns the smallest box around all triangles.
  [[nodiscard]] touchstone::Box whole() const { return nodes_.empty() ? touchstone::Box() : nodes_.front().box; }

 private:
  friend DistanceOfTrees distance(const TriangleTree&, const Pose&, const TriangleTree&, double);
  struct Node {
    touchstone::Box box;
    std::uint32_t begin, end;   // of its triangles
    std::uint32_t children[2];  // both 0 for a leaf
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<NamedTriangle> triangles_;
  std::vector<Node> nodes_;
};

/// An enclosure of a distance: `lower` is proved, `upper` is attained by two points, up to their rounding.
struct DistanceBounds {
  double lower, upper;
};

/// Returns the distance of two closed triangles, points and segments among them.
///
/// The lower bound is proved: no point of one triangle is nearer to the other. It is that of projections onto the line
/// through the two nearest points found, less than what they can be rounded by, and differs from the upper one by
/// rounding. Near contact rounding may turn that line. Then the bound is that of projections onto normals and onto what
/// is perpendicular to an edge of each; it is less than the distance, and it can be 0 for needles that nearly touch.
/// Requires finite coordinates. Cost: 0.3 us, near contact 1 us.
[[nodiscard]] DistanceBounds distance(const Triangle& first, const Triangle& second);

/// The distance of two sets of triangles.
struct DistanceOfTrees : DistanceBounds {
  std::uint32_t owner = 0, other = 0;  ///< of the two triangles with the least lower bound, if that is below the cutoff
};

/// Returns the distance of posed triangles from others. Both bounds are enlarged by more than posing is off. Distances
/// of `cutoff` and more need not be told apart: then `lower` is the cutoff and `upper` may be infinite. Cost: 5 to 50
/// us, by two hierarchies.
[[nodiscard]] DistanceOfTrees distance(const TriangleTree& moving, const Pose& pose, const TriangleTree& still,
                                       double cutoff);

/// A shift up to the first contact.
struct StraightWay {
  double way;                          ///< by which it may go
  bool touches;                        ///< whether it ends at a contact
  double gap;                          ///< at the end of the way, an upper bound; infinite without contact
  std::uint32_t owner = 0, other = 0;  ///< of the triangles that touch
};

/// Shifts posed triangles along a direction of length 1, by at most `most`, until they touch others.
///
/// Guarantees
///  (1) after no shift from 0 to `way` does any point of one touch the other, except perhaps at 0, if `way` is 0;
///  (2) at the end they are at most `gap` apart: for faces that meet squarely, less than 1e-12 of the largest
///      coordinate.
/// What slides along closely is called a contact if 10,000 distances do not suffice to pass it; `gap` says so. Cost: a
/// few distances of two hierarchies.
/// Method: conservative advancement; no shift is longer than a lower bound of the distance.
[[nodiscard]] StraightWay until_touch(const TriangleTree& moving, const Pose& pose, const Eigen::Vector3d& direction,
                                      double most, const TriangleTree& still);

}  // namespace touchstone::cell
