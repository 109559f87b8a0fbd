// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/edge_index.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/detail/floating_point_state.h"

namespace touchstone::filtered {

EdgeIndex::EdgeIndex(std::vector<Edge> edges, const Polygon& polygon, Use use) : polygon_(polygon) {
  if (use == Use::OftenByHierarchy || (use == Use::Often && edges.size() > kMostScanned)) {
    edges_ = std::move(edges);
    return;
  }
  leaves_.reserve((edges.size() + EdgeTree::kWidth - 1) / EdgeTree::kWidth);
  for (std::size_t first = 0; first < edges.size(); first += EdgeTree::kWidth) {
    std::uint32_t group[EdgeTree::kWidth];
    const std::size_t count = std::min(EdgeTree::kWidth, edges.size() - first);
    std::iota(group, group + count, static_cast<std::uint32_t>(first));
    leaves_.emplace_back(edges, std::span(group, count));
  }
}

const EdgeTree& EdgeIndex::build() const {
  const FloatingPointState nearest;
  std::call_once(once_, [this] {
    std::vector<std::size_t> loop_ends;
    for (std::size_t loop = 0; loop < polygon_.loop_count(); ++loop) loop_ends.push_back(polygon_.loop_end(loop));
    tree_ = std::make_unique<const EdgeTree>(edges_, loop_ends);
    edges_ = {};
    built_.store(tree_.get(), std::memory_order_release);
  });
  return *tree_;
}

}  // namespace touchstone::filtered
