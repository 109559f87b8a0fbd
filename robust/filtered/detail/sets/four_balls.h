// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/polygon/frame_query.h"

/// The first stage of contact for four balls and one polygon: a lane of each Pack belongs to a ball.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A bit for each ball; neither for a ball whose contact is not certain.
struct CertainContacts {
  unsigned touching, separate;
};

/// EdgesAndFoot of four balls, a bit a ball.
struct EdgesAndFeet {
  unsigned hit, near_boundary, unsure, inside;

  /// As EdgesAndFoot::certain_sign. A ball that misses the plane is separate, whatever its edges; of the others the
  /// plane is certainly cut, or not certainly.
  [[nodiscard]] CertainContacts contacts(unsigned missed_plane, unsigned cut_plane) const {
    const unsigned met = ~missed_plane & 0xF, outside = met & ~(hit | near_boundary | unsure | inside);
    return {met & (hit | (~near_boundary & inside & cut_plane)), missed_plane | outside};
  }
};

/// HeightQuery and FrameQuery of four balls.
struct BallLanes {
  Pack radius;
  Pack x, y;                                          ///< the feet
  Pack certain_hit_sq, certain_miss_sq, boundary_sq;  ///< as in FrameQuery
  unsigned missed_plane, cut_plane;                   ///< a bit a ball

  BallLanes(const Ball* four, const Frame& frame) {
    const auto lanes = [four](int axis) {
      return pack(four[0].center[axis], four[1].center[axis], four[2].center[axis], four[3].center[axis]);
    };
    const Pack given[] = {lanes(0), lanes(1), lanes(2),
                          pack(four[0].radius, four[1].radius, four[2].radius, four[3].radius)};
    const Pack scale[] = {all_lanes(frame.unit.down[0]), all_lanes(frame.unit.down[1])};
    const auto scaled = [&scale](const Pack& length) { return length * scale[0] * scale[1]; };
    const Vector3<Pack> to_center{scaled(given[0]) - all_lanes(frame.origin.x),
                                  scaled(given[1]) - all_lanes(frame.origin.y),
                                  scaled(given[2]) - all_lanes(frame.origin.z)};
    radius = scaled(given[3]);
    const auto everywhere = [](const Vector3<double>& v) {
      return Vector3<Pack>{all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)};
    };
    const frame::Height<Pack> height(to_center, everywhere(frame.normal), all_lanes(frame.plane_height));
    const Pack above = magnitude(height.value), zero = all_lanes(0);
    missed_plane = negative_lanes(radius - (above - height.error));
    cut_plane = negative_lanes((above + height.error) - radius);

    x = frame::coordinate(everywhere(frame.x), to_center);
    y = frame::coordinate(everywhere(frame.y), to_center);
    const Pack error = frame::distance_error(height.size);
    const frame::Disc<Pack> disc(radius, maximum(above - height.error, zero), above + height.error, error);
    certain_miss_sq = disc.outer_sq, certain_hit_sq = disc.inner_sq;
    boundary_sq = frame::boundary_square(error);
  }

  /// Returns the balls whose plane is not missed.
  [[nodiscard]] unsigned met_plane() const { return ~missed_plane & 0xF; }
  /// Writes the query of each ball.
  void write_queries(FrameQuery (&queries)[kLanes]) const {
    double all_x[kLanes], all_y[kLanes], hit[kLanes], miss[kLanes], boundary[kLanes];
    store(all_x, x), store(all_y, y);
    store(hit, certain_hit_sq), store(miss, certain_miss_sq), store(boundary, boundary_sq);
    for (int ball = 0; ball < kLanes; ++ball) {
      FrameQuery& query = queries[ball];
      query.x = all_x[ball], query.y = all_y[ball];
      query.certain_hit_sq = hit[ball];
      query.certain_miss_sq = miss[ball], query.boundary_sq = boundary[ball];
    }
  }
};

/// Adds one edge, as seen by four balls.
TOUCHSTONE_INLINE void add(EdgesInView& view, const EdgeTree::Leaf& leaf, std::uint32_t lane, const BallLanes& balls) {
  const auto number = [lane](const double(&numbers)[EdgeTree::kWidth]) { return all_lanes(numbers[lane]); };
  view.add(balls.x, balls.y, number(leaf.start_x), number(leaf.start_y), number(leaf.direction_x),
           number(leaf.direction_y), number(leaf.length), number(leaf.end_x), number(leaf.end_y));
}

