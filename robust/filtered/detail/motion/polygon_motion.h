// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "robust/exact/motion.h"
#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/motion/polygon_events.h"
#include "robust/filtered/detail/motion/touched_point.h"
#include "robust/filtered/detail/polygon/polygon_query.h"

/// All stages for a moving ball and a prepared polygon.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// Calls visit(leaf) for all leaves with edges that the swept disc may touch. The visitor may shorten the disc's way.
template <class Visit>
TOUCHSTONE_INLINE void walk(const EdgeIndex& index, const SweptDisc& disc, const Visit& visit) {
  const auto visit_near = [&](const EdgeTree::Leaf& leaf) {
    const Pack half = all_lanes(0.5), half_length = half * load(leaf.length);
    const Pack center_x = half * (load(leaf.start_x) + load(leaf.end_x));
    const Pack center_y = half * (load(leaf.start_y) + load(leaf.end_y));
    const unsigned far =
        disc.misses(center_x, center_y, load(leaf.direction_x), load(leaf.direction_y), half_length, all_lanes(0));
    const unsigned lanes = (1U << leaf.count) - 1;
    if ((lanes & ~far) != 0) visit(leaf, lanes & ~far);
  };
  if (index.is_scanned()) {
    for (const EdgeTree::Leaf& leaf : index.leaves()) visit_near(leaf);
    return;
  }
  const EdgeTree& tree = index.tree();
  std::int32_t stack[EdgeTree::kStackSize];
  std::size_t open = 0;
  stack[open++] = tree.root();
  while (open > 0) {
    const std::int32_t number = stack[--open];
    if (number < 0) {
      const std::int32_t leaf = ~number;
      visit_near(tree.leaves()[static_cast<std::size_t>(leaf)]);
      continue;
    }
    const EdgeTree::Node& node = tree.nodes()[static_cast<std::size_t>(number)];
    const unsigned far = disc.misses(load(node.center_x), load(node.center_y), load(node.axis_x), load(node.axis_y),
                                     load(node.half_along), load(node.half_across));
    for (unsigned lane = EdgeTree::kWidth; lane-- > 0;)
      if ((far >> lane & 1) == 0) stack[open++] = node.child[lane];
  }
}

/// Returns at least the error of a foot's coordinates: how far it moves while its time is unknown, and the errors of
/// its way.
template <class N>
TOUCHSTONE_INLINE N error_of_foot(const N& speed_x, const N& speed_y, const N& time_error, const N& velocity_error,
                                  const N& point_error) {
  return ((speed_x + speed_y) * time_error + velocity_error + point_error) * constant<N>(bounds::kWide);
}

/// The knowledge of doubles about a motion that does not touch at its start.
struct FrameMotionResult {
  FilterResult contact;
  std::optional<Feature> feature;  ///< the feature touched first, if it is certain
};

/// Returns whether the ball meets the face's interior at the time at which it reaches the plane.
TOUCHSTONE_INLINE FilterResult meets_face(const FrameMotion& motion, const Entry<Pack>& plane, const EdgeIndex& edges) {
  if ((plane.none & 1) != 0) return FilterResult::No;
  if ((plane.certain & 1) == 0) return FilterResult::Unsure;
  double time[kLanes], error[kLanes];
  store(time, plane.time.value), store(error, plane.time.error);
  const double foot_error = error_of_foot(std::abs(motion.velocity.x), std::abs(motion.velocity.y), error[0],
                                          motion.velocity_error, motion.point_error);
  const FrameQuery query(motion.x + time[0] * motion.velocity.x, motion.y + time[0] * motion.velocity.y, motion.size,
                         foot_error);
  bool near_boundary = false;
  const bool inside = walk(edges, query, query.boundary_sq, [&](const EdgeTree::Leaf& leaf, const LeafView& view) {
    const unsigned near = ~negative_lanes(all_lanes(query.boundary_sq) - view.squared);
    return near_boundary = (near & ((1U << leaf.count) - 1)) != 0;
  });
  if (near_boundary) return FilterResult::Unsure;
  return inside ? FilterResult::Yes : FilterResult::No;
}

