// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

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
inline constexpr auto kFetchNothing = [](std::uint32_t, std::uint32_t) {};
/// Returns what fetches triangles from memory, by their first place and their number.
inline auto prefetch_of(const std::vector<Triangle>& triangles) {
  return [&triangles](std::uint32_t first, std::uint32_t count) { prefetch(&triangles[first], count); };
}

/// Returns whether this face settles the query, so that the walk can stop.
template <class Asked, class Face>
TOUCHSTONE_INLINE bool ends(const Asked& asked, const Face& face, NoTally tally) {
  return touches(asked, face, tally);
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
    return walk<false>(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](std::uint32_t place) { return ends(triangles, place, tally); }, prefetch_of(set.placed->triangles));
  });
}

template <class Query, class T>
bool touches_polygon(const Query& query, const PolygonSet& set, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  return walk<false>(
      set.tree, culling, [&](std::uint32_t place) { return ends(query, set.prepared[set.tree.order()[place]], tally); },
      kFetchNothing);
}

template <class Query, class T>
void touched_triangles(const Query& query, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, query, [&](const auto& triangles) {
    walk<false>(
        tree, typename Asking<Query>::Culling(triangles.culling(), tree),
        [&](std::uint32_t place) {
          if (touches(triangles, place, tally)) add(faces, {first.object, first.face + tree.order()[place]});
          return false;
        },
        prefetch_of(set.placed->triangles));
  });
}

template <class Query, class T>
void touched_polygons(const Query& query, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const typename Asking<Query>::Culling culling(query, set.tree);
  walk<false>(
      set.tree, culling,
      [&](std::uint32_t place) {
        const std::uint32_t number = set.tree.order()[place];
        if (touches(query, set.prepared[number], tally)) add(faces, {first.object, first.face + number});
        return false;
      },
      kFetchNothing);
}

/// Returns whether the ball may touch the triangle at a place. Walks that count ask exactly.
template <class Triangles>
TOUCHSTONE_INLINE bool may_touch(const Triangles& triangles, std::uint32_t place, NoTally) {
  return triangles.may_touch(place);
}
template <class Triangles>
bool may_touch(const Triangles& triangles, std::uint32_t place, Tally& tally) {
  return touches(triangles, place, tally);
}

// Upper bounds of distances shrink the ball; only triangles that it may still touch at the end are compared exactly.
template <class T>
void nearest_triangle(const TriangleSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.size(), set.edge_count());
  if (set.size() == 0) return;
  const BoxTree& tree = set.placed->tree;
  std::vector<std::uint32_t> met;
  with_triangles(set, search.ball(), [&](auto triangles) {
    const auto shrink = [&](std::uint32_t place) {
      const double bound = triangles.distance_at_most(place);
      if (bound >= search.ball().radius && std::isfinite(bound)) return false;
      if (std::isfinite(bound))
        search.shrink(bound);
      else
        search.shrink(triangles.triangle(place));
      triangles.set_radius(search.ball().radius);
      return true;
    };
    if (!search.has_shrunk()) shrink(0);
    CullingBall culling_ball(triangles.culling(), tree);
    walk<true>(
        tree, culling_ball,
        [&](std::uint32_t place) {
          if (!may_touch(triangles, place, tally)) return false;
          met.push_back(place);
          if (shrink(place)) culling_ball.set_radius(triangles.culling().radius, tree);
          return false;
        },
        prefetch_of(set.placed->triangles));
    for (const std::uint32_t place : met)
      if (triangles.may_touch(place)) search.meet(triangles.triangle(place), tree.order()[place]);
  });
}

template <class T>
void nearest_polygon(const PolygonSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  if (set.polygons.empty()) return;
  search.expect(set.prepared[0]);
  CullingBall culling_ball(search.ball(), set.tree);
  walk<true>(
      set.tree, culling_ball,
      [&](std::uint32_t place) {
        const std::uint32_t number = set.tree.order()[place];
        if (!touches(search.ball(), set.prepared[number], tally)) return false;
        search.meet(set.prepared[number], number);
        culling_ball.set_radius(search.ball().radius, set.tree);
        return false;
      },
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
    walk<true>(
        tree, culling,
        [&](std::uint32_t place) {
          count(triangles, place, tally);
          const std::uint32_t number = tree.order()[place];
          if (!search.is_at_start())
            triangles.meet(place, number, search);
          else if (search.is_lower(number) && triangles.touches_at_start(place))
            search.start(triangles.triangle(place), number);
          shorten();
          return false;
        },
        prefetch_of(set.placed->triangles));
  });
}

template <class T>
void first_polygon(const PolygonSet& set, FirstContactSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const Motion& motion = search.motion();
  CullingMotion culling(motion, set.tree);
  if (search.end() < 1) culling.end_at(search.end());
  walk<true>(
      set.tree, culling,
      [&](std::uint32_t place) {
        const std::uint32_t number = set.tree.order()[place];
        const filtered::PreparedPolygon& polygon = set.prepared[number];
        count(motion, polygon, tally);
        if (!search.is_at_start())
          search.meet(polygon, number, filtered::first_contact(motion, polygon));
        else if (search.is_lower(number) && filtered::contact(motion.ball, polygon))
          search.start(polygon, number);
        culling.end_at(search.end());
        return false;
      },
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
