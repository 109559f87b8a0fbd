// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/frame_query.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// The leaves that the ball or its foot may touch, as one walk met them, for several decisions about the same ball.
class SeenLeaves {
 public:
  /// Walks, unless more than kMost leaves are met: then nothing was seen.
  SeenLeaves(const EdgeIndex& index, const FrameQuery& query)
      : limit_sq_(index.is_scanned() ? 0x1p1000 : larger(query.certain_miss_sq, query.boundary_sq)) {
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
    double squared[kLanes];
    store(squared, least);
    return std::min(std::min(squared[0], squared[1]), std::min(squared[2], squared[3]));
  }

 private:
  static constexpr std::size_t kMost = (EdgeIndex::kMostScanned + EdgeTree::kWidth - 1) / EdgeTree::kWidth;

  double limit_sq_;
  bool crossed_;
  std::size_t count_ = 0;
  const EdgeTree::Leaf* leaves_[kMost];
  LeafView views_[kMost];
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
