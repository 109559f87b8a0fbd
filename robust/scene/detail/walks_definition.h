// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

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

/// For polygons, which lie where they were prepared.
inline constexpr auto kFetchNothing = [](const Leaf&) {};
/// Returns whether this face settles the query, so that the walk can stop.
template <class Asked, class Face>
TOUCHSTONE_INLINE bool ends(const Asked& asked, const Face& face, NoTally tally) {
  return touches(asked, face, tally);
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

/// Returns whether a triangle of a leaf settles the query, so that the walk can stop.
template <class Triangles>
TOUCHSTONE_INLINE bool any_ends(const Triangles& triangles, const Leaf& leaf, NoTally) {
  return triangles.any_touched(leaf);
}
template <class Triangles>
bool any_ends(const Triangles& triangles, const Leaf& leaf, Tally& tally) {
  for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place) (void)ends(triangles, place, tally);
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
    return walk(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](const Leaf& leaf) { return any_ends(triangles, leaf, tally); },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query, class T>
bool touches_polygon(const Query& query, const PolygonSet& set, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  return walk(set.tree, culling, each_place([&](std::uint32_t place) {
                return ends(query, set.prepared[set.tree.order()[place]], tally);
              }),
              kFetchNothing);
}

template <class Query, class T>
void touched_triangles(const Query& query, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, query, [&](const auto& triangles) {
    walk(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](const Leaf& leaf) {
          for_touched(triangles, leaf, tally, [&](std::uint32_t place) {
            add(faces, {first.object, first.face + tree.order()[place]});
          });
          return false;
        },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class Query, class T>
void touched_polygons(const Query& query, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  walk(set.tree, culling, each_place([&](std::uint32_t place) {
         const std::uint32_t number = set.tree.order()[place];
         if (touches(query, set.prepared[number], tally)) add(faces, {first.object, first.face + number});
         return false;
       }),
       kFetchNothing);
}

/// @{
/// Returns the triangles of a leaf that the ball may touch. Walks that count ask exactly.
template <class Triangles>
TOUCHSTONE_INLINE NearLanes near(const Triangles& triangles, const Leaf& leaf, NoTally) {
  return triangles.near(leaf);
}
template <class Triangles>
NearLanes near(const Triangles& triangles, const Leaf& leaf, Tally& tally) {
  NearLanes result{0, std::numeric_limits<double>::infinity()};
  for (std::uint32_t lane = 0; lane < leaf.count; ++lane)
    if (touches(triangles, leaf.first + lane, tally)) result.lanes |= 1U << lane;
  return result;
}
/// @}

// Floats shrink the ball, then upper bounds in doubles; only triangles that it may still touch at the end are compared
// exactly.
template <class T>
void nearest_triangle(const TriangleSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.size(), set.edge_count());
  if (set.size() == 0) return;
  const BoxTree& tree = set.placed->tree;
  std::vector<Leaf> met;
  with_triangles(set, search.ball(), [&](auto triangles) {
    const auto shrink_to = [&](double bound) {
      if (!(bound < search.ball().radius)) return false;
      search.shrink(bound);
      triangles.set_radius(search.ball().radius);
      return true;
    };
    const auto shrink = [&](std::uint32_t place) {
      const double bound = triangles.distance_at_most(place);
      if (std::isfinite(bound)) return shrink_to(bound);
      search.shrink(triangles.triangle(place));
      triangles.set_radius(search.ball().radius);
      return true;
    };
    if (!search.has_shrunk()) shrink(0);
    CullingBall culling_ball(triangles.culling(), tree);
    walk_in_order(
        tree, culling_ball,
        [&](const Leaf& leaf) {
          const NearLanes here = near(triangles, leaf, tally);
          if (here.lanes == 0) return;
          met.push_back(leaf);
          bool shrunk = false;
          if (std::isfinite(here.radius))
            shrunk = shrink_to(here.radius);
          else
            for_lanes(here.lanes, leaf, [&](std::uint32_t place) { shrunk |= shrink(place); });
          if (shrunk) culling_ball.set_radius(triangles.culling().radius, tree);
        },
        [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
    std::vector<std::uint32_t> places;
    for (const Leaf& leaf : met)
      for_lanes(triangles.near(leaf).lanes, leaf, [&](std::uint32_t place) { places.push_back(place); });
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
  walk_in_order(set.tree, culling_ball, each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  if (!touches(search.ball(), set.prepared[number], tally)) return false;
                  search.meet(set.prepared[number], number);
                  culling_ball.set_radius(search.ball().radius, set.tree);
                  return false;
                }),
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
    walk_in_order(tree, culling, each_place([&](std::uint32_t place) {
                    count(triangles, place, tally);
                    const std::uint32_t number = tree.order()[place];
                    if (!search.is_at_start())
                      triangles.meet(place, number, search);
                    else if (search.is_lower(number) && triangles.touches_at_start(place))
                      search.start(triangles.triangle(place), number);
                    shorten();
                    return false;
                  }),
                  [&](const Leaf& leaf) { triangles.prefetch_leaf(leaf); });
  });
}

template <class T>
void first_polygon(const PolygonSet& set, FirstContactSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const Motion& motion = search.motion();
  CullingMotion culling(motion, set.tree);
  if (search.end() < 1) culling.end_at(search.end());
  walk_in_order(set.tree, culling, each_place([&](std::uint32_t place) {
                  const std::uint32_t number = set.tree.order()[place];
                  const filtered::PreparedPolygon& polygon = set.prepared[number];
                  count(motion, polygon, tally);
                  if (!search.is_at_start())
                    search.meet(polygon, number, filtered::first_contact(motion, polygon));
                  else if (search.is_lower(number) && filtered::contact(motion.ball, polygon))
                    search.start(polygon, number);
                  culling.end_at(search.end());
                  return false;
                }),
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
