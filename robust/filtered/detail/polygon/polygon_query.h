// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/exact.h"
#include "robust/filtered/detail/polygon/exact_edges.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/signs/closest_point.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A type of this target, so that instantiations of std::optional with it belong to this target, too.
class OwnFloatingPointState : public FloatingPointState {};

/// One query with a ball and a prepared polygon that has a frame. Starts with the frame's doubles and computes exact
/// signs where those leave a decision open.
template <class Counts>
class PolygonQuery {
 public:
  using Parts = PreparedPolygon::Parts;

  /// Requires a frame and a ball within its limits.
  PolygonQuery(const Ball& ball, const Parts& parts, Counts& counts)
      : ball_(ball), parts_(parts), counts_(counts), height_(ball, *parts.frame) {}

  [[nodiscard]] bool contact() { return counted(distance_sign<true>()) <= 0; }

  [[nodiscard]] Relation relation() { return counted(relation_uncounted()); }

  [[nodiscard]] PlaneSide plane_side() { return counted(plane_side_uncounted()); }
  [[nodiscard]] PointLocation foot() { return counted(foot_uncounted()); }
  [[nodiscard]] std::vector<std::size_t> edges_hit() { return counted(edges_hit_uncounted()); }

  [[nodiscard]] Answer answer();

 private:
  [[nodiscard]] const FrameQuery& query() {
    if (!query_) query_.emplace(height_, *parts_.frame);
    return *query_;
  }
  /// Visits edges near the foot, as `walk` does.
  template <bool nearest_first = false, class Visit>
  bool near_edges(const double& limit_sq, const Visit& visit) {
    if (seen_ != nullptr && seen_->reach(limit_sq)) return seen_->visit(visit);
    return walk<nearest_first>(*parts_.edges, query(), limit_sq, visit);
  }
  /// Returns the exact signs. The first call suspends the caller's floating-point state.
  const ExactEdges<Counts>& exact() {
    if (!exact_) begin_exact();
    return *exact_;
  }
  /// Never inlined, so that arithmetic of the first stage, in the caller's state, stays apart from that of later
  /// stages.
  __attribute__((noinline)) void begin_exact() {
    state_.emplace();
    exact_.emplace(ball_, parts_, counts_);
  }
  template <class Result>
  [[nodiscard]] Result counted(Result result) {
    if (!exact_) counts_.count(Stage::Double);
    return result;
  }

  [[nodiscard]] int plane_sign() {
    const int certain = height_.plane_sign();
    return certain != 0 ? certain : exact().template sign<SignKind::Plane>(0);
  }

  /// Returns the distance against the radius: > is +, = is 0, < is -. With `contact_only`, = and < may be any number <=
  /// 0.
  template <bool contact_only>
  [[nodiscard]] int distance_sign();

  [[nodiscard]] Relation relation_uncounted() {
    const int sign = distance_sign<false>();
    return sign > 0 ? Relation::Separate : sign == 0 ? Relation::Touching : Relation::Overlapping;
  }
  /// Returns the relation if the distance, as the nearest double, is this. Rounding keeps the order of a distance and a
  /// radius, except that they may become equal.
  [[nodiscard]] Relation relation_at(double distance) {
    if (distance == ball_.radius) return relation_uncounted();  // exact, or rounded to it
    return distance > ball_.radius ? Relation::Separate : Relation::Overlapping;
  }
  [[nodiscard]] PlaneSide plane_side_uncounted();
  [[nodiscard]] PointLocation foot_uncounted();
  [[nodiscard]] PointLocation exact_foot();
  [[nodiscard]] std::vector<std::size_t> edges_hit_uncounted();
  [[nodiscard]] Feature nearest_on_boundary();
  [[nodiscard]] Feature nearest_of_edge(std::size_t edge, double along, double length, double margin);

  /// Returns the lanes of a leaf that hold edges.
  static unsigned lanes(const EdgeTree::Leaf& leaf) { return (1U << leaf.count) - 1; }
  /// Calls f(edge) for each set bit. Stops if it returns true, and returns whether it did.
  template <class F>
  static bool any_edge(const EdgeTree::Leaf& leaf, unsigned bits, const F& f) {
    for (; bits != 0; bits &= bits - 1)
      if (f(std::size_t{leaf.edge[__builtin_ctz(bits)]})) return true;
    return false;
  }
  static unsigned below(const Pack& squared, double limit) { return negative_lanes(squared - all_lanes(limit)); }
  static unsigned not_above(const Pack& squared, double limit) { return ~negative_lanes(all_lanes(limit) - squared); }

  const Ball& ball_;
  const Parts& parts_;
  Counts& counts_;
  HeightQuery height_;
  std::optional<FrameQuery> query_;
  const SeenLeaves* seen_ = nullptr;  ///< what an answer saw before it decided anything
  std::optional<OwnFloatingPointState> state_;
  std::optional<ExactEdges<Counts>> exact_;
};

