// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <span>

#include "robust/filtered/motion.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/detail/tree_walk.h"
#include "robust/scene/detail/triangles_on_way.h"
#include "robust/scene/detail/walks.h"

namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

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

/// Returns whether the triangle at a place is touched.
template <class Triangles>
TOUCHSTONE_INLINE bool touches(const Triangles& triangles, std::uint32_t place, NoTally) {
  return triangles.touches(place);
}
template <class Triangles>
bool touches(const Triangles& triangles, std::uint32_t place, Tally& tally) {
  return touches(triangles.asked(), triangles.triangle(place), tally);
}

template <class Query>
TOUCHSTONE_INLINE bool touches(const Query& query, const filtered::PreparedPolygon& polygon, NoTally) {
  return filtered::contact(query, polygon);
}

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
/// Returns whether this face settles the query, so that the walk can stop.
template <class Asked, class Face>
TOUCHSTONE_INLINE bool ends(const Asked& asked, const Face& face, NoTally tally) {
  return touches(asked, face, tally);
}

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

/// Returns whether a triangle of some leaves settles the query, so that the walk can stop.
template <class Triangles>
TOUCHSTONE_INLINE bool any_ends(const Triangles& triangles, std::span<const Leaf> leaves, NoTally) {
  return triangles.any_touched(leaves);
}
template <class Triangles>
bool any_ends(const Triangles& triangles, std::span<const Leaf> leaves, Tally& tally) {
  for (const Leaf& leaf : leaves)
    for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place)
      (void)ends(triangles, place, tally);
  return false;
}

/// Calls f(place) for each triangle of a leaf that is touched.
template <class Triangles, class F>
TOUCHSTONE_INLINE void for_touched(const Triangles& triangles, const Leaf& leaf, NoTally, const F& f) {
  triangles.for_touched(leaf, f);
}
template <class Triangles, class F>
void for_touched(const Triangles& triangles, const Leaf& leaf, Tally& tally, const F& f) {
  for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place)
    if (touches(triangles, place, tally)) f(place);
}

/// Calls f(triangles) with the triangles of the set, as the ball or motion asks about them.
template <class Query, class F>
TOUCHSTONE_INLINE auto with_triangles(const TriangleSet& set, const Query& query, const F& f) {
  return set.frame ? f(typename Asking<Query>::InOwnFrame(set, query))
                   : f(typename Asking<Query>::Standing(set, query));
}

template <class Query, class T>
bool touches_triangle(const Query& query, const TriangleSet& set, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  return with_triangles(set, query, [&](const auto& triangles) {
    return walk<1>(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](std::span<const Leaf> leaves) { return any_ends(triangles, leaves, tally); },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query, class T>
bool touches_polygon(const Query& query, const PolygonSet& set, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  return walk<1>(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
                   return ends(query, set.prepared[set.tree.order()[place]], tally);
                 })),
                 kFetchNothing);
}

template <class Query, class T>
void touched_triangles(const Query& query, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, query, [&](const auto& triangles) {
    walk<kLeavesAtOnce>(tree, typename Asking<Query>::Culling(triangles.culling(), tree),
                        each_leaf([&](const Leaf& leaf) {
                          for_touched(triangles, leaf, tally, [&](std::uint32_t place) {
                            add(faces, {first.object, first.face + tree.order()[place]});
                          });
                          return false;
                        }),
                        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query, class T>
void touched_polygons(const Query& query, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  walk<1>(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
            const std::uint32_t number = set.tree.order()[place];
            if (touches(query, set.prepared[number], tally)) add(faces, {first.object, first.face + number});
            return false;
          })),
          kFetchNothing);
}

/// Counts the triangles of a leaf that a search for the nearest meets.
template <class Triangles>
TOUCHSTONE_INLINE void count_leaf(const Triangles&, const Leaf&, NoTally) {}
template <class Triangles>
void count_leaf(const Triangles& triangles, const Leaf& leaf, Tally& tally) {
  for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place)
    (void)touches(triangles, place, tally);
}

// Floats shrink the ball, then upper bounds in doubles; only triangles that it may still touch at the end are compared
// exactly.
template <class T>
void nearest_triangle(const TriangleSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.size(), set.edge_count());
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
            count_leaf(triangles, leaf, tally);
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

template <class T>
void nearest_polygon(const PolygonSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  if (set.polygons.empty()) return;
  search.expect(set.prepared[0]);
  CullingBall culling_ball(search.ball(), set.tree);
  walk_in_order(set.tree, culling_ball, each_leaf(each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  if (!touches(search.ball(), set.prepared[number], tally)) return false;
                  search.meet(set.prepared[number], number);
                  culling_ball.set_radius(search.ball().radius, set.tree);
                  return false;
                })),
                kFetchNothing);
}

/// @{
/// Counts a face that a search for the first contact meets.
TOUCHSTONE_INLINE void count(const Motion&, const filtered::PreparedPolygon&, NoTally) {}
template <class Triangles>
TOUCHSTONE_INLINE void count(const Triangles&, std::uint32_t, NoTally) {}
template <class Asked, class Face>
void count(const Asked& asked, const Face& face, Tally& tally) {
  (void)touches(asked, face, tally);
}
/// @}

template <class T>
void first_triangle(const TriangleSet& set, FirstContactSearch& search, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, search.motion(), [&](auto triangles) {
    CullingMotion culling(triangles.culling(), tree);
    double end = 1;
    const auto shorten = [&] {
      if (!(search.end() < end)) return;
      end = search.end();
      triangles.end_at(end), culling.end_at(end);
    };
    shorten();
    walk_in_order(tree, culling, each_leaf(each_place([&](std::uint32_t place) {
                    count(triangles, place, tally);
                    const std::uint32_t number = tree.order()[place];
                    if (!search.is_at_start())
                      triangles.meet(place, number, search);
                    else if (search.is_lower(number) && triangles.touches_at_start(place))
                      search.start(triangles.triangle(place), number);
                    shorten();
                    return false;
                  })),
                  [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class T>
void first_polygon(const PolygonSet& set, FirstContactSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const Motion& motion = search.motion();
  CullingMotion culling(motion, set.tree);
  if (search.end() < 1) culling.end_at(search.end());
  walk_in_order(set.tree, culling, each_leaf(each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  const filtered::PreparedPolygon& polygon = set.prepared[number];
                  count(motion, polygon, tally);
                  if (!search.is_at_start())
                    search.meet(polygon, number, filtered::first_contact(motion, polygon));
                  else if (search.is_lower(number) && filtered::contact(motion.ball, polygon))
                    search.start(polygon, number);
                  culling.end_at(search.end());
                  return false;
                })),
                kFetchNothing);
}

/// The walks of the target that this is compiled for.
template <class Query, class T>
inline constexpr ContactWalks<Query, T> kContactWalks{touches_triangle<Query, T>, touches_polygon<Query, T>,
                                                      touched_triangles<Query, T>, touched_polygons<Query, T>};
template <class T>
inline constexpr Walks<T> kWalks{kContactWalks<Ball, T>, kContactWalks<Motion, T>, nearest_triangle<T>,
                                 nearest_polygon<T>,     first_triangle<T>,        first_polygon<T>};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
