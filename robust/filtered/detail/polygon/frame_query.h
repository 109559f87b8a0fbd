// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/edge_frame.h"

/// The first stage for prepared polygons: computes in the isometric frame, in doubles, with absolute error bounds.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The height of a ball's centre above a frame's plane.
///
/// Like FrameQuery, it is valid in every rounding direction and, in frames from Frame::kSubnormal up, under
/// flush-to-zero, and raises no flags except INEXACT and UNDERFLOW.
struct HeightQuery {
  Vector3<double> to_center;  ///< from the frame's origin to the centre
  double size;                ///< as in frame::Height
  double radius;
  double height, height_error;  ///< the height of the centre above the plane

  /// Requires coordinates and a radius up to frame.reachable.
  __attribute__((always_inline)) HeightQuery(const Ball& ball, const Frame& frame)
      : HeightQuery(
            {frame.unit.scaled(ball.center[0]), frame.unit.scaled(ball.center[1]), frame.unit.scaled(ball.center[2])},
            frame.unit.scaled(ball.radius), frame.origin, frame.normal, frame.plane_height) {
    assert(size <= 8 * Frame::kReach);
  }

  /// Returns +1 if the plane misses the ball, -1 if it cuts it, 0 if that is not certain.
  [[nodiscard]] int plane_sign() const {
    if (std::abs(height) - height_error > radius) return 1;
    return std::abs(height) + height_error < radius ? -1 : 0;
  }
  /// Returns whether side() is certain: a rounded difference that exceeds a double did so before it was rounded.
  [[nodiscard]] __attribute__((always_inline)) bool knows_side() const {
    return std::abs(std::abs(height) - radius) > height_error;  // a plane that misses the ball is beyond its own error
  }
  /// Returns the side of the plane. Requires knows_side().
  [[nodiscard]] __attribute__((always_inline)) PlaneSide side() const {
    static constexpr PlaneSide kSides[] = {PlaneSide::Intersects, PlaneSide::Behind, PlaneSide::InFront};
    const std::size_t misses = std::abs(height) > radius, in_front = height > 0;
    return kSides[misses * (1 + in_front)];
  }

 private:
  __attribute__((always_inline))
  HeightQuery(const Vector3<double>& center, double ball_radius, const Vector3<double>& origin,
              const Vector3<double>& normal, double plane_height)
      : to_center{center.x - origin.x, center.y - origin.y, center.z - origin.z}, radius(ball_radius) {
    const frame::Height<double> above(to_center, normal, plane_height);
    size = above.size, height = above.value, height_error = above.error;
  }
};

/// The foot in a frame, and the distances from it that doubles can decide.
///
/// Let rho be the distance in the plane from the foot to an edge, and rho^2 its square as the walk computes it. The
/// ball certainly touches the edge if rho^2 is below `certain_hit_sq`, and certainly misses it if rho^2 is above
/// `certain_miss_sq`. The foot is certainly not on the edge if rho^2 is above `boundary_sq`.
struct FrameQuery {
  double x, y;                                          ///< the foot
  double certain_hit_sq, certain_miss_sq, boundary_sq;  ///< squares; negative if there is no such distance

  FrameQuery() = default;
  /// A foot alone, whose coordinates are known to `error` beyond the error of feet.
  FrameQuery(double foot_x, double foot_y, double foot_size, double error)
      : x(foot_x), y(foot_y), certain_hit_sq(-1), certain_miss_sq(-1) {
    boundary_sq = frame::boundary_square(frame::distance_error(foot_size) + error);
  }
  TOUCHSTONE_INLINE FrameQuery(const HeightQuery& ball, const Frame& frame)
      : x(frame::coordinate(frame.x, ball.to_center)), y(frame::coordinate(frame.y, ball.to_center)) {
    const double above = std::abs(ball.height), error = frame::distance_error(ball.size);
    const double low = maximum(above - ball.height_error, 0.0), high = above + ball.height_error;
    const frame::Disc<double> disc(ball.radius, low, high, error);
    certain_miss_sq = disc.outer_sq, certain_hit_sq = disc.inner_sq;
    boundary_sq = frame::boundary_square(error);
  }
};

/// Returns negative lanes where the ray to the right from the foot crosses an edge. The foot lies `across` to the left
/// of the line of the edge. Right where rho^2 > boundary_sq.
TOUCHSTONE_INLINE Pack crossing(const Pack& x, const Pack& y, const Pack& start_x, const Pack& start_y,
                                const Pack& end_x, const Pack& end_y, const Pack& across) {
  // An edge that ends above the ray runs upwards; if the crossing lies to the right, the foot is to its left.
  const Pack start_above = y - start_y, end_above = y - end_y;
  const Pack all_right = (x - start_x) & (x - end_x), all_left = (start_x - x) & (end_x - x);
  const Pack left_of_it = across ^ end_above;
  return (start_above ^ end_above) & (all_right | (left_of_it ^ (left_of_it & all_left)));
}