/// Looks for the first contact in doubles. Looks for any contact if `any`.
template <bool any>
FrameMotionResult frame_motion_filter(const FrameMotion& motion, const Entry<Pack>& plane, const EdgeIndex& edges) {
  const FilterResult face = meets_face(motion, plane, edges);
  if (face == FilterResult::Yes) return {FilterResult::Yes, Feature{Feature::Kind::Face, 0}};
  bool unsure = face == FilterResult::Unsure;
  FirstCandidate<double> first;
  SweptDisc disc(motion);
  walk(edges, disc, [&](const EdgeTree::Leaf& leaf, unsigned near) {
    if (any && first.any()) return;
    const MovingEdge<Pack> moving = moving_edges(leaf, motion);
    const auto consider = [&](Feature::Kind kind, const Entry<Pack>& event) {
      unsure = unsure || event.unsure(near) != 0;
      unsigned happening = event.certain & near;
      if (happening == 0) return;
      double time[kLanes], error[kLanes];
      store(time, event.time.value), store(error, event.time.error);
      for (; happening != 0; happening &= happening - 1) {
        const int lane = __builtin_ctz(happening);
        first.add({kind, leaf.edge[lane]}, time[lane], error[lane]);
      }
      if constexpr (!any) disc.end_at(first.latest());
    };
    consider(Feature::Kind::Edge, interior_event(moving));
    consider(Feature::Kind::Vertex, start_event(moving));
  });
  const FilterResult known = first.known<any>(unsure);
  if (known != FilterResult::Yes) return {known, {}};
  return {known, first.feature()};
}

/// Looks for the first event of an edge or a vertex in double-doubles. Looks for any event if `any`.
template <bool any, class Counts>
FilterResult doubles_filter(const FrameMotion& in_frame, const EdgeIndex& edges,
                            const PolygonMotionDoubles<Counts>& doubles, FirstCandidate<DoubleDouble>& first) {
  bool unsure = false;
  SweptDisc disc(in_frame);
  walk(edges, disc, [&](const EdgeTree::Leaf& leaf, unsigned near) {
    if (any ? first.any() : unsure) return;
    const MovingEdge<Pack> in_lanes = moving_edges(leaf, in_frame);
    const unsigned interiors = near & ~interior_event(in_lanes).none, starts = near & ~start_event(in_lanes).none;
    for (unsigned possible = interiors | starts; possible != 0; possible &= possible - 1) {
      const int lane = __builtin_ctz(possible);
      const std::size_t edge = leaf.edge[lane];
      const MovingEdge<DoubleDouble> moving = doubles.moving(edge);
      const auto consider = [&](Feature::Kind kind, const Entry<DoubleDouble>& event) {
        unsure = unsure || event.unsure(1) != 0;
        if ((event.certain & 1) != 0) first.add({kind, edge}, event.time.value, event.time.error);
      };
      if ((interiors >> lane & 1) != 0) consider(Feature::Kind::Edge, interior_event(moving));
      if ((starts >> lane & 1) != 0) consider(Feature::Kind::Vertex, start_event(moving));
    }
    disc.end_at(first.latest());
  });
  return first.known<any>(unsure);
}

/// The knowledge of the first stage about a motion that may touch.
struct FirstStage {
  int start = 0;                     ///< the certain sign of the distance less r at the start
  std::optional<Feature> feature{};  ///< touched first on the way, if it is certain
};

/// Returns whether the ball touches at its start, which the first stage may know.
template <class Counts>
bool touches_at_start(const Motion& motion, const PreparedPolygon::Parts& parts, const FirstStage& known,
                      Counts& counts) {
  if (known.start == 0) return contact(motion.ball, parts, counts);
  counts.count(Stage::Double);
  return known.start < 0;
}

/// Returns the first contact in double-doubles, given that the ball does not touch at its start; nothing if it is not
/// certain.
template <class Counts>
std::optional<FirstContact> first_contact_in_doubles(const Motion& motion, const FrameMotion& in_frame,
                                                     const PreparedPolygon::Parts& parts,
                                                     const std::optional<Feature>& feature, Counts& counts) {
  if (!feature && meets_face(in_frame, in_frame.plane().entry, *parts.edges) != FilterResult::No) return std::nullopt;
  const PolygonMotionDoubles<Counts> doubles(motion, parts, counts);
  if (!doubles.usable()) return std::nullopt;
  if (feature) return TouchedPoint(doubles, *feature, event_time(doubles, *feature)).rounded_contact();
  FirstCandidate<DoubleDouble> first;
  switch (doubles_filter<false>(in_frame, *parts.edges, doubles, first)) {
    case FilterResult::Yes:
      return TouchedPoint(doubles, first.feature(), {first.time(), first.error()}).rounded_contact();
    case FilterResult::No: return FirstContact{};
    default: return std::nullopt;
  }
}

