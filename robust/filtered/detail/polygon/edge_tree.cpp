// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/polygon/edge_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/edge_frame.h"

namespace touchstone::filtered::detail {

namespace {

using Edge = EdgeTree::Edge;
using End = EdgeTree::End;

struct Point {
  double x, y;
};

/// A box as stored in a node: centre, axis and half sizes.
struct Box {
  double center_x = 0, center_y = 0, axis_x = 1, axis_y = 0, half_along = -0x1p500, half_across = -0x1p500;
  [[nodiscard]] double area() const { return half_along * half_across; }
};

template <class F>
void for_each_point(std::span<const Edge> edges, std::span<const std::uint32_t> group, const F& f) {
  for (const std::uint32_t i : group) {
    f(Point{edges[i].start_x, edges[i].start_y});
    f(Point{edges[i].end_x, edges[i].end_y});
  }
}

Box box_along(std::span<const Edge> edges, std::span<const std::uint32_t> group, Point axis) {
  double least_along = 0x1p500, most_along = -0x1p500, least_across = 0x1p500, most_across = -0x1p500;
  for_each_point(edges, group, [&](const Point& p) {
    const double along = frame::turned_along(p.x, p.y, axis.x, axis.y);
    const double across = frame::turned_across(p.x, p.y, axis.x, axis.y);
    least_along = std::min(least_along, along), most_along = std::max(most_along, along);
    least_across = std::min(least_across, across), most_across = std::max(most_across, across);
  });
  const double along = (least_along + most_along) / 2, across = (least_across + most_across) / 2;
  return {frame::turned_along(along, across, axis.x, -axis.y),
          frame::turned_across(along, across, axis.x, -axis.y),
          axis.x,
          axis.y,
          (most_along - least_along) / 2 + bounds::kBoxRounding,
          (most_across - least_across) / 2 + bounds::kBoxRounding};
}

Point farthest(std::span<const Edge> edges, std::span<const std::uint32_t> group, Point to_center) {
  Point result = to_center;
  double most = 0;
  for_each_point(edges, group, [&](const Point& p) {
    const double squared = (p.x - to_center.x) * (p.x - to_center.x) + (p.y - to_center.y) * (p.y - to_center.y);
    if (squared > most) most = squared, result = p;
  });
  return result;
}

/// Returns the smallest of three boxes: upright, along two points far from each other, or along the longest edge.
Box box(std::span<const Edge> edges, std::span<const std::uint32_t> group) {
  Box smallest = box_along(edges, group, {1, 0});
  const auto compare = [&](Point axis) {
    const Box turned = box_along(edges, group, axis);
    if (turned.area() < smallest.area()) smallest = turned;
  };
  const Point a = farthest(edges, group, {edges[group[0]].start_x, edges[group[0]].start_y});
  const Point b = farthest(edges, group, a);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length >= 0x1p-40) compare({(b.x - a.x) / length, (b.y - a.y) / length});
  const Edge& longest = edges[*std::ranges::max_element(group, {}, [&](std::uint32_t i) { return edges[i].length; })];
  compare({longest.direction_x, longest.direction_y});
  return smallest;
}

/// A segment as a point in four dimensions: its middle, and a quarter of its length at twice its angle. Two such points
/// are near each other if all of one segment is near the other, whatever their orientation.
using SegmentPoint = std::array<double, 4>;

SegmentPoint segment_point(const Edge& e) {
  return {(e.start_x + e.end_x) / 2, (e.start_y + e.end_y) / 2,
          e.length / 4 * (e.direction_x * e.direction_x - e.direction_y * e.direction_y),
          e.length / 2 * e.direction_x * e.direction_y};
}

/// Returns the dimension in which the segments of a group are scattered most.
std::size_t widest_dimension(std::span<const SegmentPoint> points, std::span<const std::uint32_t> group) {
  SegmentPoint sum{}, squares{};
  const SegmentPoint& origin = points[group[0]];
  for (const std::uint32_t i : group)
    for (std::size_t k = 0; k < sum.size(); ++k) {
      const double away = points[i][k] - origin[k];
      sum[k] += away, squares[k] += away * away;
    }
  for (std::size_t k = 0; k < sum.size(); ++k) squares[k] -= sum[k] * sum[k] / static_cast<double>(group.size());
  return static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
}

/// Returns the ends of two groups combined: those that only one of the groups has, ordered by y like the input.
std::vector<End> joined(const std::vector<End>& a, const std::vector<End>& b) {
  std::vector<End> result;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
  return result;
}

}  // namespace

EdgeTree::Leaf::Leaf(std::span<const Edge> edges, std::span<const std::uint32_t> numbers)
    : count(static_cast<std::uint32_t>(numbers.size())) {
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    edge[lane] = numbers[std::min(lane, numbers.size() - 1)];
    Edge stored = edges[edge[lane]];
    if (lane >= numbers.size()) stored = {stored.end_x, stored.end_y, stored.end_x, stored.end_y, 1, 0, 0};
    start_x[lane] = stored.start_x, start_y[lane] = stored.start_y;
    end_x[lane] = stored.end_x, end_y[lane] = stored.end_y;
    direction_x[lane] = stored.direction_x, direction_y[lane] = stored.direction_y;
    length[lane] = stored.length;
  }
}

