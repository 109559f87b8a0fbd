// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "robust/filtered/motion.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/crossed_triangles.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/detail/culling_ray.h"
#include "robust/scene/detail/tree_walk.h"
#include "robust/scene/detail/triangles_on_way.h"
#include "robust/scene/detail/walks.h"

/// The walks of one ball or motion through an object.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The classes with which a ball or a motion asks.
template <class Query>
struct Asking;
template <>
struct Asking<Ball> {
  using Culling = CullingBall;
  using Standing = StandingTriangles;
  using InOwnFrame = TrianglesInOwnFrame;
};
template <>
struct Asking<Motion> {
  using Culling = CullingMotion;
  using Standing = StandingTrianglesOnWay;
  using InOwnFrame = TrianglesInOwnFrameOnWay;
};

/// Adds a face to those that are touched. The first makes room for more.
TOUCHSTONE_INLINE void add(std::vector<FaceId>& faces, FaceId face) {
  constexpr std::size_t kFew = 16;
  if (faces.capacity() == 0) faces.reserve(kFew);
  faces.push_back(face);
}

/// For triangles, of whose leaves floats decide several at once.
inline constexpr std::size_t kLeavesAtOnce = 8;
/// For polygons, which lie where they were prepared.
inline constexpr auto kFetchNothing = [](const Leaf&) {};
/// Returns a visit of several leaves that visits each alone.
template <class Visit>
TOUCHSTONE_INLINE auto each_leaf(const Visit& visit) {
  return [visit](std::span<const Leaf> leaves) {
    for (const Leaf& leaf : leaves)
      if (visit(leaf)) return true;
    return false;
  };
}

/// Returns a visit of leaves that visits each place alone.
template <class Visit>
TOUCHSTONE_INLINE auto each_place(const Visit& visit) {
  return [visit](const Leaf& leaf) {
    for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place)
      if (visit(place)) return true;
    return false;
  };
}

/// Calls f(triangles) with the triangles of the set, as the ball or motion asks about them.
template <class Query, class F>
TOUCHSTONE_INLINE auto with_triangles(const TriangleSet& set, const Query& query, const F& f) {
  return set.frame ? f(typename Asking<Query>::InOwnFrame(set, query))
                   : f(typename Asking<Query>::Standing(set, query));
}

template <class Query>
bool touches_triangle(const Query& query, const TriangleSet& set) {
  const BoxTree& tree = set.placed->tree;
  return with_triangles(set, query, [&](const auto& triangles) {
    return walk<1>(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](std::span<const Leaf> leaves) { return triangles.any_touched(leaves); },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query>
bool touches_polygon(const Query& query, const PolygonSet& set) {
  const typename Asking<Query>::Culling culling(query, set.tree);
  return walk<1>(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
                   return filtered::contact(query, set.prepared[set.tree.order()[place]]);
                 })),
                 kFetchNothing);
}

template <class Query>
void touched_triangles(const Query& query, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces) {
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, query, [&](const auto& triangles) {
    walk<kLeavesAtOnce>(tree, typename Asking<Query>::Culling(triangles.culling(), tree),
                        each_leaf([&](const Leaf& leaf) {
                          triangles.for_touched(leaf, [&](std::uint32_t place) {
                            add(faces, {first.object, first.face + tree.order()[place]});
                          });
                          return false;
                        }),
                        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query>
void touched_polygons(const Query& query, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces) {
  const typename Asking<Query>::Culling culling(query, set.tree);
  walk<1>(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
            const std::uint32_t number = set.tree.order()[place];
            if (filtered::contact(query, set.prepared[number])) add(faces, {first.object, first.face + number});
            return false;
          })),
          kFetchNothing);
}