/// Returns the first contact where the first stage does not suffice. `in_frame` is null if the motion is out of the
/// frame's range.
template <class Counts>
__attribute__((noinline)) FirstContact later_first_contact(const Motion& motion, const PreparedPolygon::Parts& parts,
                                                           const FrameMotion* in_frame, const FirstStage& known,
                                                           Counts& counts) {
  const FloatingPointState nearest;
  if (touches_at_start(motion, parts, known, counts)) {
    const Answer start =
        ask<&PolygonQuery<Counts>::answer,
            static_cast<Answer (*)(const Ball&, const exact::PreparedPolygon&)>(exact::answer), Answer>(motion.ball,
                                                                                                        parts, counts);
    return {FirstContactKind::Start, 0, false, start.nearest, start.point, start.contact_normal, start.depth};
  }
  if (motion.at_rest()) return {};
  if (in_frame != nullptr) {
    if (const auto found = first_contact_in_doubles(motion, *in_frame, parts, known.feature, counts)) {
      counts.count(Stage::DoubleDouble);
      return *found;
    }
  }
  counts.count(Stage::BigInteger);
  return exact::first_contact(motion, parts.exact());
}

/// Returns whether there is contact on the way, in double-doubles.
template <class Counts>
FilterResult contact_in_doubles(const Motion& motion, const FrameMotion& in_frame, const PreparedPolygon::Parts& parts,
                                Counts& counts) {
  const PolygonMotionDoubles<Counts> doubles(motion, parts, counts);
  if (!doubles.usable()) return FilterResult::Unsure;
  FirstCandidate<DoubleDouble> first;
  const FilterResult boundary = doubles_filter<true>(in_frame, *parts.edges, doubles, first);
  if (boundary != FilterResult::No) return boundary;
  return meets_face(in_frame, in_frame.plane().entry, *parts.edges);
}

/// Returns whether the ball touches where the first stage does not suffice. `in_frame` as above.
template <class Counts>
__attribute__((noinline)) bool later_motion_contact(const Motion& motion, const PreparedPolygon::Parts& parts,
                                                    const FrameMotion* in_frame, const FirstStage& known,
                                                    Counts& counts) {
  const FloatingPointState nearest;
  if (touches_at_start(motion, parts, known, counts)) return true;
  if (motion.at_rest()) return false;
  if (in_frame != nullptr) {
    const FilterResult result = contact_in_doubles(motion, *in_frame, parts, counts);
    if (result < FilterResult::Unsure) {
      counts.count(Stage::DoubleDouble);
      return result == FilterResult::Yes;
    }
  }
  counts.count(Stage::BigInteger);
  return exact::contact(motion, parts.exact());
}

/// Returns whether the first stage may answer in the caller's floating-point state, and the motion in the frame if so.
TOUCHSTONE_INLINE std::optional<FrameMotion> frame_motion(const Motion& motion, const PreparedPolygon::Parts& parts) {
  if (!frame_reaches_at_once(motion.ball, parts) || !frame_reaches({motion.to, 0}, parts)) return std::nullopt;
  const FrameMotion in_frame(motion, *parts.frame);
  if (!in_frame.in_range()) return std::nullopt;
  return in_frame;
}

template <class Counts>
void polygon_first_contact(const Motion& motion, const PreparedPolygon::Parts& parts, FirstContact& result,
                           Counts& counts) {
  const auto in_frame = frame_motion(motion, parts);
  FirstStage known;
  if (in_frame) [[likely]] {
    const PlaneEntry<Pack> plane = in_frame->plane();
    FilterResult contact = FilterResult::No;
    if ((plane.misses & 1) == 0) {
      known.start = certain_distance_sign(in_frame->start, *parts.frame, *parts.edges);
      contact = FilterResult::Unsure;
      if (known.start > 0) {
        const FrameMotionResult way = frame_motion_filter<false>(*in_frame, plane.entry, *parts.edges);
        contact = way.contact, known.feature = way.feature;
      }
    }
    if (contact == FilterResult::No) {
      counts.count(Stage::Double);
      result = {};
      return;
    }
  }
  result = later_first_contact(motion, parts, in_frame ? &*in_frame : nullptr, known, counts);
}

template <class Counts>
bool polygon_motion_contact(const Motion& motion, const PreparedPolygon::Parts& parts, Counts& counts) {
  const auto in_frame = frame_motion(motion, parts);
  FirstStage known;
  if (in_frame) [[likely]] {
    const PlaneEntry<Pack> plane = in_frame->plane();
    FilterResult contact = FilterResult::No;
    if ((plane.misses & 1) == 0) {
      known.start = certain_distance_sign(in_frame->start, *parts.frame, *parts.edges);
      contact = known.start < 0   ? FilterResult::Yes
                : known.start > 0 ? frame_motion_filter<true>(*in_frame, plane.entry, *parts.edges).contact
                                  : FilterResult::Unsure;
    }
    if (contact < FilterResult::Unsure) [[likely]] {
      counts.count(Stage::Double);
      return contact == FilterResult::Yes;
    }
  }
  return later_motion_contact(motion, parts, in_frame ? &*in_frame : nullptr, known, counts);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