/// Returns the least number of four.
TOUCHSTONE_INLINE double least_lane(const Pack& numbers) {
  double lane[kLanes];
  store(lane, numbers);
  return minimum(minimum(lane[0], lane[1]), minimum(lane[2], lane[3]));
}

/// Four edges of a leaf, relative to the foot.
struct LeafView {
  Pack along, length;
  Pack squared;      ///< rho^2
  unsigned crossed;  ///< a bit an edge, as `crossing`

  LeafView() = default;
  TOUCHSTONE_INLINE LeafView(const EdgeTree::Leaf& leaf, const FrameQuery& query) {
    const Pack x = all_lanes(query.x), y = all_lanes(query.y), start_x = load(leaf.start_x),
               start_y = load(leaf.start_y);
    length = load(leaf.length);
    const frame::FootFromEdge<Pack> foot(x, y, start_x, start_y, load(leaf.direction_x), load(leaf.direction_y),
                                         length);
    along = foot.along, squared = foot.squared;
    crossed = negative_lanes(crossing(x, y, start_x, start_y, load(leaf.end_x), load(leaf.end_y), foot.across));
  }
};

/// The boxes of a node, relative to the foot.
struct NodeView {
  Pack squared;    ///< of the distances to the boxes; compared with frame::box_reach of a square from `boundary_sq` on
  unsigned right;  ///< a bit a box: where the foot is outside it, the horizontal line meets it on the right, if at all

  TOUCHSTONE_INLINE NodeView(const EdgeTree::Node& node, const FrameQuery& query) {
    const Pack axis_x = load(node.axis_x), axis_y = load(node.axis_y);
    const frame::FootFromBox<Pack> foot(all_lanes(query.x), all_lanes(query.y), load(node.center_x),
                                        load(node.center_y), axis_x, axis_y, load(node.half_along),
                                        load(node.half_across));
    squared = foot.squared;
    // Of the two sides that face the foot take the one from which it is farther. Its outward normal n points to the
    // foot: points of the box at the foot's height lie on the right if and only if n_x < 0.
    const unsigned by_along = negative_lanes(foot.above - foot.beside);
    right = (by_along & negative_lanes(foot.along ^ axis_x)) | (~by_along & ~negative_lanes(foot.across ^ axis_y));
  }
};

/// Returns whether an odd number of these ends lies above the horizontal ray from the foot. Requires ends ordered by y.
inline bool odd_ends_above(std::span<const EdgeTree::End> ends, double y) {
  const auto above = std::partition_point(ends.begin(), ends.end(),
                                          [y](const EdgeTree::End& end) { return !std::signbit(y - end.y); });
  return ((ends.end() - above) & 1) != 0;
}

/// One step of a walk: the boxes of a node that are farther than a limit, and what these say about the ray.
struct NodeStep {
  Pack squared;        ///< as in NodeView
  unsigned far;        ///< a bit a box
  unsigned crossings;  ///< a bit a box that is far: the ray crosses its edges an odd number of times

  TOUCHSTONE_INLINE NodeStep(const EdgeTree& tree, const EdgeTree::Node& node, const FrameQuery& query,
                             double limit_sq) {
    const NodeView view(node, query);
    squared = view.squared;
    far = negative_lanes(all_lanes(frame::box_reach(limit_sq)) - view.squared);
    // As many ends above the ray as below it are odd in number only if the ray parts the lowest from the highest.
    const Pack y = all_lanes(query.y), parted = (y - load(node.lowest_end)) ^ (y - load(node.highest_end));
    const unsigned met = far & view.right & negative_lanes(parted);
    crossings = met & ~node.with_more_ends;
    for (unsigned more = met & node.with_more_ends; more != 0; more &= more - 1)
      if (odd_ends_above(tree.ends_of(node, static_cast<unsigned>(__builtin_ctz(more))), query.y))
        crossings ^= more & -more;
  }
};

/// Calls visit(leaf, view) for all leaves. Otherwise as the walk of a tree.
template <class Visit>
TOUCHSTONE_INLINE bool scan(const std::vector<EdgeTree::Leaf>& leaves, const FrameQuery& query, const Visit& visit) {
  unsigned crossings = 0;
  for (const EdgeTree::Leaf& leaf : leaves) {
    const LeafView view(leaf, query);
    crossings ^= view.crossed;
    if (visit(leaf, view)) return false;
  }
  return (__builtin_popcount(crossings) & 1) != 0;
}