/// Returns which of four balls certainly touch the polygon, and which certainly do not, by all of its edges.
inline CertainContacts scan_for(const BallLanes& balls, const EdgeIndex& edges) {
  EdgesInView view;
  for (const EdgeTree::Leaf& leaf : edges.leaves())
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) add(view, leaf, lane, balls);

  const auto not_above = [&](const Pack& limit_sq) { return ~negative_lanes(limit_sq - view.nearest_sq); };
  return EdgesAndFeet{.hit = negative_lanes(view.nearest_sq - balls.certain_hit_sq),
                      .near_boundary = not_above(balls.boundary_sq),
                      .unsure = not_above(balls.certain_miss_sq),
                      .inside = negative_lanes(view.crossed)}
      .contacts(balls.missed_plane, balls.cut_plane);
}

/// The same by the hierarchy of edges, for one ball after the other.
inline CertainContacts walk_for(const BallLanes& balls, const EdgeIndex& edges) {
  CertainContacts certain{0, balls.missed_plane};
  FrameQuery queries[kLanes];
  balls.write_queries(queries);
  for (unsigned met = balls.met_plane(); met != 0; met &= met - 1) {
    const int ball = __builtin_ctz(met);
    const unsigned bit = 1U << ball;
    const int sign = certain_distance_sign((balls.cut_plane & bit) != 0 ? -1 : 0, queries[ball], edges);
    if (sign != 0) (sign < 0 ? certain.touching : certain.separate) |= bit;
  }
  return certain;
}

/// A walk of a hierarchy of edges with four balls at once, boxes before edges. No ball waits for the boxes of
/// another, and few branches depend on the balls. Gives up if the balls meet many boxes: then a walk with each alone
/// is quicker, because it ends at the first edge that is surely touched.
class WalkTogether {
 public:
  WalkTogether(const BallLanes& balls, const EdgeIndex& edges) : balls_(balls), tree_(edges.tree()) {
    balls.write_queries(queries_);
    for (unsigned met = balls.met_plane(); met != 0; met &= met - 1)
      nodes_[node_count_++] = {tree_.root(), __builtin_ctz(met)};
    for (std::size_t i = 0; i < node_count_ && !gave_up(); ++i) look_at(nodes_[i]);
  }

  [[nodiscard]] bool gave_up() const { return node_count_ > kMost || leaf_count_ > kMost; }

  /// Returns which balls certainly touch the polygon, and which certainly do not. Requires that the walk did not give
  /// up.
  [[nodiscard]] CertainContacts contacts() {
    EdgesAndFeet seen{};
    for (std::size_t i = 0; i < leaf_count_; ++i) {
      const auto [number, ball] = leaves_[i];
      const EdgeTree::Leaf& leaf = tree_.leaves()[static_cast<std::uint32_t>(~number)];
      const LeafView view(leaf, queries_[ball]);
      crossings_[ball] ^= view.crossed;
      const EdgeMarks marks(leaf, view, queries_[ball]);
      seen.hit |= (marks.hit != 0 ? 1U : 0U) << ball;
      seen.near_boundary |= (marks.near_boundary != 0 ? 1U : 0U) << ball;
      seen.unsure |= (marks.unsure != 0 ? 1U : 0U) << ball;
    }
    for (int ball = 0; ball < kLanes; ++ball)
      seen.inside |= (static_cast<unsigned>(__builtin_popcount(crossings_[ball])) & 1) << ball;
    return seen.contacts(balls_.missed_plane, balls_.cut_plane);
  }

 private:
  struct Open {
    std::int32_t number;  ///< as EdgeTree::Node::child
    int ball;
  };
  static constexpr std::size_t kMost = 20;

  void look_at(const Open& open) {
    const FrameQuery& query = queries_[open.ball];
    const EdgeTree::Node& node = tree_.nodes()[static_cast<std::size_t>(open.number)];
    const NodeStep step(tree_, node, query, maximum(query.certain_miss_sq, query.boundary_sq));
    crossings_[open.ball] ^= step.crossings;
    for (unsigned lane = 0; lane < EdgeTree::kWidth; ++lane) {
      const Open child{node.child[lane], open.ball};
      const std::size_t near = ~step.far >> lane & 1, is_leaf = child.number < 0;
      nodes_[node_count_] = child, leaves_[leaf_count_] = child;
      node_count_ += near & (is_leaf ^ 1);
      leaf_count_ += near & is_leaf;
    }
  }

  const BallLanes& balls_;
  const EdgeTree& tree_;
  FrameQuery queries_[kLanes];
  unsigned crossings_[kLanes] = {};
  Open nodes_[kMost + EdgeTree::kWidth + 1], leaves_[kMost + EdgeTree::kWidth + 1];
  std::size_t node_count_ = 0, leaf_count_ = 0;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