template <class Counts>
template <bool contact_only>
int PolygonQuery<Counts>::distance_sign() {
  if (height_.plane_sign() > 0) return 1;
  const EdgeIndex& index = *parts_.edges;
  const FrameQuery& query = this->query();
  const double limit_sq = maximum(query.certain_miss_sq, query.boundary_sq);
  bool hit = false, near_boundary = false, unsure = false;
  const bool inside = walk(index, query, limit_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    hit = (below(view.squared, query.certain_hit_sq) & lanes(leaf)) != 0;
    near_boundary |= (not_above(view.squared, query.boundary_sq) & lanes(leaf)) != 0;
    unsure |= (not_above(view.squared, query.certain_miss_sq) & lanes(leaf)) != 0;
    return hit;
  });
  const auto nearest_edge = [&] {
    const ExactEdges<Counts>& edges = exact();
    int nearest = 1;
    walk(index, query, limit_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
      return any_edge(leaf, not_above(view.squared, query.certain_miss_sq) & lanes(leaf), [&](std::size_t edge) {
        nearest = std::min(nearest, edges.distance_sign(edge));
        return contact_only ? nearest <= 0 : nearest < 0;
      });
    });
    return nearest;
  };
  return EdgesAndFoot{hit, near_boundary, unsure, inside}.template sign<contact_only>(
      [&] { return plane_sign(); }, nearest_edge, [&] { return exact_foot() == PointLocation::Outside; });
}

template <class Counts>
PlaneSide PolygonQuery<Counts>::plane_side_uncounted() {
  if (height_.knows_side()) return height_.side();
  if (plane_sign() <= 0) return PlaneSide::Intersects;
  if (std::abs(height_.height) > height_.height_error)
    return height_.height > 0 ? PlaneSide::InFront : PlaneSide::Behind;
  return exact().template sign<SignKind::Front>(0) > 0 ? PlaneSide::InFront : PlaneSide::Behind;
}

template <class Counts>
PointLocation PolygonQuery<Counts>::foot_uncounted() {
  const FrameQuery& query = this->query();
  bool near_boundary = false;
  const bool inside = near_edges(query.boundary_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    return near_boundary = (not_above(view.squared, query.boundary_sq) & lanes(leaf)) != 0;
  });
  if (near_boundary) return exact_foot();
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

// The ray runs along the axis that the frame shares with the projection. So above and below can be decided exactly in
// the projection, for each vertex that the frame cannot tell from the foot.
template <class Counts>
PointLocation PolygonQuery<Counts>::exact_foot() {
  const EdgeIndex& index = *parts_.edges;
  const FrameQuery& query = this->query();
  const ExactEdges<Counts>& edges = exact();
  const int axis = (parts_.frame->dropped_axis + 2) % 3;
  const double margin = frame::distance_at_least(query.boundary_sq);
  const auto above = [&](double y, std::uint32_t vertex) {
    if (std::abs(y - query.y) > margin) return y > query.y;
    return edges.template sign<SignKind::Above>(vertex, axis) < 0;
  };
  const auto odd_ends_above = [&](std::span<const EdgeTree::End> ends) {
    const auto first_unsure =
        std::ranges::partition_point(ends, [&](const auto& end) { return end.y < query.y - margin; });
    const auto first_above =
        std::partition_point(first_unsure, ends.end(), [&](const auto& end) { return end.y <= query.y + margin; });
    const auto found =
        std::count_if(first_unsure, first_above, [&](const auto& end) { return above(end.y, end.vertex); });
    return ((found + (ends.end() - first_above)) & 1) != 0;
  };

  bool inside = false;
  // Returns whether the foot lies on an edge of the leaf; else counts the edges that the ray crosses.
  const auto on_edge = [&](const EdgeTree::Leaf& leaf) {
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
      const double left = std::min(leaf.start_x[lane], leaf.end_x[lane]);
      const double right = std::max(leaf.start_x[lane], leaf.end_x[lane]);
      const double low = std::min(leaf.start_y[lane], leaf.end_y[lane]);
      const double high = std::max(leaf.start_y[lane], leaf.end_y[lane]);
      if (query.x > right + margin || query.y < low - margin || query.y > high + margin) continue;
      const std::size_t edge = leaf.edge[lane], next = parts_.polygon.next(edge);
      const bool start = above(leaf.start_y[lane], static_cast<std::uint32_t>(edge));
      const bool end = above(leaf.end_y[lane], static_cast<std::uint32_t>(next));
      if (query.x < left - margin) {
        if (start != end) inside = !inside;
        continue;
      }
      const int side = edges.template sign<SignKind::Side>(edge);
      if (side == 0) {
        if (edges.template sign<SignKind::Along>(edge) >= 0 && edges.template sign<SignKind::Beyond>(edge) <= 0)
          return true;
      } else if (start != end && (side > 0) == end) {
        inside = !inside;
      }
    }
    return false;
  };
  const auto location = [&] { return inside ? PointLocation::Inside : PointLocation::Outside; };

  if (index.is_scanned()) {
    for (const EdgeTree::Leaf& leaf : index.leaves())
      if (on_edge(leaf)) return PointLocation::Boundary;
    return location();
  }
  const EdgeTree& tree = index.tree();
  std::int32_t stack[EdgeTree::kStackSize];
  std::size_t open = 0;
  stack[open++] = tree.root();
  while (open > 0) {
    const std::int32_t number = stack[--open];
    if (number < 0) {
      if (on_edge(tree.leaves()[static_cast<std::uint32_t>(~number)])) return PointLocation::Boundary;
      continue;
    }
    const EdgeTree::Node& node = tree.nodes()[static_cast<std::size_t>(number)];
    const NodeView view(node, query);
    const unsigned far = negative_lanes(all_lanes(frame::box_reach(query.boundary_sq)) - view.squared);
    for (unsigned lane = 0; lane < EdgeTree::kWidth; ++lane) {
      if ((far >> lane & 1) == 0)
        stack[open++] = node.child[lane];
      else if ((view.right >> lane & 1) != 0 && odd_ends_above(tree.ends_of(node, lane)))
        inside = !inside;
    }
  }
  return location();
}