/// Visits all leaves whose box lies within a distance of the foot, and calls visit(leaf, view). `limit_sq` is the
/// square of that distance, at least `boundary_sq`; the visitor may shrink it. Stops if visit returns true. If it was
/// not stopped, returns how often, modulo 2, the ray to the right from the foot crosses the loops. Leaves come in no
/// particular order, or with the nearest child first. If there is no tree, visits all leaves.
template <bool nearest_first = false, class Visit>
bool walk(const EdgeIndex& index, const FrameQuery& query, const double& limit_sq, const Visit& visit) {
  if (index.is_scanned()) return scan(index.leaves(), query, visit);
  const EdgeTree& tree = index.tree();
  std::int32_t stack[EdgeTree::kStackSize];
  std::size_t open = 0;
  stack[open++] = tree.root();
  unsigned crossings = 0;
  while (open > 0) {
    const std::int32_t number = stack[--open];
    if (number < 0) {
      const EdgeTree::Leaf& leaf = tree.leaves()[static_cast<std::uint32_t>(~number)];
      const LeafView view(leaf, query);
      crossings ^= view.crossed;
      if (visit(leaf, view)) return false;
      continue;
    }
    const EdgeTree::Node& node = tree.nodes()[static_cast<std::size_t>(number)];
    const NodeStep step(tree, node, query, limit_sq);
    crossings ^= step.crossings;
    unsigned last = EdgeTree::kWidth;
    if constexpr (nearest_first) {
      double distances[kLanes];
      store(distances, step.squared);
      for (unsigned lane = 0; lane < EdgeTree::kWidth; ++lane)
        if ((step.far >> lane & 1) == 0 && (last == EdgeTree::kWidth || distances[lane] < distances[last])) last = lane;
    }
    // Without branches, which depend on the foot.
    const unsigned beyond = step.far | 1U << last;
    for (unsigned lane = EdgeTree::kWidth; lane-- > 0;) {
      stack[open] = node.child[lane];
      open += ~beyond >> lane & 1;
    }
    if (last != EdgeTree::kWidth) stack[open++] = node.child[last];
  }
  return (__builtin_popcount(crossings) & 1) != 0;
}

/// A bit for each edge of a leaf that the ball certainly touches, that the foot may lie on, and that the ball may
/// touch.
struct EdgeMarks {
  unsigned hit, near_boundary, unsure;

  TOUCHSTONE_INLINE EdgeMarks(const EdgeTree::Leaf& leaf, const LeafView& view, const FrameQuery& query) {
    const unsigned lanes = (1U << leaf.count) - 1;
    hit = negative_lanes(view.squared - all_lanes(query.certain_hit_sq)) & lanes;
    near_boundary = ~negative_lanes(all_lanes(query.boundary_sq) - view.squared) & lanes;
    unsure = ~negative_lanes(all_lanes(query.certain_miss_sq) - view.squared) & lanes;
  }
};

/// The findings of a walk about a polygon's edges and the foot. If the walk stopped at a hit, the rest is unknown.
struct EdgesAndFoot {
  bool hit, near_boundary, unsure;  ///< of some edge, as in EdgeMarks
  bool inside;                      ///< whether the foot is; unknown if near_boundary

  /// Returns +1 if the ball certainly misses the polygon, -1 if it certainly overlaps it, 0 if neither is certain.
  /// `plane`: the certain sign of the distance to the plane less the radius, -1 or 0.
  [[nodiscard]] TOUCHSTONE_INLINE int certain_sign(int plane) const {
    // If the foot is inside, only the plane matters; if it is outside, only the edges do. Without branches.
    const bool touching = hit | (!near_boundary & inside & (plane < 0));
    const bool separate = !(hit | near_boundary | unsure | inside);
    return int{separate} - int{touching};
  }

  /// Returns the sign of the distance less the radius, of a ball whose plane is not certainly missed; with
  /// `contact_only`, a sign that is not +1 may be either of the others. Calls for what is not certain: `plane()`, the
  /// sign of the distance to the plane; `edges()`, that to the nearest edge of those that are unsure, less the radius
  /// both; and `outside()`, whether the foot is.
  template <bool contact_only, class Plane, class Edges, class Outside>
  [[nodiscard]] int sign(const Plane& plane, const Edges& edges, const Outside& outside) const {
    if (hit) return -1;
    int of_plane = 0;
    if (near_boundary || inside) {
      of_plane = plane();
      if (of_plane > 0 || !near_boundary) return of_plane;
    }
    const int of_edges = unsure ? edges() : 1;
    if (!near_boundary || of_edges < 0 || (contact_only && of_edges == 0)) return of_edges;
    return outside() ? of_edges : of_plane;
  }
};

