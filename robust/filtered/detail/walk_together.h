// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/filtered/detail/ball_lanes.h"
#include "robust/filtered/detail/frame_query.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

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
    unsigned hit = 0, near_boundary = 0, unsure = 0, inside = 0;
    for (std::size_t i = 0; i < leaf_count_; ++i) {
      const auto [number, ball] = leaves_[i];
      const EdgeTree::Leaf& leaf = tree_.leaves()[static_cast<std::uint32_t>(~number)];
      const LeafView view(leaf, queries_[ball]);
      crossings_[ball] ^= view.crossed;
      const EdgeMarks marks(leaf, view, queries_[ball]);
      hit |= (marks.hit != 0 ? 1U : 0U) << ball;
      near_boundary |= (marks.near_boundary != 0 ? 1U : 0U) << ball;
      unsure |= (marks.unsure != 0 ? 1U : 0U) << ball;
    }
    for (int ball = 0; ball < kLanes; ++ball)
      inside |= (static_cast<unsigned>(__builtin_popcount(crossings_[ball])) & 1) << ball;
    // As in certain_distance_sign.
    const unsigned met = balls_.met_plane(), clear = met & ~hit & ~near_boundary;
    return {(met & hit) | (clear & inside & balls_.cut_plane), balls_.missed_plane | (clear & ~inside & ~unsure)};
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
    const NodeStep step(tree_, node, query, larger(query.certain_miss_sq, query.boundary_sq));
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

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