template <class Counts>
std::vector<std::size_t> PolygonQuery<Counts>::edges_hit_uncounted() {
  std::vector<std::size_t> hit;
  if (height_.plane_sign() > 0) return hit;
  const FrameQuery& query = this->query();
  near_edges(maximum(query.certain_miss_sq, query.boundary_sq), [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    const unsigned certain = below(view.squared, query.certain_hit_sq) & lanes(leaf);
    if (certain != 0 && hit.empty()) hit.reserve(EdgeTree::kWidth);
    any_edge(leaf, certain, [&](std::size_t edge) { return hit.push_back(edge), false; });
    return any_edge(leaf, not_above(view.squared, query.certain_miss_sq) & ~certain & lanes(leaf),
                    [&](std::size_t edge) {
                      if (exact().distance_sign(edge) <= 0) hit.push_back(edge);
                      return false;
                    });
  });
  // With a comparison of this target, so that std::sort is instantiated for this target only.
  std::sort(hit.begin(), hit.end(), [](std::size_t a, std::size_t b) { return a < b; });
  return hit;
}

/// `along`, `length`: as in LeafView. `margin`: above the error of both together.
template <class Counts>
Feature PolygonQuery<Counts>::nearest_of_edge(std::size_t edge, double along, double length, double margin) {
  const Feature start{Feature::Kind::Vertex, edge}, end{Feature::Kind::Vertex, parts_.polygon.next(edge)};
  if (along < -margin) return start;
  if (along > length + margin) return end;
  if (along <= margin && exact().template sign<SignKind::Along>(edge) <= 0) return start;
  if (along >= length - margin && exact().template sign<SignKind::Beyond>(edge) >= 0) return end;
  return {Feature::Kind::Edge, edge};
}

template <class Counts>
Feature PolygonQuery<Counts>::nearest_on_boundary() {
  const FrameQuery& query = this->query();
  double least = 0x1p500, bound = least;  // larger than any distance, and finite
  if (seen_ != nullptr) {
    least = seen_->least_sq();
    bound = maximum(least, query.boundary_sq);
  }
  near_edges<true>(bound, [&](const EdgeTree::Leaf&, const LeafView& view) {
    double squared[kLanes];
    store(squared, view.squared);
    for (const double s : squared) least = std::min(least, s);
    bound = maximum(least, query.boundary_sq);
    return false;
  });
  // Visit all edges that may be as near as the nearest. Both distances may be off, together by less than kNear errors.
  // That is also more than the errors of `along` and `length` together.
  const double margin = frame::distance_at_least(query.boundary_sq);
  const double limit_sq = maximum(frame::square_at_least(frame::distance_at_least(least), margin), query.boundary_sq);
  std::optional<Feature> nearest;
  near_edges(limit_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    unsigned near = not_above(view.squared, limit_sq) & lanes(leaf);
    if (near == 0) return false;
    double along[kLanes], length[kLanes];
    store(along, view.along);
    store(length, view.length);
    for (; near != 0; near &= near - 1) {
      const int lane = __builtin_ctz(near);
      const Feature feature = nearest_of_edge(leaf.edge[lane], along[lane], length[lane], margin);
      if (!nearest) {
        nearest = feature;
      } else if (feature != *nearest) {
        counts_.count(Stage::BigInteger);
        const int order = exact().bigint().compare_distances(ball_, feature, *nearest);
        const auto rank = [](const Feature& f) { return std::pair(f.kind == Feature::Kind::Vertex, f.index); };
        if (order < 0 || (order == 0 && rank(feature) < rank(*nearest))) nearest = feature;
      }
    }
    return false;
  });
  return *nearest;
}

