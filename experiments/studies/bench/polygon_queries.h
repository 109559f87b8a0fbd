// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/workload.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench/families.h"
#include "geometry/contact/fast.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {

/// The distance of vertices from the plane in which their outline was drawn, each to a random side along the dropped
/// axis.
struct OffPlane {
  std::string name;  ///< such as `2^20 ulps`: units in the last place of the polygon's size
  double share;      ///< of the size; 0 is exactly planar
};

[[nodiscard]] const std::vector<OffPlane>& all_off_plane();

/// Returns the outlines that can have `vertices` vertices: star, comb, spiral, and random-simple up to
/// kMostRandomSimple vertices, koch beyond.
[[nodiscard]] std::vector<workloads::Family> outlines_of(std::size_t vertices);

/// Draws polygon number `index` of these, exactly planar: on an integer lattice in an integer frame. A function of its
/// arguments alone, as are the functions below; `exact::validate` accepts it. Throws std::invalid_argument if none was
/// found.
[[nodiscard]] Polygon draw_polygon(workloads::Family outline, std::size_t vertices, std::uint64_t seed,
                                   std::uint64_t index);
/// Draws several where they are small, so that no single one decides.
[[nodiscard]] std::vector<Polygon> draw_polygons(workloads::Family outline, std::size_t vertices, std::uint64_t seed);
[[nodiscard]] std::vector<Polygon> draw_polygons_of_all_outlines(std::size_t vertices, std::uint64_t seed);
/// Returns the same polygon with its vertices off the plane; also accepted by `exact::validate`. Requires a polygon
/// without holes.
[[nodiscard]] Polygon move_off_plane(const Polygon& polygon, const OffPlane& off_plane, std::uint64_t seed,
                                     std::uint64_t index);

struct PolygonQuery {
  Ball ball;
  std::uint32_t polygon;
};

/// Draws small balls near each of the polygons in turn. The foot of ball number `index` is uniform in the bounding box
/// of the vertices (as seen along the dropped axis), its radius is (0.05 to 0.15) x size / sqrt(n), and its height is
/// at most the radius, so that it always meets the plane.
[[nodiscard]] std::vector<PolygonQuery> draw_balls(const std::vector<Polygon>& polygons, std::uint64_t seed,
                                                   std::uint64_t count);

struct PolygonMotion {
  Motion motion;
  std::uint32_t polygon;
};

/// Draws motions that pass through the places of these balls in any direction, on ways of up to the polygon's size.
[[nodiscard]] std::vector<PolygonMotion> draw_motions(const std::vector<Polygon>& polygons, std::uint64_t seed,
                                                      std::uint64_t count);

// Benchmarks of questions about prepared polygons. A query has two members: a ball or a motion, and the number of its
// polygon.

template <class Prepared>
using Polygons = std::shared_ptr<const std::vector<Prepared>>;
template <class Query>
using Queries = std::shared_ptr<const std::vector<Query>>;

template <class Prepared>
Polygons<Prepared> prepare(const std::vector<Polygon>& polygons) {
  std::vector<Prepared> list;
  for (const Polygon& polygon : polygons) list.emplace_back(polygon);
  return std::make_shared<const std::vector<Prepared>>(std::move(list));
}

/// Returns the number of queries for which exact takes about a second.
inline std::size_t checked(const Settings& settings, std::size_t vertices) {
  if (!settings.checks) return 0;
  return std::min<std::size_t>(settings.samples, std::clamp<std::size_t>(200'000 / vertices, 8, 5000));
}

/// Asks question(ball or motion, prepared polygon).
template <class Question, class Query, class Prepared>
auto answer_to(const Question& question, const Query& query, const std::vector<Prepared>& polygons) {
  const auto& [asked, polygon] = query;
  return question(asked, polygons[polygon]);
}

/// Returns the answers of `exact` to the first `count` queries.
template <class Question, class Query>
auto truths(const Question& question, const std::vector<Polygon>& polygons, const Queries<Query>& queries,
            std::size_t count) {
  using Truth = decltype(answer_to(question, queries->front(), std::vector<exact::PreparedPolygon>()));
  std::vector<Truth> list;
  if (count > 0) {
    const auto prepared = prepare<exact::PreparedPolygon>(polygons);
    for (std::size_t i = 0; i < count; ++i) list.push_back(answer_to(question, (*queries)[i], *prepared));
  }
  return std::make_shared<const std::vector<Truth>>(std::move(list));
}

template <class Prepared, class Query, class Question, class Truths>
timing::Candidate asks(std::string name, const Polygons<Prepared>& polygons, const Queries<Query>& queries,
                       const Truths& truths, const Question& question,
                       std::optional<timing::Comparison> comparison = std::nullopt) {
  return candidate(
      std::move(name), queries, truths,
      [polygons, question](const Query& query) { return answer_to(question, query, *polygons); },
      std::move(comparison));
}

/// One question about the same polygons, to fast and to filtered; with `least` also to exact, whose goal is that many
/// times the cost of filtered.
template <class Query, class Question>
timing::Benchmark compare(std::string name, const std::vector<Polygon>& polygons, std::size_t vertices,
                          const Queries<Query>& queries, const Settings& settings, const Question& question,
                          std::optional<timing::Goal> goal, std::optional<timing::Goal> least = std::nullopt) {
  timing::Benchmark benchmark;
  benchmark.name = std::move(name);
  benchmark.checked = checked(settings, vertices);
  const auto truth = truths(question, polygons, queries, benchmark.checked);
  benchmark.candidates = {asks("fast", prepare<fast::PreparedPolygon<>>(polygons), queries, truth, question),
                          asks("filtered", prepare<filtered::PreparedPolygon>(polygons), queries, truth, question,
                               timing::Comparison{"fast", goal})};
  if (least)
    benchmark.candidates.push_back(asks("exact", prepare<exact::PreparedPolygon>(polygons), queries, truth, question,
                                        timing::Comparison{"filtered", least}));
  return benchmark;
}

}  // namespace touchstone::bench