// Floats shrink the ball, then upper bounds in doubles; only triangles that it may still touch at the end are compared
// exactly.
inline void nearest_triangle(const TriangleSet& set, NearestSearch& search) {
  if (set.size() == 0) return;
  const BoxTree& tree = set.placed->tree;
  constexpr std::size_t few = 16;
  boost::container::small_vector<LeafDistances, few> met;
  with_triangles(set, search.ball(), [&](auto triangles) {
    const auto shrink_to = [&](double radius) {
      if (!(radius < search.ball().radius)) return;
      search.shrink(radius);
      triangles.set_radius(search.ball().radius);
    };
    const auto shrink = [&](std::uint32_t place) {
      const double bound = triangles.distance_at_most(place);
      if (std::isfinite(bound)) return shrink_to(bound);
      search.shrink(triangles.triangle(place));
      triangles.set_radius(search.ball().radius);
    };
    if (!search.has_shrunk()) shrink_to(triangles.reaches_all());
    if (!search.has_shrunk()) shrink(0);
    CullingBall culling_ball(triangles.culling(), tree);
    walk_in_order(
        tree, culling_ball,
        [&](std::span<const Leaf> leaves) {
          const std::size_t before = met.size();
          double least = std::numeric_limits<double>::infinity();
          for (const Leaf& leaf : leaves) {
            met.push_back(triangles.distances(leaf));
            least = std::min(least, met.back().radius());
          }
          shrink_to(triangles.radius_of(least));
          for (std::size_t i = before; i < met.size(); ++i)
            if (!met[i].known()) [[unlikely]]
              for_lanes(all_triangles(met[i].leaf()), met[i].leaf(), shrink);
          culling_ball.set_radius(triangles.culling().radius, tree);
        },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
    boost::container::small_vector<std::uint32_t, few> places;
    for (const LeafDistances& leaf : met)
      for_lanes(leaf.within(triangles.culling().radius), leaf.leaf(),
                [&](std::uint32_t place) { places.push_back(place); });
    const bool several = places.size() > 1;
    if (several)
      for (const std::uint32_t place : places) shrink(place);
    for (const std::uint32_t place : places)
      if (!several || triangles.may_touch(place)) search.meet(triangles.triangle(place), tree.order()[place]);
  });
}

inline void nearest_polygon(const PolygonSet& set, NearestSearch& search) {
  if (set.polygons.empty()) return;
  search.expect(set.prepared[0]);
  CullingBall culling_ball(search.ball(), set.tree);
  walk_in_order(set.tree, culling_ball, each_leaf(each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  if (!filtered::contact(search.ball(), set.prepared[number])) return false;
                  search.meet(set.prepared[number], number);
                  culling_ball.set_radius(search.ball().radius, set.tree);
                  return false;
                })),
                kFetchNothing);
}

inline void first_triangle(const TriangleSet& set, FirstContactSearch& search) {
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, search.motion(), [&](auto triangles) {
    CullingMotion culling(triangles.culling(), tree);
    double end = 1;
    const auto shortens = [&] {
      if (!(search.end() < end)) return false;
      end = search.end();
      triangles.end_at(end), culling.end_at(end);
      return true;
    };
    shortens();
    walk_in_order(tree, culling, each_leaf([&](const Leaf& leaf) {
                    for (LeafOnWay open = triangles.on_way(leaf); open.lanes() != 0;) {
                      const std::uint32_t place = open.take_first(), number = tree.order()[place];
                      if (!search.is_at_start())
                        triangles.meet(place, number, search);
                      else if (search.is_lower(number) && triangles.touches_at_start(place))
                        search.start(triangles.triangle(place), number);
                      if (shortens() && open.lanes() != 0) open.keep(triangles.on_way(leaf));
                    }
                    return false;
                  }),
                  [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

inline void first_polygon(const PolygonSet& set, FirstContactSearch& search) {
  const Motion& motion = search.motion();
  CullingMotion culling(motion, set.tree);
  if (search.end() < 1) culling.end_at(search.end());
  walk_in_order(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  const filtered::PreparedPolygon& polygon = set.prepared[number];
                  if (!search.is_at_start())
                    search.meet(polygon, number, filtered::first_contact(motion, polygon));
                  else if (search.is_lower(number) && filtered::contact(motion.ball, polygon))
                    search.start(polygon, number);
                  culling.end_at(search.end());
                  return false;
                })),
                kFetchNothing);
}

inline std::optional<int> crossings_of(const TriangleSet& set, const filtered::detail::AxisRay& ray) {
  const BoxTree& tree = set.placed->tree;
  CrossedTriangles triangles(*set.placed, ray);
  const bool on_triangle = walk<kLeavesAtOnce>(
      tree, CullingRay(ray, tree), [&](std::span<const Leaf> leaves) { return triangles.add(leaves); },
      [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  return on_triangle ? std::nullopt : std::optional(triangles.sum());
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