template <class Counts>
Answer PolygonQuery<Counts>::answer() {
  const ExactEdges<Counts>& edges = exact();
  const SeenLeaves seen(*parts_.edges, query());
  seen_ = &seen;
  const PointLocation place = foot_uncounted();
  const Feature feature = place == PointLocation::Inside ? Feature{Feature::Kind::Face, 0} : nearest_on_boundary();
  const ClosestPointOnFeature closest(edges, feature);
  const Eigen::Vector3d point{closest.coordinate(0), closest.coordinate(1), closest.coordinate(2)};
  const double distance = closest.distance();
  const Eigen::Vector3d contact_normal = closest.contact_normal();
  // A depth of 0 is no number that double-doubles round surely.
  std::optional<double> depth;
  if (distance != ball_.radius) depth = closest.depth();  // exact
  const Relation relation = relation_at(distance);
  if (!depth) depth = relation == Relation::Touching ? 0 : ClosestPointOnFeature(edges, feature).depth();
  return {.plane = plane_side_uncounted(),
          .plane_tangent = plane_sign() == 0,
          .foot = place,
          .edges_hit = edges_hit_uncounted(),
          .relation = relation,
          .nearest = feature,
          .point = point,
          .distance = distance,
          .off_plane = edges.bigint().off_plane(),
          .contact_normal = contact_normal,
          .depth = *depth};
}

// All stages for a ball and a prepared polygon.

/// Returns whether the ball's numbers are small enough for the polygon's frame.
TOUCHSTONE_INLINE bool frame_reaches(const Ball& ball, const PreparedPolygon::Parts& parts) {
  if (!parts.frame) return false;
  const double limit = parts.frame->reachable;
  return std::abs(ball.center[0]) <= limit && std::abs(ball.center[1]) <= limit && std::abs(ball.center[2]) <= limit &&
         ball.radius <= limit;
}

/// Answers in the frame if the ball is within its limits, else by `exact`. Never inlined, so that it returns only after
/// the caller's floating-point state is restored.
template <auto in_frame, auto otherwise, class Result, class Counts>
__attribute__((noinline)) Result ask(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (frame_reaches(ball, parts)) [[likely]] {
    // Subnormal coordinates are scaled up first, and must not be flushed to zero there.
    std::optional<OwnFloatingPointState> nearest;
    if (parts.frame->unit.exponent < Frame::kSubnormal) [[unlikely]]
      nearest.emplace();
    PolygonQuery<Counts> query(ball, parts, counts);
    return pinned((query.*in_frame)());
  }
  counts.count(Stage::BigInteger);
  return otherwise(ball, parts.exact());
}

/// Returns whether the first stage may run in the caller's floating-point state.
TOUCHSTONE_INLINE bool frame_reaches_at_once(const Ball& ball, const PreparedPolygon::Parts& parts) {
  return frame_reaches(ball, parts) && parts.frame->unit.exponent >= Frame::kSubnormal;
}

/// Returns the certain sign of the ball's distance from the polygon less the radius; 0 if the first stage is unsure.
template <class Counts>
TOUCHSTONE_INLINE int certain_sign(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (!frame_reaches_at_once(ball, parts)) return 0;
  const int sign = certain_distance_sign(HeightQuery(ball, *parts.frame), *parts.frame, *parts.edges);
  if (sign != 0) counts.count(Stage::Double);
  return sign;
}

// The first stage comes alone, without what later stages need. If it is not certain, all stages start again.
template <class Counts>
TOUCHSTONE_INLINE bool contact(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (const int sign = certain_sign(ball, parts, counts); sign != 0) [[likely]]
    return sign < 0;
  return ask<&PolygonQuery<Counts>::contact,
             static_cast<bool (*)(const Ball&, const exact::PreparedPolygon&)>(exact::contact), bool>(ball, parts,
                                                                                                      counts);
}

template <class Counts>
Relation relation(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (const int sign = certain_sign(ball, parts, counts); sign != 0) [[likely]]
    return sign < 0 ? Relation::Overlapping : Relation::Separate;
  return ask<&PolygonQuery<Counts>::relation,
             static_cast<Relation (*)(const Ball&, const exact::PreparedPolygon&)>(exact::relation), Relation>(
      ball, parts, counts);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