class EdgeTree::Builder {
 public:
  Builder(std::span<const Edge> edges, std::span<const std::size_t> loop_ends, EdgeTree& tree)
      : edges_(edges), next_(edges.size()), tree_(tree) {
    for (const Edge& edge : edges) points_.push_back(segment_point(edge));
    std::iota(next_.begin(), next_.end(), 1U);
    std::size_t begin = 0;
    for (const std::size_t end : loop_ends) {
      next_[end - 1] = static_cast<std::uint32_t>(begin);
      begin = end;
    }
  }

  void build() {
    std::vector<std::uint32_t> numbers(edges_.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    node({numbers, box(edges_, numbers)});
  }

 private:
  struct Part {
    std::span<std::uint32_t> group;
    Box box;
  };
  /// The node or leaf built from a group.
  struct Subtree {
    std::int32_t child;
    std::vector<End> ends;
  };

  // On each level a walk keeps all children but one open, and each level halves the number of leaves at least once.
  static_assert(kStackSize >= (kWidth - 1) * std::bit_width(kMostEdges / kWidth) + 1);

  /// Splits a group into two halves of whole leaves, the first at least as large as the second: along the loops, if
  /// that separates them in the plane; else, as in a spiral, by position and direction of the segments.
  [[nodiscard]] std::array<Part, 2> halves(const Part& whole) const {
    const std::size_t leaves = (whole.group.size() + kWidth - 1) / kWidth, middle = (leaves + 1) / 2 * kWidth;
    const auto first = whole.group.first(middle), second = whole.group.subspan(middle);
    const auto halves_by = [&](const auto& before) {
      std::nth_element(first.begin(), first.end(), second.end(), before);
      return std::array{Part{first, box(edges_, first)}, Part{second, box(edges_, second)}};
    };
    const auto as_they_run = halves_by(std::less());
    constexpr double kParted = 1.05;
    if (as_they_run[0].box.area() + as_they_run[1].box.area() <= kParted * whole.box.area()) return as_they_run;
    const std::size_t k = widest_dimension(points_, whole.group);
    return halves_by(
        [&](std::uint32_t a, std::uint32_t b) { return std::pair(points_[a][k], a) < std::pair(points_[b][k], b); });
  }

  [[nodiscard]] std::vector<Part> quarters(const Part& whole) const {
    if (whole.group.size() <= kWidth) return {whole};
    std::vector<Part> result;
    for (const Part& half : halves(whole)) {
      if (half.group.size() <= kWidth) {
        result.push_back(half);
      } else {
        const auto parts = halves(half);
        result.insert(result.end(), parts.begin(), parts.end());
      }
    }
    return result;
  }

  Subtree subtree(const Part& part) {
    if (part.group.size() > kWidth) return node(part);
    tree_.leaves_.emplace_back(edges_, part.group);
    std::vector<End> ends;
    for (const std::uint32_t i : part.group) {
      const End start{edges_[i].start_y, i}, end{edges_[i].end_y, next_[i]};
      ends = joined(ends, {std::min(start, end), std::max(start, end)});
    }
    return {~static_cast<std::int32_t>(tree_.leaves_.size() - 1), std::move(ends)};
  }

  Subtree node(const Part& whole) {
    Node node{};
    std::vector<End> ends;
    const std::vector<Part> parts = quarters(whole);
    for (std::size_t i = 0; i < kWidth; ++i) {
      const bool here = i < parts.size();
      const Box b = here ? parts[i].box : Box{};
      node.center_x[i] = b.center_x, node.center_y[i] = b.center_y;
      node.axis_x[i] = b.axis_x, node.axis_y[i] = b.axis_y;
      node.half_along[i] = b.half_along, node.half_across[i] = b.half_across;
      if (!here) continue;
      const Subtree below = subtree(parts[i]);
      node.child[i] = below.child;
      if (below.ends.empty()) continue;
      node.lowest_end[i] = below.ends.front().y, node.highest_end[i] = below.ends.back().y;
      node.ends[i] = static_cast<std::uint32_t>(tree_.ends_.size());
      node.end_count[i] = static_cast<std::uint32_t>(below.ends.size());
      if (below.ends.size() > 2) node.with_more_ends |= 1U << i;
      tree_.ends_.insert(tree_.ends_.end(), below.ends.begin(), below.ends.end());
      ends = joined(ends, below.ends);
    }
    tree_.nodes_.push_back(node);
    return {static_cast<std::int32_t>(tree_.nodes_.size() - 1), std::move(ends)};
  }

  std::span<const Edge> edges_;
  std::vector<SegmentPoint> points_;
  std::vector<std::uint32_t> next_;
  EdgeTree& tree_;
};

EdgeTree::EdgeTree(std::span<const Edge> edges, std::span<const std::size_t> loop_ends) {
  assert(edges.size() <= kMostEdges);  // else the numbers of ends may not fit
  Builder(edges, loop_ends, *this).build();
}

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

}  // namespace touchstone::filtered::detail