/// The foot as seen from the edges that were added.
struct EdgesInView {
  Pack nearest_sq = all_lanes(0x1p500);  ///< the least rho^2; larger than any without an edge, and finite
  Pack crossed = all_lanes(0);           ///< negative: the ray to the right crosses an odd number of edges

  TOUCHSTONE_INLINE void add(const Pack& x, const Pack& y, const Pack& start_x, const Pack& start_y,
                             const Pack& direction_x, const Pack& direction_y, const Pack& length, const Pack& end_x,
                             const Pack& end_y) {
    const frame::FootFromEdge<Pack> foot(x, y, start_x, start_y, direction_x, direction_y, length);
    nearest_sq = minimum(nearest_sq, foot.squared);
    crossed = crossed ^ crossing(x, y, start_x, start_y, end_x, end_y, foot.across);
  }
};

/// Returns what all edges say, without a branch on it: one that is predicted wrongly costs as much as several leaves.
TOUCHSTONE_INLINE EdgesAndFoot scanned(const FrameQuery& query, const std::vector<EdgeTree::Leaf>& leaves) {
  EdgesInView view;
  const Pack x = all_lanes(query.x), y = all_lanes(query.y);
  for (const EdgeTree::Leaf& leaf : leaves)  // a lane without an edge of its own holds a vertex
    view.add(x, y, load(leaf.start_x), load(leaf.start_y), load(leaf.direction_x), load(leaf.direction_y),
             load(leaf.length), load(leaf.end_x), load(leaf.end_y));
  const double least = least_lane(view.nearest_sq);
  return {least < query.certain_hit_sq, least <= query.boundary_sq, least <= query.certain_miss_sq,
          (__builtin_popcount(negative_lanes(view.crossed)) & 1) != 0};
}

/// As EdgesAndFoot::certain_sign, by a walk of the edges.
TOUCHSTONE_INLINE int certain_distance_sign(int plane, const FrameQuery& query, const EdgeIndex& edges) {
  if (edges.is_scanned()) return scanned(query, edges.leaves()).certain_sign(plane);
  const double limit_sq = maximum(query.certain_miss_sq, query.boundary_sq);
  unsigned hit = 0, near_boundary = 0, unsure = 0;
  const bool inside = walk(edges, query, limit_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    const EdgeMarks marks(leaf, view, query);
    hit |= marks.hit, near_boundary |= marks.near_boundary, unsure |= marks.unsure;
    return hit != 0;
  });
  return EdgesAndFoot{hit != 0, near_boundary != 0, unsure != 0, inside}.certain_sign(plane);
}
TOUCHSTONE_INLINE int certain_distance_sign(const HeightQuery& height, const Frame& frame, const EdgeIndex& edges) {
  const int plane = height.plane_sign();
  return plane > 0 ? 1 : certain_distance_sign(plane, FrameQuery(height, frame), edges);
}

/// The leaves that the ball or its foot may touch, as one walk met them, for several decisions about the same ball.
class SeenLeaves {
 public:
  /// Walks, unless more than kMost leaves are met: then nothing was seen.
  SeenLeaves(const EdgeIndex& index, const FrameQuery& query)
      : limit_sq_(index.is_scanned() ? 0x1p1000 : maximum(query.certain_miss_sq, query.boundary_sq)) {
    bool overflows = false;
    crossed_ = walk(index, query, limit_sq_, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
      if (count_ == kMost) return overflows = true;
      leaves_[count_] = &leaf;
      views_[count_++] = view;
      return false;
    });
    if (overflows) limit_sq_ = -1;
  }

  /// Returns whether all leaves within this distance of the foot were seen; its square is at least `boundary_sq`.
  [[nodiscard]] bool reach(double limit_sq) const { return limit_sq <= limit_sq_; }
  /// As `walk` within a distance that was reached; may visit more leaves.
  template <class Visit>
  bool visit(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (visit(*leaves_[i], views_[i])) return false;
    return crossed_;
  }
  /// Returns the square of the least distance of an edge that was seen from the foot; 2^500 if none was.
  [[nodiscard]] double least_sq() const {
    Pack least = all_lanes(0x1p500);
    for (std::size_t i = 0; i < count_; ++i) least = minimum(least, views_[i].squared);
    return least_lane(least);
  }

 private:
  static constexpr std::size_t kMost = (EdgeIndex::kMostScanned + EdgeTree::kWidth - 1) / EdgeTree::kWidth;

  double limit_sq_;
  bool crossed_;
  std::size_t count_ = 0;
  const EdgeTree::Leaf* leaves_[kMost];
  LeafView views_[kMost];
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
